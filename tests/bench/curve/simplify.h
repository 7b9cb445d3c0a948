// The two simplifiers that maps use, to a given number of points: what can be had without levels.
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"

#include <cstddef>
#include <vector>

namespace touchline::bench {

/// Which points stay, ascending. `count` of them, 2 <= count <= points.size(); first and last among
/// them. Douglas and Peucker: the point farthest from its chord comes in next. O(n count).
[[nodiscard]] std::vector<std::size_t> douglas_peucker(const std::vector<Position>& points,
                                                       std::size_t count);

/// Visvalingam and Whyatt: the point that spans the smallest triangle with its neighbours goes
/// next. O(n log n).
[[nodiscard]] std::vector<std::size_t> visvalingam(const std::vector<Position>& points,
                                                   std::size_t count);

}  // namespace touchline::bench
