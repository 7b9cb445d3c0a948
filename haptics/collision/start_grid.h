// Where a walk through the collision tree starts if the motion is short: a uniform grid that says
// for every cell which stretches of about 4 mm have a box there. A step of the hand is shorter than
// a cell, so the walk starts next to what it may meet, however many outlines there are; the descent
// from the top would cost more than all the rest. Threads: immutable once built.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/box.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

/// Up to four neighbouring nodes of one level of a piece.
struct Stretch {
    int piece, level, first, count;
};

class StartGrid {
  public:
    /// The cells that a way touches, and how far the way stays from everything outside them.
    struct Cells {
        int x_first = 0, x_last = -1, y_first = 0, y_last = -1;  // none where last < first
        double margin_m = 0.0;
    };

    StartGrid() = default;

    /// `bounds` are those of each stretch, x along and y across. O(stretches + cells).
    StartGrid(std::vector<Stretch> stretches, std::span<const Shadow> bounds);

    /// Returns nothing if the way is too long to be worth it: more than nine cells. O(1).
    [[nodiscard]] std::optional<Cells> cells_near(const Way& way) const;

    [[nodiscard]] std::span<const std::int32_t> stretches_in(int x, int y) const {
        const auto cell = static_cast<std::size_t>(y * columns_ + x);
        return {items_.data() + first_item_[cell],
                static_cast<std::size_t>(first_item_[cell + 1] - first_item_[cell])};
    }

    [[nodiscard]] const Stretch& stretch(std::int32_t i) const {
        return stretches_[static_cast<std::size_t>(i)];
    }

    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    struct Interval {
        int first, last;
        double margin_m;
    };

    [[nodiscard]] Interval interval(double from, double to, double reach_m, double low,
                                    int count) const;

    Position low_;
    double cell_m_ = 1.0;
    double per_cell_m_ = 1.0;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<Stretch> stretches_;
    std::vector<std::int32_t> first_item_;  // per cell, in items_; one more at the end
    std::vector<std::int32_t> items_;       // stretches
};

}  // namespace touchline
