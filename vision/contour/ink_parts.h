// Separates strokes from shapes, in ink and in a map of colours, and from the pale lines behind a
// chart and the squares of squared paper, which help an eye to measure but hide a chart from a
// hand. Threads: pure functions (OpenCV uses its own inside).
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

struct ThinParts {
    cv::Mat1b strokes;  // 255 inside, for all colours together: they may cross
    cv::Mat1b map;      // of the rest, grown over the strokes
};

/// The map has no specks. Strokes are the parts of each colour's areas that are no wider than a
/// stroke (parts_of). Of the ground, the commonest colour, only areas that are thin as a whole
/// count: between two shapes such an area is a gap, within one a line. Strokes of several colours
/// side by side that are wide together are not strokes. O(pixels x colours).
[[nodiscard]] ThinParts thin_parts_of(const cv::Mat1b& map, double greatest_width_px);

/// As a share of the strongest contrast in a picture; anything stronger is no grid.
inline constexpr double palest = 0.4;

/// Returns 255 where the pale strokes (255) are such a grid; an empty matrix if there is none. A
/// grid is three or more evenly spaced parallel straight lines, level or upright to within 3
/// degrees, with the remaining pieces of others on their spacing, and more than half of everything
/// that is as pale. O(pixels).
[[nodiscard]] cv::Mat1b grid_of(const cv::Mat1b& pale, double greatest_width_px);

}  // namespace touchline
