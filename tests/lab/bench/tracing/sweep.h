// A systematic search to and fro across the drawing area: every fourth row first, then those
// between. Threads: a plain value.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace touchline::bench {

class Sweep {
  public:
    explicit Sweep(const Area& area)
        : half_x_m_(0.5 * area.width_m), half_y_m_(0.5 * area.height_m) {
        constexpr double apart_m = 0.0044;  // a groove that reaches 3 mm pulls between any two
        constexpr double margin_m = 0.004;
        const double half_x = 0.5 * area.width_m - margin_m;
        const double half_y = 0.5 * area.height_m - margin_m;
        const int rows = static_cast<int>(std::ceil(2.0 * half_y / apart_m)) + 1;
        const auto y_of = [&](int row) { return -half_y + 2.0 * half_y * row / (rows - 1); };
        bool is_right = true;
        for (const int first : {0, 2, 1, 3}) {
            for (int i = first; i < rows; i += 4) {
                // Upwards in one pass, downwards in the next.
                const int in_pass = (rows - 1 - first) / 4 * 4;
                const int row = first % 2 == 0 ? i : first + in_pass - (i - first);
                ends_.push_back({is_right ? -half_x : half_x, y_of(row)});
                ends_.push_back({is_right ? half_x : -half_x, y_of(row)});
                is_right = !is_right;
            }
        }
    }

    /// False where the hand feels the frame of the drawing area.
    [[nodiscard]] bool is_inside(Position p) const {
        constexpr double edge_m = 2e-4;
        return std::abs(p.x) < half_x_m_ - edge_m && std::abs(p.y) < half_y_m_ - edge_m;
    }

    [[nodiscard]] bool is_over() const { return next_ == ends_.size(); }

    /// Returns where it goes now. Precondition: not over.
    [[nodiscard]] Position goal() const { return ends_[next_]; }

    void arrive() { ++next_; }

  private:
    double half_x_m_;
    double half_y_m_;
    std::vector<Position> ends_;  // the rows' ends, from one to the next
    std::size_t next_ = 0;
};

}  // namespace touchline::bench
