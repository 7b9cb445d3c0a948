// Middle lines of strokes, from whole pixels to where the stroke's edges say.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Moves the points of a stroke's line half-way between the stroke's two edges, the places across
/// the line where `darkness` falls below 1, smooths by about a pixel, and sets width_px to the
/// middle one of the widths measured. Needs width_px to be about right already. Fixed points, and
/// points less than a width from one, where strokes meet, stay. A free end of an open line is moved
/// to half a width before the end of the ink, or to the frame if the ink goes on so far, and fixed.
/// O(points x width).
[[nodiscard]] Chain centred(const Chain& line, const cv::Mat1f& darkness);

/// The same without a look at its ends: for what has not been joined yet.
[[nodiscard]] Chain in_the_middle(const Chain& line, const cv::Mat1f& darkness);

}  // namespace touchline
