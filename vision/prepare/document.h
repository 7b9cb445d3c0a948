// Finds the page in a camera's picture of a table, as a scanner would give it, or why there is
// none.
//
// picture -> page light at 0.12 MP -> candidates: bright regions, straight lines -> scored by
// edges along the sides, area, shape -> the best, refined at up to 1 MP by lines through the edges
// -> judged -> aspect, snapped -> rectified, <= 1 megapixel -> evenly_lit
//
// Threads: pure functions.
#pragma once

#include "vision/prepare/quad.h"

#include <cstdint>
#include <optional>
#include <string_view>

#include <opencv2/core.hpp>

namespace touchline {

/// Why a document was not captured, and what to do, as said to a visitor who lays it down by touch.
/// Directions are those in the picture; the camera looks down with its top away from the visitor.
enum class CaptureTrouble : std::uint8_t {
    none,
    too_dark,
    too_bright,
    glare,  // a lamp reflects in the page
    no_page,
    too_small,
    too_large,  // it extends beyond the picture on opposite sides
    too_far_left,
    too_far_right,
    too_far_up,
    too_far_down,
};

/// Returns at most 15 words; empty for none.
[[nodiscard]] std::string_view sentence(CaptureTrouble trouble);

struct PageSearch {
    std::optional<Quad> corners;                    // in the picture as given, ordered() as it lies
    CaptureTrouble trouble = CaptureTrouble::none;  // none if there are corners
};

/// Takes an 8-bit BGR picture of at least 64 x 64. The page must cover at least a tenth of it and
/// lie whole in it. Its edges must be brighter than the surface under it along 85 % of its outline.
/// O(pixels).
[[nodiscard]] PageSearch find_page(const cv::Mat& bgr);

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
