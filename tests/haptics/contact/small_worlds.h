// Every small world on a grid: all that two edges can be to each other. Threads: values.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <vector>

namespace touchline::small_worlds {

/// All vertices lie on a grid of 3 x 3 places about the origin. Its pitch is 3.9 mm, a power of
/// two, so that edges on one line are so exactly.
inline constexpr double pitch_m = 0x1p-8;

/// Returns all open and closed polylines of three points that do not turn or mirror into each
/// other, also those that run back on themselves, and closed ones of two points.
[[nodiscard]] std::vector<TactileMap> polylines();

/// Returns all pairs of segments of two outlines that do not turn or mirror into each other:
/// crossings, T junctions, coincident and collinear ones.
[[nodiscard]] std::vector<TactileMap> pairs();

/// Returns the pairs that touch, the second one moved aside by 1 pm to 10 um.
[[nodiscard]] std::vector<TactileMap> near_meetings();

/// Returns handle positions: the vertices, the points half-way between them, and some in general
/// position in and around the grid.
[[nodiscard]] std::vector<Position> handles();

}  // namespace touchline::small_worlds
