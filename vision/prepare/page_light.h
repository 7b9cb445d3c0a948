// The light on a page: one number a pixel that is high for paper and low for dark or coloured
// things, to search for it; and the page without the shade of a lamp, with all that is drawn on it.
// Threads: pure functions, O(pixels).
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// Returns 8-bit, at the wanted size: the least of the three channels, a little smoothed.
[[nodiscard]] cv::Mat1b page_light(const cv::Mat& bgr, cv::Size size, double sigma_px);

/// Returns the level that this share (0 ... 1) of the pixels under the mask is below.
[[nodiscard]] int level_at(const cv::Mat1b& light, const cv::Mat1b& mask, double share);

/// Returns true if not even the brightest twentieth is bright.
[[nodiscard]] bool is_too_dark(const cv::Mat1b& light);

/// Makes paper equally bright everywhere (235 in every channel), whatever is drawn on it. The light
/// is a second-order surface through the places that are paper (paper.h), so filled shapes keep
/// their darkness. Dark shapes (below 0.36 of the brightest) may cover half the page; of the rest,
/// paper must be the commonest colour. 8-bit BGR. O(pixels).
[[nodiscard]] cv::Mat evenly_lit(const cv::Mat& bgr);

}  // namespace touchline
