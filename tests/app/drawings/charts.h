// Random charts, plans and diagrams, like those of school books and offices.
// Threads: pure functions.
#pragma once

#include "tests/app/drawings/paint.h"

namespace touchline::testing {

/// Returns the number of kinds.
[[nodiscard]] int chart_kind_count();

/// Returns an SVG, the same for the same kind (0 ... count - 1) and seed.
[[nodiscard]] Drawing chart_drawing(int kind, int seed);

}  // namespace touchline::testing
