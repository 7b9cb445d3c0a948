// Charts, plans and diagrams made up at random, as school books and offices have them. Threads:
// pure functions.
#pragma once

#include "tests/app/drawings/paint.h"

namespace touchline::testing {

/// How many kinds there are.
[[nodiscard]] int chart_kind_count();

/// The same for the same kind (0 ... count - 1) and seed: an SVG.
[[nodiscard]] Drawing chart_drawing(int kind, int seed);

}  // namespace touchline::testing
