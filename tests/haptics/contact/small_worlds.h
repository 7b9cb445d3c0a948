// Every small world there is on a grid: what two edges can be to each other. Threads: values.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <vector>

namespace touchline::small_worlds {

/// Of the grid of 3 x 3 places about the origin that all vertices lie on: 3.9 mm, a power of two,
/// so that edges on one line are so exactly.
inline constexpr double pitch_m = 0x1p-8;

/// All open and closed polylines of three points, as far as they do not turn or mirror into each
/// other; also those that run back on themselves. Closed ones of two points.
[[nodiscard]] std::vector<TactileMap> polylines();

/// All pairs of segments of two outlines, as far as they do not turn or mirror into each other:
/// crossings, T junctions, coincident and collinear ones.
[[nodiscard]] std::vector<TactileMap> pairs();

/// The pairs that touch, the second one moved aside by from 1 pm to 10 um.
[[nodiscard]] std::vector<TactileMap> near_meetings();

/// Handle positions: the vertices, half-way between them, and some in general position in and
/// around the grid.
[[nodiscard]] std::vector<Position> handles();

}  // namespace touchline::small_worlds
