// Finds places where a page might be, in two ways that fail on different pictures: bright regions
// (need a plain background) and straight lines (need straight sides, but not even light). Coarse:
// sides are right to within some pixels. Threads: pure functions.
#pragma once

#include "vision/prepare/quad.h"

#include <vector>

namespace touchline {

/// `light` is page_light() at some 0.1 megapixel. Corners may lie outside the picture, where its
/// frame cuts off a side. Returns at most some hundred, clockwise. O(pixels).
[[nodiscard]] std::vector<Quad> bright_regions(const cv::Mat1b& light);
[[nodiscard]] std::vector<Quad> line_quads(const cv::Mat1b& light);

}  // namespace touchline
