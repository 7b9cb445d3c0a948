// The paper's collision tree (section 3). Each node (level, j) is a segment of the wavelet
// approximation with a box aligned to it, which holds the segment and every finer level over the
// same stretch. The coarsest segments of all pieces hang under a bounding hierarchy. Threads:
// immutable once built; queries are const and keep their state on the stack. No allocation.
#pragma once

#include "config/types/steady_clock.h"
#include "config/types/vec2.h"
#include "haptics/collision/box.h"
#include "haptics/collision/touch.h"
#include "haptics/curve/curve_set.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

// Where a walk through the collision tree starts if the motion is short: a uniform grid that says
// for every cell which stretches of about 4 mm have a box in it or half a cell beside it. A step of
// the hand is shorter than a cell, so one cell leads to all that it may meet, however many outlines
// there are; the descent from the top would cost more than all the rest.

/// Up to four neighbouring nodes of one level of a piece.
struct Stretch {
    int piece, level, first, count;
};

class StartGrid {
  public:
    /// What a way leads to, and how far it stays from everything else.
    struct Start {
        std::span<const std::int32_t> stretches;
        double margin_m;
    };

    /// A stretch with its nodes.
    struct Nodes {
        Stretch stretch;
        ReadyFan fan;
    };

    StartGrid() = default;

    /// `bounds` are those of each node of each stretch, in their order, x along and y across. For
    /// ways that reach as far as `reach_m`. O(nodes + cells).
    StartGrid(std::vector<Nodes> stretches, std::span<const Shadow> bounds, double reach_m);

    /// Returns nothing if the way leaves the grid, or what its cell answers for. O(1).
    [[nodiscard]] std::optional<Start> start_of(const Way& way) const {
        const double reach = way.reach_m * per_cell_m_;
        const double by_x = 0.5 * way.by.x * per_cell_m_;
        const double by_y = 0.5 * way.by.y * per_cell_m_;
        const double x = (way.from.x - low_.x) * per_cell_m_ + by_x;
        const double y = (way.from.y - low_.y) * per_cell_m_ + by_y;
        if (!((x >= 0.0) & (x < columns_) & (y >= 0.0) & (y < rows_))) return {};
        const int column = static_cast<int>(x);
        const int row = static_cast<int>(y);
        const double beside = 0.5 - std::abs(x - column - 0.5) - std::abs(by_x);
        const double off = 0.5 - std::abs(y - row - 0.5) - std::abs(by_y);
        const double margin = std::min(beside, off) + grown - reach;
        if (!(margin > 0.0)) return {};
        const auto cell = static_cast<std::size_t>(row * columns_ + column);
        return Start{{items_.data() + first_item_[cell],
                      static_cast<std::size_t>(first_item_[cell + 1] - first_item_[cell])},
                     margin * cell_m_};
    }

    [[nodiscard]] const Nodes& nodes(std::int32_t i) const {
        return stretches_[static_cast<std::size_t>(i)];
    }

    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    static constexpr double grown = 0.5;  // cells round a cell that it answers for

    struct Item {
        std::size_t cell;
        std::int32_t stretch;
    };

    [[nodiscard]] std::vector<Item> items_of(std::span<const Shadow> bounds) const;

    Position low_;
    double cell_m_ = 1.0;
    double per_cell_m_ = 1.0;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<Nodes> stretches_;
    std::vector<std::int32_t> first_item_;  // per cell, in items_; one more at the end
    std::vector<std::int32_t> items_;       // stretches
};

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
    double radius_m = 0.0;  // 0: a point, exactly (touch.h); else at least the contact skin
    double level = 0.0;
    std::array<SegmentRef, 2> excluded{};  // segments that are not obstacles
};

/// Nodes of one piece and level, in the order of its segments.
struct NodeRange {
    std::size_t first = 0;
    bool is_blend = false;  // each holds two rendered segments, 2j and 2j + 1, not one
};

/// A node of the hierarchy over the coarsest segments (piece -1), or a node of a piece.
struct TreeNode {
    std::int32_t piece = -1;
    std::int32_t level = 0;
    std::int32_t index = 0;
};

/// The nodes that a node splits into.
struct TreeChildren {
    std::array<TreeNode, 4> nodes{};
    int count = 0;
};

/// A motion that starts among many lines may get nowhere with less than about 128 boxes, or with a
/// deadline of under 7 us: what the query does not look at counts as an obstacle from the start.
struct Budget {
    int boxes = std::numeric_limits<int>::max();  // boxes that may be opened
    std::int64_t deadline_ns = 0;  // on the steady clock, by which to return; 0: none
    int walks = 256;               // edges that a proxy may slide along; a query needs none
};

/// Keeps a query within its budget: counts boxes; reads the clock only if a deadline is set.
class Spender {
  public:
    explicit Spender(const Budget& budget) : budget_(budget) {}

