// What a follower remembers of where it has felt a line: cells of a millimetre, and how far it had
// followed lines by then. Threads: a plain value.
#pragma once

#include "config/types/vec2.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace touchline::bench {

class FeltPath {
  public:
    /// Remembers a line felt at p, after `followed_m` of following in all.
    void add(Position p, double followed_m) {
        double& first_m = cells_[index(cell(p.x), cell(p.y))];
        first_m = std::min(first_m, followed_m);
    }

    /// Whether a line was felt within `reach_m` of p, after at most `followed_m` of following.
    [[nodiscard]] bool is_known(Position p, double reach_m, double followed_m) const {
        const int reach = static_cast<int>(std::ceil(reach_m / cell_m));
        for (int dx = -reach; dx <= reach; ++dx) {
            for (int dy = -reach; dy <= reach; ++dy) {
                if (std::hypot(dx, dy) * cell_m > reach_m) continue;
                if (cells_[index(cell(p.x) + dx, cell(p.y) + dy)] <= followed_m) return true;
            }
        }
        return false;
    }

  private:
    static constexpr double cell_m = 5e-4;
    static constexpr int half = 200;  // 100 mm to each side

    static int cell(double x_m) { return static_cast<int>(std::floor(x_m / cell_m)) + half; }

    static std::size_t index(int x, int y) {
        const auto at = [](int i) { return static_cast<std::size_t>(std::clamp(i, 0, 2 * half)); };
        return at(y) * (2 * half + 1) + at(x);
    }

    std::vector<double> cells_ = std::vector<double>((2 * half + 1) * (2 * half + 1),
                                                     std::numeric_limits<double>::infinity());
};

}  // namespace touchline::bench
