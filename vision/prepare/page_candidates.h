// Places where a page might be, by two ways that fail on different pictures: bright regions (need a
// plain background) and straight lines (need straight sides, not even light). Coarse: sides are
// within some pixels. Threads: pure functions.
#pragma once

#include "vision/prepare/quad.h"

#include <vector>

namespace touchline {

/// Of page_light() at some 0.1 megapixel. Corners may lie outside the picture, where a side is cut
/// off by its frame. At most some hundred, clockwise. O(pixels).
[[nodiscard]] std::vector<Quad> bright_regions(const cv::Mat1b& light);
[[nodiscard]] std::vector<Quad> line_quads(const cv::Mat1b& light);

}  // namespace touchline
