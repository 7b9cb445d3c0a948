// Finds which nodes of a collision tree come near others than their neighbours along the outline,
// which are alone, and which levels of a piece are safe: on the way from one level to the next, no
// line passes over a line that is not its neighbour. Else a hand between the two would be on the
// other side of one. Done once, when a map is built. Threads: off the tick.
#pragma once

#include "haptics/collision/collision_tree.h"
#include "haptics/curve/curve_set.h"

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

/// Two nodes, not neighbours along an outline, whose boxes meet: at least one of `level`, the other
/// of its piece's coarsest level if that is finer.
struct MeetingNodes {
    int level = 0;  // > 0
    std::array<SegmentRef, 2> nodes;

    friend auto operator<=>(const MeetingNodes&, const MeetingNodes&) = default;
};

struct Meetings {
    std::vector<MeetingNodes> pairs;  // ascending
    bool is_complete = true;          // false: too many to look for
    // What sifting along the pieces could not tell apart at a point's reach, whether it meets or
    // not: piece by piece, from coarse to fine.
    std::vector<MeetingNodes> close = {};
};

/// A node over which something passes while its piece goes from `level` - 1 to `level`.
struct UnsafeNode {
    SegmentRef node;
    int level = 0;
};

struct SafeLevels {
    std::vector<int> coarsest;  // per piece: no change of level up to this one is unsafe
    std::vector<UnsafeNode> unsafe;
};

/// `meetings` holds all of the curves' nodes. Lines that already cross at level 0 may continue to;
/// no vertex passes over a line. O(pairs), each a few times.
[[nodiscard]] SafeLevels find_safe_levels(const CurveSet& curves, const Meetings& meetings);

/// Returns pins that separate the unsafe parts from the rest of their outline, so that the rest
/// keeps its levels. Returns none if the lost levels are coarser than a hand at 0.5 m/s asks for.
[[nodiscard]] std::vector<PinPlace> pins_for(const CurveSet& curves, const SafeLevels& safe);

/// Walks down from the hierarchy over pairs of boxes that meet, so that distant boxes are never
/// compared.
class Crowding {
  public:
    /// Boxes nearer than twice `reach_m` crowd each other.
    Crowding(const CollisionTree& tree, const CurveSet& curves, double reach_m);

    /// Returns one flag for each node, in the order of the curves' points. Takes about 3
    /// comparisons a node for curves that keep clear of themselves. Two nodes that are settled,
    /// with all below them, are not compared. If a scene is so crowded that 64 comparisons a node
    /// do not suffice, no node is alone: then every slide asks the tree, which is slower but just
    /// as right. `close`, if given, spares a sift at a point's reach.
    [[nodiscard]] NodeFlags find_alone(const std::optional<std::vector<MeetingNodes>>& close);

    /// Returns the pairs of levels > 0 whose boxes crowd each other. `known` holds those of two
    /// pieces whose flag is set, as an earlier walk found them; these are not compared.
    [[nodiscard]] Meetings find_meetings(Meetings known, const std::vector<bool>& is_known);

  private:
    /// The nodes that replace one at the next finer level. A node takes part at a level by its
    /// piece and index: pieces with fewer levels take part with their coarsest one.
    struct Parts {
        SegmentRef at[2];
        int count;
    };

    void walk();
    void find_known_bounds();
    void put_known_in_order();
    void within_hierarchy(std::size_t bound);
    void between_bounds(std::size_t a, std::size_t b);
    void between_roots(std::size_t a, std::size_t b);
    void between_neighbours(SegmentRef a, SegmentRef b, int level);
    void between_strangers(SegmentRef a, SegmentRef b, int level);
    void compare(SegmentRef a, SegmentRef b, int level);
    void crowd(SegmentRef a, SegmentRef b, int level);
    void along_level(int piece, int level);
    void sift_along(int piece, int level, std::size_t fours);
    void look_at_close(int piece, int level);
    void look_ahead(int piece, int level, int j, int ahead);

    [[nodiscard]] bool is_pair_wanted() const { return settled_.empty(); }

    /// The finest level that is looked at.
    [[nodiscard]] int finest() const { return is_pair_wanted() ? 1 : 0; }

    [[nodiscard]] int level_of(SegmentRef a, int level) const;
    [[nodiscard]] SegmentRef root_of(SegmentRef a, int level) const;
    [[nodiscard]] Parts children(SegmentRef a, int level) const;
    [[nodiscard]] bool are_neighbours(SegmentRef a, SegmentRef b, int level) const;
    [[nodiscard]] bool is_last(SegmentRef a, int level) const;
    [[nodiscard]] std::size_t node_at(SegmentRef a, int level) const;
    [[nodiscard]] Box box_at(SegmentRef a, int level) const;
    [[nodiscard]] bool are_settled(SegmentRef a, SegmentRef b, int level) const;
    void mark(SegmentRef a, int level);
    void settle(SegmentRef a, int level);

    const CollisionTree& tree_;
    const CurveSet& curves_;
    double reach_m_;
    NodeFlags alone_;
    std::vector<bool> settled_;  // neither the node nor any below it is alone; empty where the
                                 // pairs are wanted instead
    Meetings meetings_;
    std::span<const MeetingNodes> close_;  // left to look at
    bool is_close_known_ = false;
    std::vector<bool> is_known_;        // per piece: not compared with others of that kind
    std::vector<bool> is_known_bound_;  // per node of the hierarchy: all in it are
    std::size_t left_;                  // comparisons that may still be made
};

}  // namespace touchline