    bool spend(int boxes) {
        if (opened_ + boxes > budget_.boxes) return false;
        if (budget_.deadline_ns != 0 && steady_now_ns() >= budget_.deadline_ns) return false;
        opened_ += boxes;
        return true;
    }

    [[nodiscard]] int opened() const { return opened_; }

  private:
    Budget budget_;
    int opened_ = 0;
};

/// A flag for each node.
class NodeFlags {
  public:
    NodeFlags() = default;

    NodeFlags(std::size_t count, bool value)
        : words_(count / 64 + 2, value ? ~std::uint64_t{0} : std::uint64_t{0}) {}

    [[nodiscard]] bool operator[](std::size_t node) const {
        return (words_[node / 64] >> (node % 64) & 1U) != 0;
    }

    void clear(std::size_t node) { words_[node / 64] &= ~(std::uint64_t{1} << (node % 64)); }

    /// Returns the flags of 64 nodes, the lowest bit for `first`; those beyond the last node mean
    /// nothing.
    [[nodiscard]] std::uint64_t from(std::size_t first) const {
        const std::size_t shift = first % 64;
        const std::uint64_t low = words_[first / 64] >> shift;
        return shift == 0 ? low : low | words_[first / 64 + 1] << (64 - shift);
    }

    [[nodiscard]] std::size_t memory_bytes() const {
        return words_.capacity() * sizeof(std::uint64_t);
    }

  private:
    std::vector<std::uint64_t> words_;  // one more than the nodes need
};

/// The first contact of a motion. Boxes that the budget left unopened count as obstacles: `clear`
/// is the share of the motion proven free of them, and a hit counts only before all of them. So a
/// query is right whenever it is stopped, and `clear` never falls as the budget grows.
struct Hit {
    bool is_hit = false;
    double clear = 1.0;  // share of the motion proven free; if is_hit, the contact's
    SegmentRef segment;  // lowest of the segments touched at the same moment
    Touch touch;
    int boxes = 0;         // opened
    double spare_m = 0.0;  // without a hit: nothing comes within reach of the motion's end before
                           // it has moved on by this much, at the same level
};

/// The paper's own stop (section 3): the answer at the finest level that all candidates reached.
struct HitAtLevel {
    Hit hit;                // boxes: those opened
    double level = 0.0;     // the answer's; the level asked for if the budget sufficed
    bool is_known = false;  // false: the budget ended above the coarsest level; clear is 0
};

struct Closest {
    SegmentRef segment;  // piece -1: nothing within the distance asked for
    double parameter = 0.0;
    Position point;
    double distance_m = 0.0;
    int boxes = 0;
    bool is_complete =
        true;  // false: the budget ended before every box that may hold a nearer point
};

/// Whether nothing comes near a place.
struct Clearance {
    bool is_clear = false;  // also false if the budget ended first
    int boxes = 0;          // opened
};

class CollisionTree {
  public:
    /// O(N log N). A query takes O(boxes that it opens): log N where lines are apart, at worst N.
    [[nodiscard]] static CollisionTree build(const CurveSet& curves, double radius_m);

    /// Finds the first moment at which the disc touches a segment that it is approaching. A segment
    /// that the disc overlaps at the start counts as touched at its present distance.
    [[nodiscard]] Hit first_hit(const CurveSet& curves, const Motion& motion,
                                const Budget& budget) const;

    /// The same for a motion that starts at a segment as rendered at its level, as when a proxy
    /// lifts off: faster if it soon meets another segment along the outline.
    [[nodiscard]] Hit first_hit_from(const CurveSet& curves, const Motion& motion, SegmentRef start,
                                     const Budget& budget) const;

    /// The paper's query (section 3): refines the boxes that the motion meets level by level, and
    /// when the budget ends, answers exactly for the level that all of them reached. That level
    /// never coarsens as the budget grows. Holds at most 1024 boxes of a level.
    [[nodiscard]] HitAtLevel first_hit_at_level_reached(const CurveSet& curves,
                                                        const Motion& motion,
                                                        const Budget& budget) const;

    /// Returns the nearest point of the curves as rendered at `level`, if it is nearer than
    /// `within_m`; ties go to the lowest segment.
    [[nodiscard]] Closest closest_point(const CurveSet& curves, Position p, double level,
                                        double within_m, const Budget& budget = {}) const;

    /// Clear if no box of the nodes that hold the curve as rendered at `level` comes within
    /// `distance_m` of p: then no finer level and no blend does either.
    [[nodiscard]] Clearance clearance(const CurveSet& curves, Position p, double distance_m,
                                      double level, const Budget& budget) const;

    /// Returns the first segment, except the excluded ones, that passes over p while the level
    /// changes.
    [[nodiscard]] WallHit first_wall(const CurveSet& curves, Position p, const LevelChange& change,
                                     const std::array<SegmentRef, 2>& excluded,
                                     const Budget& budget) const;

