// The pale lines behind a chart, and the squares of squared paper: they help an eye to measure, and
// hide a chart from a hand.
// Threads: pure function.
#pragma once

#include "vision/prepare/ink.h"

namespace touchline {

/// Which of the strokes are such a grid: three parallel straight lines or more, level or upright
/// but for 3 degrees, evenly spaced, of at most 0.4 of the contrast of `strongest` (grey levels),
/// and more than half of all that is as pale. 255 there; an empty matrix where there is none: a
/// grid that is all there is is not paler than the strongest. O(pixels).
[[nodiscard]] cv::Mat1b grid_of(const Ink& strokes, double strongest, double greatest_width_px);

}  // namespace touchline
