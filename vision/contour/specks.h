// What is too small to be felt by itself: specks that go, and dashes and thin lines that stay.
// Threads: pure function.
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// Regions of fewer than `least_px` pixels are given to what lies beside them, but for those that
/// stand clear within one region: they may be dashes. 255 where these are, each of one colour.
/// O(pixels).
[[nodiscard]] cv::Mat1b without_specks(cv::Mat1b& map, const std::vector<cv::Vec3f>& palette,
                                       int least_px);

}  // namespace touchline
