// The one traversal of the collision tree: top down, near children first, on a fixed stack. What to
// look for is the visitor's: it says how near a box is, what to do with a leaf's segment, and when
// a box is too far to matter. Threads: a value on the stack of the query. No allocation.
#pragma once

#include "haptics/collision/box.h"
#include "haptics/collision/collision_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace touchline {

/// Visitor:
///   std::optional<double> near(const Box&)  a key, smaller is nearer; nothing: cannot matter
///   double cut() const                      boxes with a larger key cannot matter
///   void leaf(SegmentRef, const Segment&)   a rendered segment
///   bool asks_leaf_boxes                    false: where a node holds one rendered segment, the
///                                           segment is passed to leaf() without a look at its box
///   bool spend()                            one box is opened; false: the budget is used up
/// A box is opened when its children are looked at, so n opened boxes lead to at most n + 1 leaves.
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
            if (top.piece < 0) {
                open_bound(top);
            } else {
                open_node(top);
            }
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

    void push(const Box& box, double parent_key, Entry entry) {
        const std::optional<double> key = visitor_.near(box);
        if (!key) return;
        // A child's box may stick out of its parent's, its content does not: so keys never fall.
        entry.key = std::max(*key, parent_key);
        if (entry.key <= visitor_.cut()) stack_[size_++] = entry;
    }

    void push_bound(std::int32_t index, double parent_key) {
        push(tree_.bounds_[static_cast<std::size_t>(index)].box(), parent_key, {0.0, -1, 0, index});
    }

    void open_bound(const Entry& entry) {
        const auto left = tree_.bounds_[static_cast<std::size_t>(entry.index)].left;
        if (left < 0) {
            const auto& root = tree_.roots_[static_cast<std::size_t>(-left - 1)];
            look_up(root.piece);
            visit(root.level, root.index, entry.key);
            return;
        }
        const std::size_t before = size_;
        push_bound(left, entry.key);
        push_bound(left + 1, entry.key);
        nearest_last(before);
    }

    void open_node(const Entry& entry) {
        look_up(entry.piece);
        if (entry.level == leaf_level_) {
            open_leaf(entry.index);
            return;
        }
        const std::size_t before = size_;
        visit(entry.level - 1, 2 * entry.index, entry.key);
        if (2 * entry.index + 1 < curves_.segment_count(piece_, entry.level - 1)) {
            visit(entry.level - 1, 2 * entry.index + 1, entry.key);
        }
        nearest_last(before);
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

    /// A node of the piece looked up.
    void visit(int level, int index, double parent_key) {
        if (level == leaf_level_ && !is_blend_ && !Visitor::asks_leaf_boxes) {
            leaf(index);
        } else {
            push(tree_.node_box(curves_, {piece_, level, index}), parent_key,
                 {0.0, piece_, level, index});
        }
    }

    void leaf(int index) {
        if (index < rendered_.segment_count()) {
            visitor_.leaf({piece_, index}, rendered_.segment(index));
        }
    }

    void look_up(int piece) {
        if (piece == piece_) return;
        piece_ = piece;
        const double at = curves_.rendered_level(piece, level_);
        leaf_level_ = static_cast<int>(std::ceil(at));
        is_blend_ = at < leaf_level_;
        rendered_ = curves_.rendered(piece, level_);
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
    int piece_ = -1;  // whose leaves these are:
    int leaf_level_ = 0;
    bool is_blend_ = false;
    RenderedPiece rendered_;
    std::size_t size_ = 0;
    std::array<Entry, capacity> stack_;
};

}  // namespace touchline
