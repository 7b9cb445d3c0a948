// Random SVG files, each around one feature of the format; the generator's own numbers tell what
// they paint. Threads: pure functions.
#pragma once

#include "tests/app/drawings/paint.h"

namespace touchline::testing {

/// Returns the number of features.
[[nodiscard]] int svg_feature_count();

/// Returns the same drawing for the same feature (0 ... count - 1) and seed.
[[nodiscard]] Drawing svg_drawing(int feature, int seed);

}  // namespace touchline::testing
