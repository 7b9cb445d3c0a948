// Where a label has room among lines. Threads: values.
#pragma once

#include "app/sheets/stroke_grid.h"
#include "app/sheets/tactile_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace touchline {

/// Which points of a lattice over the zone are too near to a line for braille.
class FreeLattice {
  public:
    /// `grid` holds the lines. O(points of the lattice * segments nearby).
    FreeLattice(const StrokeGrid& grid, const PaperBox& zone)
        : zone_(zone),
          columns_(1 + static_cast<std::size_t>(std::max(0.0, zone.width_mm()) / lattice_mm)),
          rows_(1 + static_cast<std::size_t>(std::max(0.0, zone.height_mm()) / lattice_mm)),
          sums_((columns_ + 1) * (rows_ + 1), 0) {
        for (std::size_t y = 0; y < rows_; ++y)
            for (std::size_t x = 0; x < columns_; ++x) {
                const bool is_taken =
                    grid.near(corner(x, y)).clear_mm < least_clear_mm + half_diagonal_mm;
                sums_[at(x + 1, y + 1)] = sums_[at(x, y + 1)] + sums_[at(x + 1, y)] -
                                          sums_[at(x, y)] + (is_taken ? 1 : 0);
            }
    }

    /// Calls `visit` with every free box of this size, whose corner lies on every other point.
    template <class Visit>
    void each_box(double width_mm, double height_mm, const Visit& visit) const {
        const auto wide = static_cast<std::size_t>(std::ceil(width_mm / lattice_mm));
        const auto high = static_cast<std::size_t>(std::ceil(height_mm / lattice_mm));
        for (std::size_t y = 0; y + high < rows_; y += 2)
            for (std::size_t x = 0; x + wide < columns_; x += 2) {
                const int taken = sums_[at(x + wide + 1, y + high + 1)] -
                                  sums_[at(x, y + high + 1)] - sums_[at(x + wide + 1, y)] +
                                  sums_[at(x, y)];
                if (taken != 0) continue;
                const PaperPoint from = corner(x, y);
                visit(PaperBox{from.x_mm, from.y_mm, from.x_mm + width_mm, from.y_mm + height_mm});
            }
    }

  private:
    static constexpr double lattice_mm = 2.0;
    static constexpr double half_diagonal_mm = 1.42;  // of a square of the lattice

    [[nodiscard]] std::size_t at(std::size_t x, std::size_t y) const {
        return y * (columns_ + 1) + x;
    }

    [[nodiscard]] PaperPoint corner(std::size_t x, std::size_t y) const {
        return {zone_.left_mm + lattice_mm * static_cast<double>(x),
                zone_.top_mm + lattice_mm * static_cast<double>(y)};
    }

    PaperBox zone_;
    std::size_t columns_;
    std::size_t rows_;
    std::vector<int> sums_;  // of the taken points above and to the left
};

}  // namespace touchline
