#include "vision/contour/thin_parts.h"

#include "vision/contour/ink_parts.h"
#include "vision/contour/region_map.h"

#include <algorithm>
#include <array>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int kMostColours = 256;

/// The pieces of a mask that are strokes all over.
cv::Mat wholly_thin(const InkParts& parts) {
    std::vector<uchar> is_thin(static_cast<std::size_t>(parts.pieces), 255);
    is_thin[0] = 0;
    for (int y = 0; y < parts.piece.rows; ++y) {
        for (int x = 0; x < parts.piece.cols; ++x) {
            if (parts.shapes(y, x) != 0) {
                is_thin[static_cast<std::size_t>(parts.piece(y, x))] = 0;
            }
        }
    }
    cv::Mat thin(parts.piece.size(), CV_8U);
    std::ranges::transform(parts.piece, thin.begin<uchar>(),
                           [&](int piece) { return is_thin[static_cast<std::size_t>(piece)]; });
    return thin;
}

std::array<int, kMostColours> counts_of(const cv::Mat1b& map) {
    std::array<int, kMostColours> counts{};
    for (const uchar colour : map) {
        ++counts[colour];
    }
    return counts;
}

}  // namespace

ThinParts thin_parts_of(const cv::Mat1b& map, double greatest_width_px) {
    const auto counts = counts_of(map);
    const auto ground = std::ranges::max_element(counts) - counts.begin();
    cv::Mat thin(map.size(), CV_8U, cv::Scalar(0));
    for (int colour = 0; colour < kMostColours; ++colour) {
        if (counts[static_cast<std::size_t>(colour)] == 0) {
            continue;
        }
        const cv::Mat mask = map == colour;
        const InkParts parts = parts_of(mask, greatest_width_px);
        thin |= colour == ground ? wholly_thin(parts) : cv::Mat(parts.strokes);
    }
    ThinParts found{parts_of(thin, greatest_width_px).strokes, map.clone()};
    overgrow(found.map, found.strokes);
    return found;
}

}  // namespace touchline
