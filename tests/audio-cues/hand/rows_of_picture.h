// The path of a hand that reads a picture like a page. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"

#include <vector>

namespace touchline {

/// Three rows, at a quarter, the middle and three quarters of the height: to the right, to the
/// left, and to the right again.
[[nodiscard]] inline std::vector<Position> rows_of_picture(const Area& area) {
    const double x = 0.48 * area.width_m;
    const double y = 0.25 * area.height_m;
    return {{-x, y}, {x, y}, {x, 0.0}, {-x, 0.0}, {-x, -y}, {x, -y}};
}

}  // namespace touchline
