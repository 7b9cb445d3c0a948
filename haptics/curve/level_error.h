// Measures how far a level lies from level 0, and whether a finger can tell.
// Threads: pure functions.
#pragma once

#include "haptics/curve/curve_set.h"

namespace touchline {

struct LevelError {
    double rms_m = 0.0;        // of the level-0 points from the level's polyline
    double hausdorff_m = 0.0;  // largest distance between the two, either way
    double slope_rms_rad =
        0.0;  // angle between the edges of level 0 and the segment that stands for them,
    double slope_max_rad = 0.0;  // weighted by length; what a finger notices first
    std::size_t points = 0;      // at this level
};

/// Measures all pieces of one outline rendered at a whole `level` (each at most at its coarsest).
/// O(N).
[[nodiscard]] LevelError level_error(const CurveSet& curves, int outline, int level);

/// Returns the least height of a bump that a finger detects, by the bump's width (metres): 8 mm at
/// 240 mm, falling with the power 1.3 (Louw, Kappers and Koenderink 2000).
[[nodiscard]] double detection_threshold_m(double width_m);

/// Returns l_percept: the coarsest level up to which no piece moves by more than half the threshold
/// for the level's shortest wavelength, 4 h0 2^l, nor turns an edge of level 0 by more than 5
/// degrees, half of what a hand with a tool can tell. A piece at its coarsest level does not change
/// any more. O(N) a level; ends at the first stretch that can be told from level 0.
[[nodiscard]] int percept_level(const CurveSet& curves);

}  // namespace touchline
