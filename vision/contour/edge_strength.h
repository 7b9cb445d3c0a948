// Draws edge lines as a picture, to measure them against boundaries that people drew.
// Threads: pure function, O(points).
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Returns an 8-bit picture: 255 r / (1 + r) on the pixels of the lines, else 0. r = mean strength
/// along 20 pixels either way / high x (1 - exp(-length / 30 px)): 128 is a long line exactly as
/// strong as `high`.
[[nodiscard]] cv::Mat edge_strength(const std::vector<Chain>& lines, cv::Size size, double high);

}  // namespace touchline
