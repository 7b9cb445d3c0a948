// Finds the page in a picture of a table: its four corners, or why there are none.
//
// picture -> page light at 0.12 MP -> candidates: bright regions, straight lines -> scored by edges
// along the sides, area, shape -> the best, refined at up to 1 MP by lines through the edges ->
// judged
//
// Threads: pure function.
#pragma once

#include "vision/prepare/capture_trouble.h"
#include "vision/prepare/quad.h"

namespace touchline {

struct PageSearch {
    std::optional<Quad> corners;                    // in the picture as given, ordered() as it lies
    CaptureTrouble trouble = CaptureTrouble::none;  // none if there are corners
};

/// Takes an 8-bit BGR picture of at least 64 x 64. The page must cover at least a tenth of it and
/// lie whole in it. Its edges must be brighter than the surface under it along 85 % of its outline.
/// O(pixels).
[[nodiscard]] PageSearch find_page(const cv::Mat& bgr);

}  // namespace touchline
