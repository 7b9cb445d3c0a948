// The paper's query (section 3): refines level by level and answers at the level that the budget
// allows.
#include "haptics/collision/first_touch.h"
#include "haptics/collision/spender.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {

/// The boxes that a motion meets at one level, refined to the next finer one.
class LevelByLevel {
  public:
    LevelByLevel(const CollisionTree& tree, const CurveSet& curves, const Motion& motion,
                 const Budget& budget)
        : tree_(tree), curves_(curves), motion_(motion), first_(motion), spender_(budget) {}

    HitAtLevel run() {
        if (!gather_roots()) return unknown();
        const auto wanted = static_cast<int>(std::ceil(motion_.level));
        int level = curves_.coarsest();
        while (level > wanted && refine(level)) --level;
        const bool is_wanted = level <= wanted;
        return answer(is_wanted ? motion_.level : level);
    }

  private:
    struct Node {
        std::int32_t piece, level, index;
    };

    /// A list of fixed size that refuses what does not fit.
    struct Nodes {
        static constexpr std::size_t capacity = 1024;

        std::array<Node, capacity> at;
        std::size_t size = 0;

        bool add(const Node& node) {
            if (size == capacity) return false;
            at[size++] = node;
            return true;
        }
    };

    bool gather_roots() {
        if (tree_.bounds_.empty()) return true;
        std::array<std::int32_t, 40> open;  // of a hierarchy over 2^32 stretches
        std::size_t size = 0;
        open[size++] = 0;
        while (size > 0) {
            const auto& bound = tree_.bounds_[static_cast<std::size_t>(open[--size])];
            if (!first_.near(bound.box())) continue;
            if (bound.left >= 0) {
                if (!spender_.spend(1)) return false;
                open[size++] = bound.left;
                open[size++] = bound.left + 1;
                continue;
            }
            const Stretch& roots = tree_.roots_[static_cast<std::size_t>(-bound.left - 1)];
            if (!spender_.spend(std::max(roots.count - 1, 1))) return false;
            if (!add_near(roots, *nodes_)) return false;
        }
        return true;
    }

    bool add_near(const Stretch& stretch, Nodes& to) {
        const Fan fan = tree_.fan(curves_, stretch, buffer_);
        const unsigned near = first_.sift(fan).near;
        for (int k = 0; k < stretch.count; ++k) {
            const bool is_near = (near & (1U << k)) != 0;
            if (is_near && !to.add({stretch.piece, stretch.level, stretch.first + k})) return false;
        }
        return true;
    }

    /// Refines from `level` to the next finer one. Returns false, and changes nothing, if the
    /// budget or the room does not suffice.
    bool refine(int level) {
        finer_->size = 0;
        for (std::size_t i = 0; i < nodes_->size; ++i) {
            const Node& node = nodes_->at[i];
            if (node.level < level) {
                if (!finer_->add(node)) return false;
                continue;
            }
            const int first = 2 * node.index;
            const int count =
                std::min(2, curves_.segment_count(node.piece, node.level - 1) - first);
            if (!spender_.spend(1)) return false;
            if (!add_near({node.piece, node.level - 1, first, count}, *finer_)) return false;
        }
        std::swap(nodes_, finer_);
        return true;
    }

    HitAtLevel answer(double level) {
        for (std::size_t i = 0; i < nodes_->size; ++i) {
            const Node& node = nodes_->at[i];
            const RenderedPiece piece = curves_.rendered(node.piece, level);
            const bool is_blend = CollisionTree::nodes(curves_, node.piece, level).is_blend;
            const int first = is_blend ? 2 * node.index : node.index;
            const int last = std::min(first + (is_blend ? 2 : 1), piece.segment_count());
            for (int j = first; j < last; ++j) first_.test({node.piece, j}, piece.segment(j));
        }
        return {first_.result(INFINITY, spender_.opened()), level, true};
    }

    HitAtLevel unknown() {
        HitAtLevel nothing;
        nothing.hit.clear = 0.0;
        nothing.hit.boxes = spender_.opened();
        nothing.level = curves_.coarsest();
        return nothing;
    }

    const CollisionTree& tree_;
    const CurveSet& curves_;
    const Motion& motion_;
    FirstTouch first_;
    Spender spender_;
    CollisionTree::FanBuffer buffer_{};
    std::array<Nodes, 2> lists_;
    Nodes* nodes_ = &lists_[0];
    Nodes* finer_ = &lists_[1];
};

HitAtLevel CollisionTree::first_hit_at_level_reached(const CurveSet& curves, const Motion& motion,
                                                     const Budget& budget) const {
    return LevelByLevel(*this, curves, motion, budget).run();
}

}  // namespace touchline
