// A frame as a camera gives it, its pixels, and its measurements. MJPEG goes through libjpeg-turbo,
// which decodes to a smaller size by leaving out high frequencies: a quarter of the size takes a
// fraction of the time.
// Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// yuyv: Y0 U Y1 V for two pixels, BT.601, 16 ... 235. mjpeg: one JPEG, perhaps without its Huffman
/// tables. nv12: a plane of Y, then one of U V pairs at half the size, same stride. bgr: 8-bit
/// pixels.
enum class PixelFormat : std::uint8_t { yuyv, mjpeg, nv12, bgr };

struct CameraFrame {
    PixelFormat format = PixelFormat::bgr;
    cv::Size size;                 // pixels
    std::size_t stride_bytes = 0;  // from row to row; means nothing for mjpeg
    std::vector<std::uint8_t> bytes;
};

/// The camera's report on its own control loops at this frame; nothing if it does not report.
struct LoopReport {
    std::optional<bool> is_focused;
    std::optional<bool> is_exposure_settled;
};

/// Measured on a frame at a fixed size: sharpness only compares between frames of one size and one
/// scene.
struct FrameQuality {
    double sharpness = 0.0;      // variance of the Laplacian, grey levels squared
    double clipped_share = 0.0;  // 0 ... 1, pixels at full brightness
    double brightness = 0.0;     // mean, 0 ... 255
};

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

/// Measures whether an 8-bit BGR picture is sharp and not overexposed. O(pixels).
[[nodiscard]] FrameQuality measure_quality(const cv::Mat& bgr);

}  // namespace touchline
