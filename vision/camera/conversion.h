// Converts camera frames to pixels. MJPEG goes through libjpeg-turbo, which decodes to a smaller
// size by leaving out high frequencies: a quarter of the size takes a fraction of the time.
// Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "vision/camera/frame.h"

#include <cstdint>

namespace touchline {

/// Returns the largest size of this shape with at most `pixels` pixels; never larger than `size`,
/// sides at least 1.
[[nodiscard]] cv::Size reduced_size(cv::Size size, std::int64_t pixels);

/// Returns the largest of whole, half, quarter and eighth (sides rounded up) with at most `pixels`
/// pixels, else the eighth: a JPEG is decoded to these sizes without resampling, which would cost
/// as much again.
[[nodiscard]] cv::Size quick_size(cv::Size size, std::int64_t pixels);

/// Returns 8-bit BGR of exactly the wanted size, which has no side longer than the frame's. Fails,
/// with one line, if bytes are missing, or if the JPEG is damaged, cut short or of another size
/// than the frame. O(bytes + pixels of the frame).
[[nodiscard]] Result<cv::Mat> to_bgr(const CameraFrame& frame, cv::Size wanted);

}  // namespace touchline
