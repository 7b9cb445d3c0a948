// Guesses what lies beneath a part of a picture from what lies beside it.
// Threads: pure function.
#pragma once

#include "vision/contour/gradient.h"

namespace touchline {

/// Returns the picture with each pixel of the mask in the colour of the nearest one outside.
/// O(pixels).
[[nodiscard]] cv::Mat3f painted_over(const cv::Mat3f& picture, const cv::Mat1b& mask);

}  // namespace touchline
