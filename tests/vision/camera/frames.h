// Frames as cameras deliver them, made from pictures.
#pragma once

#include "vision/camera/frame.h"

namespace touchline::testing {

/// Returns a page with letters on a desk, smooth shading, colours: enough work for an encoder.
[[nodiscard]] cv::Mat scene(cv::Size size);

/// Pads each row by `padding_bytes`.
[[nodiscard]] CameraFrame yuyv_frame(const cv::Mat& bgr, std::size_t padding_bytes = 0);
[[nodiscard]] CameraFrame nv12_frame(const cv::Mat& bgr, std::size_t padding_bytes = 0);
[[nodiscard]] CameraFrame mjpeg_frame(const cv::Mat& bgr, int quality = 90);

/// Returns the frame as USB cameras send it: without the Huffman tables, marked AVI1.
[[nodiscard]] CameraFrame without_tables(CameraFrame mjpeg);

/// Returns the mean absolute difference per channel, in grey levels.
[[nodiscard]] double mean_difference(const cv::Mat& a, const cv::Mat& b);

}  // namespace touchline::testing
