// Camera frames become pixels. MJPEG through libjpeg-turbo, which decodes to a smaller size by
// leaving out high frequencies: at a quarter of the size in a fraction of the time.
// Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "vision/camera/frame.h"

#include <cstdint>

namespace touchline {

/// The largest size of this shape with at most so many pixels; never larger than `size`, sides at
/// least 1.
[[nodiscard]] cv::Size reduced_size(cv::Size size, std::int64_t pixels);

/// The largest of whole, half, quarter and eighth (sides rounded up) with at most so many pixels,
/// else the eighth: a JPEG is decoded to these without resampling, which costs as much again.
[[nodiscard]] cv::Size quick_size(cv::Size size, std::int64_t pixels);

/// 8-bit BGR of exactly the wanted size, which has no side longer than the frame's. Fails, with one
/// line, where bytes are missing, the JPEG is damaged, cut short or of another size than the frame.
/// O(bytes + pixels of the frame).
[[nodiscard]] Result<cv::Mat> to_bgr(const CameraFrame& frame, cv::Size wanted);

}  // namespace touchline
