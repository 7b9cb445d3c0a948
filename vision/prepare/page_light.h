// The picture for the search of a page: one number a pixel that is high for paper and low for dark
// or coloured things. Threads: pure functions, O(pixels).
#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

namespace touchline {

/// Returns 8-bit, at the wanted size: the least of the three channels, a little smoothed.
[[nodiscard]] cv::Mat1b page_light(const cv::Mat& bgr, cv::Size size, double sigma_px);

/// Returns the level that this share (0 ... 1) of the pixels under the mask is below.
[[nodiscard]] int level_at(const cv::Mat1b& light, const cv::Mat1b& mask, double share);

/// Returns true if not even the brightest twentieth is bright.
[[nodiscard]] bool is_too_dark(const cv::Mat1b& light);

}  // namespace touchline
