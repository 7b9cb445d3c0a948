// The two simplifiers that maps use, to a given number of points: what is possible without levels.
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"

#include <cstddef>
#include <vector>

namespace touchline::bench {

/// Returns which points stay, ascending: `count` of them, 2 <= count <= points.size(), first and
/// last included. Douglas and Peucker: adds the point farthest from its chord next. O(n count).
[[nodiscard]] std::vector<std::size_t> douglas_peucker(const std::vector<Position>& points,
                                                       std::size_t count);

/// Visvalingam and Whyatt: removes the point that spans the smallest triangle with its neighbours
/// next. O(n log n).
[[nodiscard]] std::vector<std::size_t> visvalingam(const std::vector<Position>& points,
                                                   std::size_t count);

}  // namespace touchline::bench
