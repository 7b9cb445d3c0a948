// Takes the shade of a lamp out of a page, and nothing that is drawn on it. Threads: pure function.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// Makes paper equally bright everywhere (235 in every channel), whatever is drawn on it. The light
/// is a second-order surface through the places that are paper (paper.h), so filled shapes keep
/// their darkness. Dark shapes (below 0.36 of the brightest) may cover half the page; of the rest,
/// paper must be the commonest colour. 8-bit BGR. O(pixels).
[[nodiscard]] cv::Mat evenly_lit(const cv::Mat& bgr);

}  // namespace touchline
