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

/// Returns the pieces of a mask that are strokes all over, except for parts that run along the
/// picture's edge, which a frame leaves over.
cv::Mat wholly_thin(const InkParts& parts, double greatest_width_px) {
    struct Piece {
        int pixels = 0;
        int on_edge = 0;
        bool has_shape = false;
    };

    std::vector<Piece> pieces(static_cast<std::size_t>(parts.pieces));
    const auto is_edge = [](int at, int size) { return at == 0 || at == size - 1; };
    for (int y = 0; y < parts.piece.rows; ++y) {
        for (int x = 0; x < parts.piece.cols; ++x) {
            Piece& piece = pieces[static_cast<std::size_t>(parts.piece(y, x))];
            ++piece.pixels;
            piece.on_edge += is_edge(y, parts.piece.rows) || is_edge(x, parts.piece.cols) ? 1 : 0;
            piece.has_shape = piece.has_shape || parts.shapes(y, x) != 0;
        }
    }
    pieces.front().has_shape = true;  // what is not part of the mask
    cv::Mat thin(parts.piece.size(), CV_8U);
    std::ranges::transform(parts.piece, thin.begin<uchar>(), [&](int number) {
        const Piece& piece = pieces[static_cast<std::size_t>(number)];
        const bool is_rim = greatest_width_px * piece.on_edge >= piece.pixels;
        return piece.has_shape || is_rim ? uchar{0} : uchar{255};
    });
    return thin;
}

/// The number of pixels of a colour, and the box around them.
struct ColourExtent {
    int pixels = 0;
    cv::Rect box;
};

std::array<ColourExtent, kMostColours> extents_of(const cv::Mat1b& map) {
    std::array<ColourExtent, kMostColours> extents{};
    for (int y = 0; y < map.rows; ++y) {
        for (int x = 0; x < map.cols; ++x) {
            ColourExtent& extent = extents[map(y, x)];
            if (extent.pixels++ == 0) {
                extent.box = {x, y, 1, 1};
                continue;
            }
            const int left = std::min(extent.box.x, x);
            const int right = std::max(extent.box.br().x, x + 1);
            extent.box = {left, extent.box.y, right - left, y + 1 - extent.box.y};
        }
    }
    return extents;
}

}  // namespace

ThinParts thin_parts_of(const cv::Mat1b& map, double greatest_width_px) {
    const auto extents = extents_of(map);
    const auto ground =
        std::ranges::max_element(extents, {}, &ColourExtent::pixels) - extents.begin();
    cv::Mat thin(map.size(), CV_8U, cv::Scalar(0));
    for (int colour = 0; colour < kMostColours; ++colour) {
        const ColourExtent& extent = extents[static_cast<std::size_t>(colour)];
        if (extent.pixels == 0) continue;
        // Adds a rim of other colours, so that the box's sides are not taken for more of the
        // colour.
        const cv::Rect box =
            (extent.box + cv::Size(4, 4) - cv::Point(2, 2)) & cv::Rect({}, map.size());
        const cv::Mat mask = map(box) == colour;
        const InkParts parts = parts_of_clean(mask, greatest_width_px);
        cv::Mat here = thin(box);
        here |= colour == ground ? wholly_thin(parts, greatest_width_px) : cv::Mat(parts.strokes);
    }
    ThinParts found{parts_of(thin, greatest_width_px).strokes, map.clone()};
    overgrow(found.map, found.strokes);
    return found;
}

}  // namespace touchline
