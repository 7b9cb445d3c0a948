// How far lines are from a known outline, in pixels.
// Threads: pure functions.
#pragma once

#include "tests/vision/pictures/canvas.h"
#include "vision/contour/chain.h"

#include <vector>

namespace touchline::testing {

/// Both polylines are sampled every half pixel. O(samples of one x segments of the other).
struct LineAccuracy {
    double rms_px = 0.0;       // truth to lines, without the missing parts
    double p99_px = 0.0;       // 99th percentile of both ways together
    double greatest_px = 0.0;  // both ways: Hausdorff
    double missing = 0.0;      // share of the truth that is over 2 px from any line
    double spurious = 0.0;     // share of the lines that is over 3 px from the truth
};

/// `truth` and `lines` have pixel centres at whole numbers.
[[nodiscard]] LineAccuracy accuracy_of(const std::vector<Chain>& lines,
                                       const std::vector<Polyline>& truth);

}  // namespace touchline::testing
