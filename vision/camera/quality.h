// Is a frame sharp, and does light drown it? Threads: pure functions, O(pixels).
#pragma once

#include "vision/camera/frame.h"

namespace touchline {

/// Of an 8-bit BGR picture.
[[nodiscard]] FrameQuality measure_quality(const cv::Mat& bgr);

}  // namespace touchline
