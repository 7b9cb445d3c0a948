// Finds the page in a camera's picture of a table, as a scanner would give it.
//
// picture -> find_page -> aspect, snapped -> rectified, <= 1 megapixel -> evenly_lit
//
// Threads: pure functions.
#pragma once

#include "vision/prepare/capture_trouble.h"

#include <cstdint>
#include <optional>

#include <opencv2/core.hpp>

namespace touchline {

enum class PaperFormat : std::uint8_t { other, a4, letter };

struct Document {
    cv::Mat page;  // 8-bit BGR, at most a megapixel; empty if there is trouble
    PaperFormat format = PaperFormat::other;
    CaptureTrouble trouble = CaptureTrouble::none;
};

/// Finds the document in an 8-bit BGR picture of at least 64 x 64. A megapixel or two are enough:
/// more are averaged away. O(pixels).
[[nodiscard]] Document document_in(const cv::Mat& bgr);

}  // namespace touchline
