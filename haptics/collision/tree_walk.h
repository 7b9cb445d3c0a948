// The one traversal of the collision tree: top down, near children first, on a fixed stack. What to
// look for is the visitor's: it says how near a box is, what to do with a leaf's segment, and when
// a box is too far to matter. Threads: a value on the stack of the query. No allocation.
#pragma once

#include "haptics/collision/collision_tree.h"
#include "haptics/collision/frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {

/// Visitor:
///   std::optional<double> near(const AlignedBox&)  a key, smaller is nearer; nothing: cannot
///   matter double cut() const                             boxes with a larger key cannot matter
///   void leaf(SegmentRef)                          a rendered segment
///   bool spend()                                   one box is opened; false: the budget is used up
template <class Visitor>
class TreeWalk {
  public:
    TreeWalk(const CollisionTree& tree, const CurveSet& curves, double level, Visitor& visitor)
        : tree_(tree), curves_(curves), level_(level), visitor_(visitor) {}

    /// Returns the smallest key of the boxes left unopened, infinity when the walk was finished.
    double run() {
        if (tree_.bounds_.empty()) return INFINITY;
        push_bound(0, 0.0);
        while (size_ > 0) {
            const Entry top = stack_[--size_];
            if (top.key > visitor_.cut()) continue;
            if (!visitor_.spend()) {
                ++size_;
                return smallest_key();
            }
            open(top);
        }
        return INFINITY;
    }

  private:
    /// A node of the hierarchy (piece -1) or of a piece.
    struct Entry {
        double key;
        std::int32_t piece, level, index;
    };

    /// Deeper than any tree: 2^32 roots halve 32 times, and a piece has at most 32 levels.
    static constexpr std::size_t capacity = 72;

    [[nodiscard]] double smallest_key() const {
        double key = INFINITY;
        for (std::size_t i = 0; i < size_; ++i) key = std::min(key, stack_[i].key);
        return key;
    }

    void push(const AlignedBox& box, double parent_key, Entry entry) {
        const std::optional<double> key = visitor_.near(box);
        if (!key) return;
        // A child's box may stick out of its parent's, its content does not: so keys never fall.
        entry.key = std::max(*key, parent_key);
        if (entry.key <= visitor_.cut()) stack_[size_++] = entry;
    }

    void push_bound(std::int32_t index, double parent_key) {
        const auto& bound = tree_.bounds_[static_cast<std::size_t>(index)];
        const AlignedBox box{{},
                             {1.0, 0.0},
                             static_cast<double>(bound.x_low),
                             static_cast<double>(bound.x_high),
                             static_cast<double>(bound.y_low),
                             static_cast<double>(bound.y_high)};
        push(box, parent_key, {0.0, -1, 0, index});
    }

    void push_node(int piece, int level, int index, double parent_key) {
        push(tree_.aligned_box(curves_, {piece, level, index}), parent_key,
             {0.0, piece, level, index});
    }

    void open(const Entry& entry) {
        if (entry.piece < 0) {
            open_bound(entry);
        } else if (entry.level == tree_.leaf_level(curves_, entry.piece, level_)) {
            open_leaf(entry);
        } else {
            const std::size_t before = size_;
            push_node(entry.piece, entry.level - 1, 2 * entry.index, entry.key);
            if (2 * entry.index + 1 < curves_.segment_count(entry.piece, entry.level - 1)) {
                push_node(entry.piece, entry.level - 1, 2 * entry.index + 1, entry.key);
            }
            nearest_last(before);
        }
    }

    void open_bound(const Entry& entry) {
        const auto left = tree_.bounds_[static_cast<std::size_t>(entry.index)].left;
        if (left < 0) {
            const auto& root = tree_.roots_[static_cast<std::size_t>(-left - 1)];
            push_node(root.piece, root.level, root.index, entry.key);
            return;
        }
        const std::size_t before = size_;
        push_bound(left, entry.key);
        push_bound(left + 1, entry.key);
        nearest_last(before);
    }

    /// At a fractional level a leaf holds its two blended halves.
    void open_leaf(const Entry& entry) {
        const double rendered = curves_.rendered_level(entry.piece, level_);
        const bool is_blend = rendered < entry.level;
        const int first = is_blend ? 2 * entry.index : entry.index;
        const int count = curves_.rendered_count(entry.piece, level_);
        for (int j = first; j < std::min(first + (is_blend ? 2 : 1), count); ++j) {
            visitor_.leaf({entry.piece, j});
        }
    }

    void nearest_last(std::size_t before) {
        if (size_ == before + 2 && stack_[before].key < stack_[before + 1].key) {
            std::swap(stack_[before], stack_[before + 1]);
        }
    }

    const CollisionTree& tree_;
    const CurveSet& curves_;
    double level_;
    Visitor& visitor_;
    std::array<Entry, capacity> stack_;
    std::size_t size_ = 0;
};

}  // namespace touchline
