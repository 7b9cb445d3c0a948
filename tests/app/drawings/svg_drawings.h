// SVG files made up at random, each around one feature of the format, with what it paints known
// from the generator's own numbers. Threads: pure functions.
#pragma once

#include "tests/app/drawings/paint.h"

namespace touchline::testing {

/// How many features there are.
[[nodiscard]] int svg_feature_count();

/// The same for the same feature (0 ... count - 1) and seed.
[[nodiscard]] Drawing svg_drawing(int feature, int seed);

}  // namespace touchline::testing
