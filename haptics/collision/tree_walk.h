// The one traversal of the collision tree: top down, near children first, on a fixed stack. A
// visitor decides what to look for: it says how near a box is, what to do with a leaf's segment,
// and when a box is too far to matter. FirstTouch is what a visitor collects of a motion. Threads:
// values on the stack of the query. No allocation.
#pragma once

#include "haptics/collision/box.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/collision/touch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

namespace touchline {

/// Visitor:
///   Sifted sift(const Fan&)                 which of four nodes may matter, and a key for each
///   std::optional<double> near(const Box&)  a key, smaller is nearer; nothing: cannot matter
///   double cut() const                      boxes with a larger key cannot matter
///   void leaf(SegmentRef, const Segment&)   a rendered segment
///   bool asks_leaf_boxes                    false: if a node holds one rendered segment, the
///                                           segment is passed to leaf() without a look at its box
///   void spare(double)                      boxes not looked at stay at least this far out of
///                                           reach of the way; only for run_near()
///   bool has_seen(const Stretch&)           if there is one: whether a piece's nodes need no look
///   bool spend(int)                         this many boxes are opened; false: the budget does not
///                                           suffice
/// A box is opened when its children are looked at, so n opened boxes lead to at most n + 1 leaves.
/// Two levels are opened at once if the tree is that deep: a node and its two children.
template <class Visitor>
class TreeWalk {
  public:
    TreeWalk(const CollisionTree& tree, const CurveSet& curves, double level, Visitor& visitor)
        : tree_(tree),
          curves_(curves),
          level_(level),
          finest_whole_(static_cast<int>(std::min(level, 64.0))),
          is_fraction_(level > finest_whole_),
          visitor_(visitor) {}

    /// Returns the smallest key of the boxes left unopened; infinity if the walk was finished.
    double run() {
        if (tree_.bounds_.empty()) return INFINITY;
        push_bound(0, 0.0);
        return finish();
    }

    /// The same for a search that only matters near a way. Starts at the grid if the way is short
    /// and the level is no coarser than the grid's.
    double run_near(const Way& way) {
        if (!(level_ <= tree_.start_level_)) return run();
        const std::optional<StartGrid::Start> start = tree_.start_grid_.start_of(way);
        if (!start) return run();
        visitor_.spare(start->margin_m);
        for (const std::int32_t i : start->stretches) {
            const StartGrid::Nodes& nodes = tree_.start_grid_.nodes(i);
            if (!visitor_.spend(nodes.stretch.count) || !walk(nodes)) return 0.0;
        }
        return INFINITY;
    }

  private:
    /// Walks a stretch of the grid and everything below it. Returns false if the budget ended.
    bool walk(const StartGrid::Nodes& nodes) {
        const Sifted found = sifted(nodes);
        if (found.near == 0) return true;
        look_up(nodes.stretch.piece);
        first_of_fan_ = size_;
        push_fan(found, nodes.stretch, 0.0);
        return !std::isfinite(finish());
    }

    Sifted sifted(const StartGrid::Nodes& nodes) {
        if constexpr (requires { visitor_.sift(nodes.fan); }) return visitor_.sift(nodes.fan);
        return visitor_.sift(tree_.fan(curves_, nodes.stretch, buffer_));
    }

    double finish() {
        while (size_ > 0) {
            const Entry top = stack_[--size_];
            if (top.key > visitor_.cut()) continue;
            if (has_seen(top)) continue;
            if (!visitor_.spend(cost_of(top))) {
                ++size_;
                return smallest_key();
            }
            if (top.piece < 0) {
                open_bound(top);
            } else {
                open_node(top);
            }
        }
        return INFINITY;
    }

    /// A node of the hierarchy (piece -1) or of a piece.
    struct Entry {
        double key;
        std::int32_t piece, level, index;
    };

    /// Deeper than any tree: the hierarchy over 2^32 fans, and 32 levels of a piece, with three
    /// nodes left behind for every two of them.
    static constexpr std::size_t capacity = 96;

    [[nodiscard]] double smallest_key() const {
        double key = INFINITY;
        for (std::size_t i = 0; i < size_; ++i) key = std::min(key, stack_[i].key);
        return key;
    }

