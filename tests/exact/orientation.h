// Exact orientation of three points given as doubles, for tests: expansion arithmetic after
// Shewchuk (1997), with a floating-point filter in front. Independent of every shipped routine.
#pragma once

#include "config/types/vec2.h"

namespace touchline::exact {

/// +1: c lies to the left of the line from a to b, -1: to the right, 0: on it. Exact for finite
/// coordinates whose products neither overflow nor underflow.
[[nodiscard]] int orientation(Position a, Position b, Position c);

/// True when the closed segments have a point in common.
[[nodiscard]] bool meet(Position a, Position b, Position c, Position d);

}  // namespace touchline::exact
