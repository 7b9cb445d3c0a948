// How far a level lies from level 0.
// Threads: pure functions.
#pragma once

#include "haptics/curve/curve_set.h"

namespace touchline {

struct LevelError {
    double rms_m = 0.0;        // of the level-0 points from the polyline of the level
    double hausdorff_m = 0.0;  // largest distance between the two, either way
    double slope_rms_rad =
        0.0;  // angle between the edges of level 0 and the segment that stands for them,
    double slope_max_rad = 0.0;  // weighted by length; what a finger notices first
    std::size_t points = 0;      // of the level
};

/// Over all pieces of one outline rendered at a whole `level` (each at most at its coarsest). O(N).
[[nodiscard]] LevelError level_error(const CurveSet& curves, int outline, int level);

}  // namespace touchline
