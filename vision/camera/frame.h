// A frame as a camera gives it, and its measurements.
// Values. Threads: any.
#pragma once

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

}  // namespace touchline
