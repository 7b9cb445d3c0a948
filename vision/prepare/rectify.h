// Turns a page seen from aslant into the page seen from above. Threads: pure functions.
#pragma once

#include "vision/prepare/quad.h"

namespace touchline {

constexpr double a4_aspect = 297.0 / 210.0;
constexpr double letter_aspect = 11.0 / 8.5;

/// The assumed focal length, as a share of the picture's longer side: 58 degrees across.
constexpr double usual_focal_share = 0.9;

/// Returns width over height of the rectangle whose picture is this quad, from its perspective. The
/// camera's focal length comes from the quad itself if it is aslant enough to tell; otherwise the
/// usual one is assumed, which then hardly matters. The lens looks through the middle of the
/// picture. O(1). Z. Zhang, L.-W. He: Whiteboard scanning (2007).
[[nodiscard]] double aspect_of(const Quad& corners, cv::Size picture);

/// Returns that of A4 or Letter, upright or lying, if the aspect is within 3 % of it; else as it
/// is.
[[nodiscard]] double snapped_aspect(double aspect);

/// Returns 8-bit BGR, width / height = aspect, at most `most_pixels` and never more than the quad
/// has in the picture. O(pixels).
[[nodiscard]] cv::Mat rectified(const cv::Mat& bgr, const Quad& corners, double aspect,
                                double most_pixels = 1e6);

}  // namespace touchline