    [[nodiscard]] bool has_seen(const Entry& entry) const {
        if constexpr (requires { visitor_.has_seen(Stretch{}); }) {
            return visitor_.has_seen({entry.piece, entry.level, entry.index, 1});
        }
        return false;
    }

    /// A child's box may stick out of its parent's, but its content does not: so keys never fall.
    void push(double key, double parent_key, Entry entry) {
        entry.key = std::max(key, parent_key);
        if (entry.key > visitor_.cut()) return;
        // Nearest last, among the few pushed since `first_of_fan_`.
        std::size_t at = size_++;
        for (; at > first_of_fan_ && stack_[at - 1].key < entry.key; --at) {
            stack_[at] = stack_[at - 1];
        }
        stack_[at] = entry;
    }

    void push_bound(std::int32_t index, double parent_key) {
        const auto& bound = tree_.bounds_[static_cast<std::size_t>(index)];
        const std::optional<double> key = visitor_.near(bound.box());
        if (key) push(*key, parent_key, {0.0, -1, 0, index});
    }

    void open_bound(const Entry& entry) {
        const auto& bound = tree_.bounds_[static_cast<std::size_t>(entry.index)];
        first_of_fan_ = size_;
        if (bound.left >= 0) {
            push_bound(bound.left, entry.key);
            push_bound(bound.left + 1, entry.key);
            return;
        }
        const auto& roots = tree_.roots_[static_cast<std::size_t>(-bound.left - 1)];
        look_up(roots.piece);
        open_fan(roots, entry.key);
    }

    void open_node(const Entry& entry) {
        look_up(entry.piece);
        first_of_fan_ = size_;
        if (entry.level == leaf_level_) {
            open_leaf(entry.index);
            return;
        }
        const int down = depth_of(entry);
        const int level = entry.level - down;
        const int first = entry.index << down;
        const int count = std::min(1 << down, curves_.segment_count(piece_, level) - first);
        open_fan({piece_, level, first, count}, entry.key);
    }

    /// The number of levels opened at once.
    [[nodiscard]] int depth_of(const Entry& entry) const {
        return entry.level - leaf_level_ >= 2 ? 2 : 1;
    }

    [[nodiscard]] int cost_of(const Entry& entry) {
        if (entry.piece < 0) {
            const auto left = tree_.bounds_[static_cast<std::size_t>(entry.index)].left;
            if (left >= 0) return 1;
            // Stands for the two or three nodes that a binary tree would have above its roots.
            return std::max(tree_.roots_[static_cast<std::size_t>(-left - 1)].count - 1, 1);
        }
        look_up(entry.piece);
        return entry.level == leaf_level_ ? 1 : (1 << depth_of(entry)) - 1;
    }

    /// Looks at neighbouring nodes of the piece that is looked up.
    void open_fan(const Stretch& nodes, double parent_key) {
        push_fan(visitor_.sift(tree_.fan(curves_, nodes, buffer_)), nodes, parent_key);
    }

    void push_fan(const Sifted& found, const Stretch& nodes, double parent_key) {
        const bool are_leaves =
            nodes.level == leaf_level_ && !is_blend_ && !Visitor::asks_leaf_boxes;
        for (unsigned near = found.near; near != 0; near &= near - 1) {
            const int k = std::countr_zero(near);
            if (are_leaves) {
                leaf(nodes.first + k);
            } else {
                push(static_cast<double>(found.key[static_cast<std::size_t>(k)]), parent_key,
                     {0.0, piece_, nodes.level, nodes.first + k});
            }
        }
    }

    /// At a fractional level a node of the next whole one holds two blended halves.
    void open_leaf(int index) {
        if (!is_blend_) {
            leaf(index);
            return;
        }
        leaf(2 * index);
        leaf(2 * index + 1);
    }

    void leaf(int index) {
        if (piece_ != rendered_piece_) {
            rendered_piece_ = piece_;
            rendered_ = curves_.rendered(piece_, level_);
        }
        if (index < rendered_.segment_count()) {
            visitor_.leaf({piece_, index}, rendered_.segment(index));
        }
    }