    /// Returns the nodes that hold a piece as rendered at `level`. O(1).
    [[nodiscard]] static NodeRange nodes(const CurveSet& curves, int piece, double level);

    /// True if the node's box meets no boxes but those of its neighbours along the outline, all
    /// grown by the radius of build(). Sliding along what it holds then needs no query, only a look
    /// at its neighbours (at a fractional level three segments each way). O(1).
    [[nodiscard]] bool is_alone(std::size_t node) const { return alone_[node]; }

    /// The same for 64 nodes from `first` on, see NodeFlags::from().
    [[nodiscard]] std::uint64_t alone_from(std::size_t first) const { return alone_.from(first); }

    /// Finds the boundary section for a handle (paper section 3): the nodes whose box does not hold
    /// the handle while their parent's does, and, if the boxes hold it down to `level`, the nodes
    /// of that level. Appends to `section`; for drawing and tests, not for the tick.
    void boundary_section(const CurveSet& curves, Position handle, int level,
                          std::vector<ErrorBox>& section) const;

    /// For callers that keep a front of nodes from step to step. False without outlines: then there
    /// is no top.
    [[nodiscard]] bool has_nodes() const { return !bounds_.empty(); }

    /// Returns the top of the hierarchy.
    [[nodiscard]] static TreeNode top() { return {}; }

    /// Returns a node's children; a node of level 0 has none. O(1).
    [[nodiscard]] TreeChildren children(const CurveSet& curves, const TreeNode& node) const;

    /// Returns a box that holds a node's curve as rendered at any level up to the node's. O(1).
    [[nodiscard]] Box box_of_node(const CurveSet& curves, const TreeNode& node) const {
        if (node.piece >= 0) return node_box(curves, node);
        return bounds_[static_cast<std::size_t>(node.index)].box();
    }

    /// Returns the box of a node, for drawing and tests.
    [[nodiscard]] ErrorBox box(const CurveSet& curves, int piece, int level, int j) const;

    /// The memory that the tree adds to its curves.
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    /// A node of the bounding hierarchy over the coarsest segments, four to a leaf.
    struct Bound {
        float x_low, x_high, y_low, y_high;
        std::int32_t left;  // child; right is left + 1. Negative: a leaf, roots_[-left - 1]

        [[nodiscard]] Box box() const {
            return {{},
                    {1.0, 0.0},
                    static_cast<double>(x_low),
                    static_cast<double>(x_high),
                    static_cast<double>(y_low),
                    static_cast<double>(y_high)};
        }
    };

    [[nodiscard]] Box node_box(const CurveSet& curves, const TreeNode& node) const;

    /// Room for the points of a fan that are not contiguous.
    using FanBuffer = std::array<Position, Fan::width + 1>;

    [[nodiscard]] Fan fan(const CurveSet& curves, const Stretch& nodes, FanBuffer& buffer) const;

    std::vector<PackedExtents> extents_;  // of levels 1 ... L, in the order of the curves' points,
                                          // and three more, so that four may be read at any index
    NodeFlags alone_;                     // of all levels, in the order of the curves' points
    std::vector<Bound> bounds_;
    std::vector<Stretch> roots_;  // the coarsest segments of all pieces
    StartGrid start_grid_;
    // The coarsest level that the grid's boxes hold: a box holds no level coarser than its own.
    double start_level_ = std::numeric_limits<double>::infinity();

    friend class CollisionTreeBuilder;
    friend class Crowding;
    friend class LevelByLevel;
    template <class Visitor>
    friend class RowScan;
    template <class Visitor>
    friend class TreeWalk;
};

inline Fan CollisionTree::fan(const CurveSet& curves, const Stretch& nodes,
                              FanBuffer& buffer) const {
    const auto level = curves.points(nodes.piece, nodes.level);
    const std::size_t first_point = curves.first_point(nodes.piece, nodes.level);
    const auto first = static_cast<std::size_t>(nodes.first);
    const auto count = static_cast<std::size_t>(nodes.count);
    Fan fan{level.data() + first, nullptr, nodes.count};
    const bool wraps = first + count == level.size();
    if (wraps || first_point + first + Fan::width >= curves.point_count()) [[unlikely]] {
        for (std::size_t k = 0; k <= count; ++k) {
            buffer[k] = level[first + k == level.size() ? 0 : first + k];
        }
        fan.points = buffer.data();
    }
    if (nodes.level > 0)
        fan.extents = extents_.data() + (first_point - curves.finest_count()) + first;
    return fan;
}

inline Box CollisionTree::node_box(const CurveSet& curves, const TreeNode& node) const {
    const auto points = curves.points(node.piece, node.level);
    const auto j = static_cast<std::size_t>(node.index);
    const Segment s{points[j], points[j + 1 == points.size() ? 0 : j + 1]};
    if (node.level == 0) return box_of(s);
    const std::size_t first = curves.first_point(node.piece, node.level) - curves.finest_count();
    return box_of(s, extents_[first + j]);
}

}  // namespace touchline
