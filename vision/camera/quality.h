// Measures whether a frame is sharp and not overexposed. Threads: pure functions, O(pixels).
#pragma once

#include "vision/camera/frame.h"

namespace touchline {

/// Measures an 8-bit BGR picture.
[[nodiscard]] FrameQuality measure_quality(const cv::Mat& bgr);

}  // namespace touchline