    void look_up(int piece) {
        if (piece == piece_) return;
        piece_ = piece;
        const int coarsest = curves_.piece(piece).coarsest;
        is_blend_ = is_fraction_ && finest_whole_ < coarsest;
        leaf_level_ = std::min(finest_whole_ + (is_blend_ ? 1 : 0), coarsest);
    }

    const CollisionTree& tree_;
    const CurveSet& curves_;
    double level_;
    int finest_whole_;
    bool is_fraction_;
    Visitor& visitor_;
    int piece_ = -1;  // whose leaves these are:
    int leaf_level_ = 0;
    bool is_blend_ = false;
    int rendered_piece_ = -1;
    RenderedPiece rendered_;  // of that piece
    std::size_t size_ = 0;
    std::size_t first_of_fan_ = 0;
    CollisionTree::FanBuffer buffer_{};
    std::array<Entry, capacity> stack_;
};

/// Collects the first of several touches; ties go to the lowest segment.
class FirstTouch {
  public:
    explicit FirstTouch(const Motion& motion) : motion_(motion), way_(way_of(motion)) {}

    [[nodiscard]] const Way& way() const { return way_; }

    /// Boxes not looked at stay at least this far out of reach.
    void spare(double margin_m) { least_gap2_m2_ = std::min(least_gap2_m2_, margin_m * margin_m); }

    Sifted sift(const auto& fan) {
        const Sifted found = touchline::sift(fan, way_);
        least_gap2_m2_ = std::min(least_gap2_m2_, static_cast<double>(found.gap2_m2));
        return found;
    }

    /// Returns the share of the way at which a box is entered; nothing if the box cannot matter.
    [[nodiscard]] std::optional<double> near(const Box& box) {
        const Approach found = approach(box, way_);
        if (found.is_met) return found.entry;
        least_gap2_m2_ = std::min(least_gap2_m2_, found.gap2_m2);
        return {};
    }

    [[nodiscard]] double cut() const { return hit_.is_hit ? hit_.clear + tie_ : 1.0; }

    void test(SegmentRef ref, const Segment& segment) {
        if (ref == motion_.excluded[0] || ref == motion_.excluded[1]) return;
        least_gap2_m2_ = 0.0;
        const auto found = touch(motion_.from, motion_.to, motion_.radius_m, segment);
        if (!found) return;
        tie_ = tie_of(motion_);
        if (hit_.is_hit && found->fraction > hit_.clear + tie_) return;
        const bool is_tie = hit_.is_hit && found->fraction >= hit_.clear - tie_;
        const bool is_kept = is_tie && hit_.segment < ref;
        const double clear = is_tie ? std::min(hit_.clear, found->fraction) : found->fraction;
        if (!is_kept) hit_ = {true, clear, ref, *found, 0};
        hit_.clear = clear;
    }

    /// `unopened` is the earliest moment at which a box left unopened is met. A hit counts only
    /// before it.
    [[nodiscard]] Hit result(double unopened, int opened) {
        if (unopened <= cut()) {
            const double clear = std::min(unopened, hit_.is_hit ? hit_.clear : 1.0);
            hit_ = {};
            hit_.clear = clear;
        } else if (!hit_.is_hit) {
            hit_.spare_m = std::sqrt(least_gap2_m2_);
        }
        hit_.boxes = opened;
        return hit_;
    }

  private:
    /// The tolerance is larger than all rounding: no box is entered later than its content is
    /// touched.
    static Way way_of(const Motion& motion) {
        return {motion.from, motion.to - motion.from, motion.radius_m + approach_tolerance_m};
    }

    /// The share of the motion within which two contacts count as one moment.
    static double tie_of(const Motion& motion) {
        constexpr double few_ulp = 8.9e-16;
        if (motion.radius_m == 0.0) return few_ulp;
        return approach_tolerance_m / std::max(norm(motion.to - motion.from), 1e-30);
    }

    const Motion& motion_;
    Way way_;
    double tie_ = 0.0;  // worked out at the first hit
    double least_gap2_m2_ = INFINITY;
    Hit hit_;
};

}  // namespace touchline
