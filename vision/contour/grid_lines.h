// The pale lines behind a chart, and the squares of squared paper: they help an eye to measure, and
// hide a chart from a hand.
// Threads: pure function.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// Of the strongest contrast in a picture; what is stronger is no grid.
inline constexpr double kPalest = 0.4;

/// Which of the pale strokes (255) are such a grid: three parallel straight lines or more, level or
/// upright but for 3 degrees, evenly spaced, the pieces that are left of others on their spacing,
/// and more than half of all that is as pale. 255 there; an empty matrix where there is none.
/// O(pixels).
[[nodiscard]] cv::Mat1b grid_of(const cv::Mat1b& pale, double greatest_width_px);

}  // namespace touchline
