#include "vision/prepare/fiducials.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

/// Rows from the top, a bright cell is 1, the leftmost is the highest bit.
constexpr std::array<std::uint16_t, fiducial_count> codes{0xb532, 0x0f9a, 0x332d, 0x9946};
constexpr int inner = 4;          // cells in a row
constexpr int cells = inner + 2;  // with the dark border
constexpr int sample_px = 8;      // of a cell, when it is read
constexpr int most_misread = 1;   // any two codes differ in four cells at least
constexpr double searched_pixels = 1e6;
constexpr double least_side_px = 14.0;
constexpr int corner_window_px = 3;

int bit_of(std::uint16_t code, int row, int column) {
    return code >> (inner * inner - 1 - inner * row - column) & 1;
}

/// The mark turned by a quarter, clockwise, against its corners.
std::uint16_t turned(std::uint16_t code) {
    unsigned out = 0;
    for (int row = 0; row < inner; ++row)
        for (int column = 0; column < inner; ++column)
            out = out << 1U | static_cast<unsigned>(bit_of(code, inner - 1 - column, row));
    return static_cast<std::uint16_t>(out);
}

/// The cells inside the quad as a code; nothing when its border is not dark all round.
std::optional<std::uint16_t> read(const cv::Mat1b& grey, const Quad& quad) {
    const int side_px = cells * sample_px;
    const auto last = static_cast<float>(side_px);
    const std::vector<cv::Point2f> to{{0, 0}, {last, 0}, {last, last}, {0, last}};
    const std::vector<cv::Point2f> from(quad.begin(), quad.end());
    cv::Mat flat;
    cv::warpPerspective(grey, flat, cv::getPerspectiveTransform(from, to), {side_px, side_px});
    cv::threshold(flat, flat, 0, 255, cv::THRESH_OTSU);
    unsigned code = 0;
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            // The middle of a cell: its rim may be blurred, or cut a little askew.
            const cv::Rect middle(column * sample_px + 2, row * sample_px + 2, sample_px - 4,
                                  sample_px - 4);
            const bool is_bright = cv::mean(flat(middle))[0] > 127.0;
            const bool is_border =
                row == 0 || column == 0 || row == cells - 1 || column == cells - 1;
            if (is_border && is_bright) return std::nullopt;
            if (!is_border) code = code << 1U | (is_bright ? 1U : 0U);
        }
    return static_cast<std::uint16_t>(code);
}

std::optional<Fiducial> recognised(const cv::Mat1b& grey, Quad quad) {
    const auto seen = read(grey, quad);
    if (!seen) return std::nullopt;
    for (int id = 0; id < fiducial_count; ++id) {
        std::uint16_t code = codes[static_cast<std::size_t>(id)];
        for (std::ptrdiff_t quarter = 0; quarter < 4; ++quarter, code = turned(code)) {
            const auto misread = static_cast<unsigned>(*seen ^ code);
            if (std::popcount(misread) > most_misread) continue;
            // A mark turned by a quarter has its upper left at the picture's upper right.
            std::rotate(quad.begin(), quad.begin() + quarter, quad.end());
            return Fiducial{id, quad};
        }
    }
    return std::nullopt;
}

/// Dark four-sided regions, clockwise.
std::vector<Quad> dark_quads(const cv::Mat1b& grey, int window_px) {
    cv::Mat mask;
    cv::adaptiveThreshold(grey, mask, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV,
                          window_px, 7);
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(mask, contours, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
    std::vector<Quad> quads;
    for (const auto& contour : contours) {
        const double length_px = cv::arcLength(contour, true);
        if (length_px < 4.0 * least_side_px) continue;
        std::vector<cv::Point> polygon;
        cv::approxPolyDP(contour, polygon, 0.04 * length_px, true);
        if (polygon.size() != 4 || !cv::isContourConvex(polygon)) continue;
        if (cv::contourArea(polygon) < least_side_px * least_side_px) continue;
        Quad quad;
        std::copy(polygon.begin(), polygon.end(), quad.begin());
        quads.push_back(ordered(quad));
    }
    return quads;
}

void sharpen_corners(const cv::Mat1b& grey, Quad& corners) {
    std::vector<cv::Point2f> points(corners.begin(), corners.end());
    cv::cornerSubPix(grey, points, {corner_window_px, corner_window_px}, {-1, -1},
                     {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 20, 0.01});
    std::copy(points.begin(), points.end(), corners.begin());
}

}  // namespace

std::vector<Fiducial> find_fiducials(const cv::Mat& bgr) {
    const double scale =
        std::min(1.0, std::sqrt(searched_pixels / static_cast<double>(bgr.total())));
    cv::Mat small;
    cv::resize(bgr, small, {}, scale, scale, cv::INTER_AREA);
    cv::Mat1b grey;
    cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
    std::array<std::optional<Fiducial>, fiducial_count> best;
    for (const int window_px : {15, 51}) {  // for small marks, and for large ones
        for (const Quad& quad : dark_quads(grey, window_px)) {
            auto mark = recognised(grey, quad);
            if (!mark) continue;
            auto& known = best[static_cast<std::size_t>(mark->id)];
            if (!known || area_of(mark->corners) > area_of(known->corners)) known = mark;
        }
    }
    std::vector<Fiducial> found;
    for (auto& mark : best) {
        if (!mark) continue;
        sharpen_corners(grey, mark->corners);
        mark->corners = rescaled(mark->corners, grey.size(), bgr.size());
        found.push_back(*mark);
    }
    return found;
}

cv::Mat1b fiducial_drawing(int id, int cell_px) {
    cv::Mat1b drawing(cells * cell_px, cells * cell_px, std::uint8_t{0});
    const std::uint16_t code = codes[static_cast<std::size_t>(id)];
    for (int row = 0; row < inner; ++row)
        for (int column = 0; column < inner; ++column)
            if (bit_of(code, row, column) != 0)
                drawing(cv::Rect((column + 1) * cell_px, (row + 1) * cell_px, cell_px, cell_px)) =
                    std::uint8_t{255};
    return drawing;
}

}  // namespace touchline
