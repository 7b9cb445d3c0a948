// Finds what stops a motion that starts at an edge of an outline and soon meets another edge of it,
// as where a proxy lifts off over a notch: looks at the points beside that edge, four at a time, in
// wider and wider stretches, as long as nothing else comes near them. Threads: values on the stack
// of the query. No allocation.
#pragma once

#include "haptics/collision/collision_tree.h"
#include "haptics/collision/lanes.h"

#include <bit>
#include <cmath>

namespace touchline {

/// Visitor as for a TreeWalk; it needs way(), cut(), spare(), spend() and leaf().
template <class Visitor>
class RowScan {
  public:
    RowScan(const CollisionTree& tree, const CurveSet& curves, double level, Visitor& visitor)
        : tree_(tree), curves_(curves), level_(level), visitor_(visitor) {}

    /// Shows the visitor whatever the way can meet first. Returns false if it may meet something
    /// else, or the budget ended; what was shown is right all the same.
    bool run(SegmentRef start) {
        shown_ = {-1, 0, 0, 0};
        const double rendered = curves_.rendered_level(start.piece, level_);
        const auto leaf_level = static_cast<int>(rendered);
        if (leaf_level != rendered) return false;
        row_ = curves_.points(start.piece, leaf_level);
        piece_ = start.piece;
        for (const int up : {3, 5}) {
            const int level = leaf_level + up;
            const int index = start.index >> up;
            if (level > curves_.piece(piece_).coarsest || index < 2) return false;
            const auto last = static_cast<std::size_t>(index + 3) << up;
            if (last + 2 * Fan::width > row_.size() || !are_alone(level, index)) return false;
            if (!visitor_.spend(5 << (up - 2))) return false;
            look_at(static_cast<std::size_t>(index - 2) << up, last);
            shown_ = {piece_, leaf_level, (index - 2) << up, 5 << up};
            visitor_.spare(0.0);
            if (visitor_.cut() <= stays(level, index)) return true;
        }
        return false;
    }

    /// Returns the edges that run() has shown, or found out of reach; none if it did neither.
    [[nodiscard]] const Stretch& shown() const { return shown_; }

  private:
    /// Four points as the way sees them: beside it, and ahead of its start, times its length; and
    /// how far they may be off while the disc still touches them.
    struct Seen {
        lanes::Floats beside, ahead, reach;
    };

    /// Whether a node and those beside it are alone.
    [[nodiscard]] bool are_alone(int level, int index) const {
        const std::size_t first = curves_.first_point(piece_, level);
        const auto before = static_cast<std::size_t>(index - 1);
        return (tree_.alone_from(first + before) & 0b111U) == 0b111U;
    }

    /// Returns the share up to which the way stays inside the boxes of these three nodes: so far it
    /// meets nothing but them and the ones beside them.
    [[nodiscard]] double stays(int level, int index) const {
        double share = 0.0;
        for (const int next : {index, index - 1, index + 1, index - 1}) {
            const Stay stay =
                stay_in(tree_.node_box(curves_, {piece_, level, next}), visitor_.way());
            if (stay.enter <= share) share = std::max(share, stay.leave);
        }
        return share;
    }

    /// Shows the visitor those of the edges first ... last - 1 that the way may meet.
    void look_at(std::size_t first, std::size_t last) {
        Seen near = seen(first);
        for (std::size_t j = first; j < last; j += Fan::width) {
            const Seen far = seen(j + Fan::width);
            for (unsigned met = edges_met(near, far); met != 0; met &= met - 1) {
                const std::size_t edge = j + static_cast<std::size_t>(std::countr_zero(met));
                visitor_.leaf({piece_, static_cast<int>(edge)}, {row_[edge], row_[edge + 1]});
            }
            near = far;
        }
    }

    [[nodiscard]] Seen seen(std::size_t first) const {
        // Points are taken relative to the way's start before they are rounded, so this is more
        // than what rounding loses, of the distance.
        constexpr float rounding = 1e-6F;
        const Way& way = visitor_.way();
        const lanes::Pair from = lanes::pair(way.from);
        const Position* const p = row_.data() + first;
        const lanes::Points to = lanes::rounded(lanes::pair(p[0]) - from, lanes::pair(p[1]) - from,
                                                lanes::pair(p[2]) - from, lanes::pair(p[3]) - from);
        const auto x = static_cast<float>(way.by.x);
        const auto y = static_cast<float>(way.by.y);
        const auto reach_m = static_cast<float>(way.reach_m);
        const auto length = static_cast<float>(length_bound(way.by));
        return {to.y * x - to.x * y, to.x * x + to.y * y,
                (1.0001F * reach_m + rounding * lanes::length_bounds(to)) * length};
    }

    /// Leaves out the edges with both ends on one side of the way, before or beyond it.
    [[nodiscard]] unsigned edges_met(const Seen& near, const Seen& far) const {
        const Way& way = visitor_.way();
        const auto square = static_cast<float>(1.000001 * dot(way.by, way.by));
        const Seen next{lanes::moved_on<1>(near.beside, far.beside),
                        lanes::moved_on<1>(near.ahead, far.ahead),
                        lanes::moved_on<1>(near.reach, far.reach)};
        const lanes::Floats reach = lanes::larger(near.reach, next.reach);
        const lanes::Masks is_apart = (lanes::smaller(near.beside, next.beside) > reach) |
                                      (lanes::larger(near.beside, next.beside) < -reach) |
                                      (lanes::larger(near.ahead, next.ahead) < -reach) |
                                      (lanes::smaller(near.ahead, next.ahead) > square + reach);
        return lanes::gathered(~is_apart & lanes::Masks{1, 2, 4, 8});
    }

    const CollisionTree& tree_;
    const CurveSet& curves_;
    double level_;
    Visitor& visitor_;
    Stretch shown_{-1, 0, 0, 0};
    int piece_ = -1;  // whose points these are:
    std::span<const Position> row_;
};

}  // namespace touchline
