// Finds the pale lines behind a chart and the squares of squared paper, which help an eye to
// measure but hide a chart from a hand.
// Threads: pure function.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// As a share of the strongest contrast in a picture; anything stronger is no grid.
inline constexpr double palest = 0.4;

/// Returns 255 where the pale strokes (255) are such a grid; an empty matrix if there is none. A
/// grid is three or more evenly spaced parallel straight lines, level or upright to within 3
/// degrees, with the remaining pieces of others on their spacing, and more than half of everything
/// that is as pale. O(pixels).
[[nodiscard]] cv::Mat1b grid_of(const cv::Mat1b& pale, double greatest_width_px);

}  // namespace touchline
