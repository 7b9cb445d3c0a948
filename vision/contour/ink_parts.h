// Separates strokes of ink from shapes.
// Threads: pure functions.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// The ink in two parts: strokes that become their middle line, and shapes that become their
/// outline.
struct InkParts {
    cv::Mat1b strokes;  // 255 inside
    cv::Mat1b shapes;
    cv::Mat1f depth;  // distance to the edge of the ink
    cv::Mat1i piece;  // connected ink, from 1; strokes and shapes that touch are one piece
    int pieces = 0;   // the number of pieces and one: 0 is the paper
};

/// Separates the ink. A shape is ink into which a disc of the greatest width clearly fits somewhere
/// (1.25 times that width, and twice the usual width in a piece of strokes, because a sharp corner
/// is that deep), with the corners round it. Tails that stand out of it by more than a width are
/// strokes, as is all other ink. Specks of fewer than 8 pixels are left out. O(pixels).
[[nodiscard]] InkParts parts_of(const cv::Mat1b& ink, double greatest_width_px);

/// The same for a mask without specks and pinholes.
[[nodiscard]] InkParts parts_of_clean(const cv::Mat1b& mask, double greatest_width_px);

/// Returns the distance of each pixel of the mask to the nearest one outside, pixels.
[[nodiscard]] cv::Mat1f depth_of(const cv::Mat& mask);

}  // namespace touchline
