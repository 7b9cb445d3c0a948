// Moves the middle lines of strokes from whole pixels to half-way between the stroke's edges.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Moves the points of a stroke's line half-way between the stroke's two edges, which are the
/// places across the line where `darkness` falls below 1. Then smooths by about a pixel, and sets
/// width_px, which must already be about right, to the median of the measured widths. Fixed points
/// stay, as do points less than a width from one, where strokes meet. A free end of an open line
/// moves to half a width before the end of the ink, or to the frame if the ink goes on that far,
/// and becomes fixed. O(points x width).
[[nodiscard]] Chain centred(const Chain& line, const cv::Mat1f& darkness);

/// The same without looking at its ends: for lines that have not been joined yet.
[[nodiscard]] Chain in_the_middle(const Chain& line, const cv::Mat1f& darkness);

}  // namespace touchline
