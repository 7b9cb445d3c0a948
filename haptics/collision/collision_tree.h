// The paper's collision tree (section 3): each node (level, j) is a segment of the wavelet
// approximation with a box aligned to it that holds the segment and every finer level over the same
// stretch. The coarsest segments of all pieces hang under a bounding hierarchy. Threads: immutable
// once built; queries are const and keep their state on the stack. No allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/frame.h"
#include "haptics/collision/touch.h"
#include "haptics/curve/curve_set.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace touchline {

/// A rectangle aligned to a segment, for tests and drawing.
struct ErrorBox {
    std::array<Position, 4> corners;  // counter-clockwise
    int piece = 0;
    int level = 0;
    int index = 0;  // of the segment at that level
};

/// A disc that moves straight from `from` to `to`.
struct Motion {
    Position from, to;
    double radius_m = 0.0;
    double level = 0.0;
    std::array<SegmentRef, 2> excluded{};  // segments that are not obstacles
};

struct Budget {
    int boxes = std::numeric_limits<int>::max();  // boxes that may be opened
    std::int64_t deadline_ns = 0;                 // of the steady clock; 0: none
};

/// First contact of a motion. Boxes that the budget left unopened count as obstacles: `clear` is
/// the share of the motion proven free of them, and a hit counts only before all of them
/// (architecture section 4, "Anytime"). `clear` never falls as the budget grows.
struct Hit {
    bool is_hit = false;
    double clear = 1.0;  // share of the motion proven free; where is_hit, that of the contact
    SegmentRef segment;  // lowest of those touched at the same moment
    Touch touch;
    int boxes = 0;  // opened
};

struct Closest {
    SegmentRef segment;  // piece -1: nothing within the distance asked
    double parameter = 0.0;
    Position point;
    double distance_m = 0.0;
    int boxes = 0;
    bool is_complete =
        true;  // false: the budget ended before every box that may hold a nearer point
};

/// Whether nothing comes near a place.
struct Clearance {
    bool is_clear = false;  // false also where the budget ended first
    int boxes = 0;          // opened
};

class CollisionTree {
  public:
    /// O(N log N).
    [[nodiscard]] static CollisionTree build(const CurveSet& curves, double radius_m);

    /// The first moment at which the disc touches a segment that it comes nearer to. A segment that
    /// the disc overlaps at the start counts as touched at the distance it has.
    [[nodiscard]] Hit first_hit(const CurveSet& curves, const Motion& motion,
                                const Budget& budget) const;

    /// The nearest point of the curves as rendered at `level`, if nearer than `within_m`; ties go
    /// to the lowest segment.
    [[nodiscard]] Closest closest_point(const CurveSet& curves, Position p, double level,
                                        double within_m, const Budget& budget = {}) const;

    /// Clear when no box of the nodes that hold the curve as rendered at `level` comes within
    /// `distance_m` of p: then no finer level and no blend does either.
    [[nodiscard]] Clearance clearance(const CurveSet& curves, Position p, double distance_m,
                                      double level, const Budget& budget) const;

    /// True when no box but those of its neighbours along the outline meets the box of the node
    /// that holds rendered segment j, both grown by the radius of build(): sliding along it needs
    /// no query, only a look at its neighbours (three each way). Valid at every level and blend.
    /// O(1).
    [[nodiscard]] bool is_alone(const CurveSet& curves, SegmentRef segment, double level) const;

    /// The boundary section for a handle (paper section 3): the nodes whose box does not hold the
    /// handle while their parent's does, and, where the boxes hold it down to `level`, the nodes of
    /// that level. Appends to `section`; for drawing and tests, not for the tick.
    void boundary_section(const CurveSet& curves, Position handle, int level,
                          std::vector<ErrorBox>& section) const;

    /// The box of a node, for drawing and tests.
    [[nodiscard]] ErrorBox box(const CurveSet& curves, int piece, int level, int j) const;

  private:
    /// Extents of a node's box along and across its segment, from the segment's first point;
    /// metres, rounded outward.
    struct Extents {
        float along_low, along_high, across_low, across_high;
    };

    /// A node of the bounding hierarchy over all coarsest segments.
    struct Bound {
        float x_low, x_high, y_low, y_high;
        std::int32_t left;  // child; right is left + 1. Negative: a leaf, root_[-left - 1]
    };

    struct Node {
        int piece, level, index;
    };

    [[nodiscard]] AlignedBox aligned_box(const CurveSet& curves, const Node& node) const;
    [[nodiscard]] std::size_t box_index(const Node& node) const;
    [[nodiscard]] static int leaf_level(const CurveSet& curves, int piece, double level);

    std::vector<std::uint32_t> first_level_;  // per piece, in first_box_
    std::vector<std::uint32_t> first_box_;    // per piece and level, in boxes_
    std::vector<Extents> boxes_;
    std::vector<bool> alone_;  // per box
    std::vector<Bound> bounds_;
    std::vector<Node> roots_;  // the coarsest segments

    friend class CollisionTreeBuilder;
    template <class Visitor>
    friend class TreeWalk;
};

}  // namespace touchline
