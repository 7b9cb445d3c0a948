// Exact answers about points, lines and segments given as doubles, to judge the shipped geometry:
// whole-number arithmetic over a common power of two, behind a filter in long double. Independent
// of every shipped routine. Threads: pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/segment.h"

#include <optional>

namespace touchline::exact {

/// Returns +1 if c lies to the left of the line from a to b, -1 if to the right, 0 if on it. Exact
/// for all finite coordinates.
[[nodiscard]] int orientation(Position a, Position b, Position c);

/// Returns true if the closed segments have a point in common.
[[nodiscard]] bool meet(Position a, Position b, Position c, Position d);

/// Returns true if the segments cross at a point inside both; false if they only touch.
[[nodiscard]] bool cross_inside(Position a, Position b, Position c, Position d);

/// Returns the share of the way, 0 ... 1, of its first point in common with the segment; nothing if
/// they have none. Both are closed, and each may be a single point. The exact share is rounded to
/// the nearest double, so that equal shares give equal numbers.
[[nodiscard]] std::optional<double> first_meeting(Position from, Position to,
                                                  const Segment& segment);

}  // namespace touchline::exact
