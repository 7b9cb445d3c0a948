// The paper's collision tree (section 3): each node (level, j) is a segment of the wavelet approximation
// with a box aligned to it that holds the segment and every finer level over the same stretch. The
// coarsest segments of all pieces hang under a bounding hierarchy.
// Threads: immutable once built; queries are const and keep their state on the stack. No allocation.
#pragma once

#include "config/types/vec2.h"
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

/// Names a segment of the curve as rendered.
struct SegmentRef {
    int piece = -1;
    int index = -1;

    friend bool operator==(const SegmentRef&, const SegmentRef&) = default;
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

/// First contact of a motion. Contract: architecture section 4, "Anytime".
struct Hit {
    bool is_hit = false;
    double clear = 1.0;   // fraction of the motion proven free; where is_hit, the fraction of the contact
    SegmentRef segment;   // lowest of those touched at the same moment
    double parameter = 0.0;  // on the segment, 0 ... 1
    Direction normal;        // from the point touched to the disc's centre
    double distance_m = 0.0;  // from the point touched to the disc's centre at contact
    int boxes = 0;            // opened
};

struct Closest {
    SegmentRef segment;  // piece -1: nothing within the distance asked
    double parameter = 0.0;
    Position point;
    double distance_m = 0.0;
    int boxes = 0;
};

class CollisionTree {
  public:
    /// O(N log N).
    [[nodiscard]] static CollisionTree build(const CurveSet& curves, double radius_m);

    /// The first moment at which the disc touches a segment that it comes nearer to. A segment that the
    /// disc overlaps at the start counts as touched at the distance it has.
    [[nodiscard]] Hit first_hit(const CurveSet& curves, const Motion& motion,
                                const Budget& budget) const;

    /// The nearest point of the curves as rendered at `level`, if nearer than `within_m`; ties go to the
    /// lowest segment.
    [[nodiscard]] Closest closest_point(const CurveSet& curves, Position p, double level,
                                        double within_m) const;

    /// True when nothing but its two neighbours comes within the disc's reach of this segment, at its
    /// whole level `level`: sliding along it then needs no query.
    [[nodiscard]] bool is_alone(int piece, int level, int j) const;

    /// The boundary section for a handle (paper section 3): the nodes whose box does not hold the
    /// handle while their parent's does, and, where the boxes hold it down to `level`, the nodes of that
    /// level. Appends to `section`; for drawing and tests, not for the tick.
    void boundary_section(const CurveSet& curves, Position handle, int level,
                          std::vector<ErrorBox>& section) const;

    /// The box of a node, for drawing and tests.
    [[nodiscard]] ErrorBox box(const CurveSet& curves, int piece, int level, int j) const;

  private:
    friend class CollisionTreeBuilder;
    friend class TreeWalk;
};

}  // namespace touchline
