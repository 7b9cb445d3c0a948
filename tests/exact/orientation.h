// Exact answers about points, lines and segments given as doubles, for judging the shipped
// geometry: whole-number arithmetic over a common power of two, behind a filter in long double.
// Independent of every shipped routine. Threads: pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/segment.h"

#include <optional>

namespace touchline::exact {

/// +1: c lies to the left of the line from a to b, -1: to the right, 0: on it. Exact for all finite
/// coordinates.
[[nodiscard]] int orientation(Position a, Position b, Position c);

/// True when the closed segments have a point in common.
[[nodiscard]] bool meet(Position a, Position b, Position c, Position d);

/// True when the segments cross at a point inside of both; not where they only touch.
[[nodiscard]] bool cross_inside(Position a, Position b, Position c, Position d);

/// The share of the way, 0 ... 1, at which it has its first point in common with the segment, both
/// closed, each perhaps a single point: the exact share rounded to the nearest double, so that
/// equal shares give equal numbers. Nothing where they have no point in common.
[[nodiscard]] std::optional<double> first_meeting(Position from, Position to,
                                                  const Segment& segment);

}  // namespace touchline::exact
