// Which ink is a stroke and which is a shape.
// Threads: pure functions.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// The ink, parted: strokes that become their middle line, shapes that become their outline.
struct InkParts {
    cv::Mat1b strokes;  // 255 inside
    cv::Mat1b shapes;
    cv::Mat1f depth;  // distance to the edge of the ink
    cv::Mat1i piece;  // connected pieces of ink, from 1; strokes and shapes that touch are one
    int pieces = 0;   // one more than there are: 0 is the paper
};

/// A shape is ink that a disc of the greatest width fits into, clearly (1.25 times, and twice what
/// is usual in a piece of strokes, for so deep is a sharp corner) somewhere, with the corners round
/// it; tails that stand out of it by more than a width are strokes, and so is all other ink. Specks
/// of fewer than 8 pixels are left out. O(pixels).
[[nodiscard]] InkParts parts_of(const cv::Mat1b& ink, double greatest_width_px);

/// The same of a mask in which nothing is as small as a speck or a pinhole.
[[nodiscard]] InkParts parts_of_clean(const cv::Mat1b& mask, double greatest_width_px);

/// Distance of each pixel of the mask to the nearest one outside, pixels.
[[nodiscard]] cv::Mat1f depth_of(const cv::Mat& mask);

}  // namespace touchline
