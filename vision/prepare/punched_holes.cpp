#include "vision/prepare/punched_holes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double kLeastHole = 0.012;  // of the longer side: across
constexpr double kMostHole = 0.05;
constexpr double kHoleFromEdge = 0.1;  // of the picture across: its middle lies no further in
constexpr double kEvenHoles = 0.03;    // of the side: how even they lie about its middle
constexpr double kSameHole = 0.15;     // of the hole across
constexpr double kInRow_px = 4.0;      // as far from the edge
constexpr double kSoftRim_px = 3.0;
constexpr std::size_t kMostHoles = 6;

struct Hole {
    cv::Point2d middle;
    double across_px = 0.0;
};

std::vector<Hole> discs_of(const cv::Mat1b& ink) {
    cv::Mat1i label;
    cv::Mat1i stats;
    cv::Mat1d centres;
    const int n = cv::connectedComponentsWithStats(ink, label, stats, centres, 8, CV_32S);
    const double longer = std::max(ink.cols, ink.rows);
    std::vector<Hole> found;
    for (int i = 1; i < n; ++i) {
        const int width = stats(i, cv::CC_STAT_WIDTH);
        const int height = stats(i, cv::CC_STAT_HEIGHT);
        const double across = 0.5 * (width + height);
        const double round =
            stats(i, cv::CC_STAT_AREA) / (0.25 * std::numbers::pi * width * height);
        if (across >= kLeastHole * longer && across <= kMostHole * longer &&
            std::abs(width - height) <= 0.1 * across + 1.0 && round > 0.9 && round < 1.15) {
            found.push_back({{centres(i, 0), centres(i, 1)}, across});
        }
    }
    return found;
}

/// The place of a hole beside a side of the sheet.
struct Beside {
    double along_px = 0.0;  // from the middle of the side
    double in_px = 0.0;     // from its edge
};

Beside beside(std::size_t side, const Hole& hole, cv::Size whole, const SheetEdges& edges) {
    const SideView& view = kSides[side];
    const cv::Size size = view.is_transposed ? cv::Size(whole.height, whole.width) : whole;
    const cv::Point2d at =
        view.is_transposed ? cv::Point2d(hole.middle.y, hole.middle.x) : hole.middle;
    const double in = view.is_flipped ? size.width - 1 - at.x : at.x;
    const auto depth = [&](std::size_t other, double row) {
        return edges[other] ? std::max(0.0, edges[other]->at(row)) : 0.0;
    };
    const std::size_t before = view.is_transposed ? 0 : 1;  // the sides that this one runs to
    const double middle = 0.5 * (size.height + depth(before, at.x) - depth(before + 2, at.x));
    return {at.y - middle, in - depth(side, at.y)};
}

bool are_punched(const std::vector<Hole>& row, const std::vector<Beside>& places, double side_px) {
    if (row.size() < 2 || row.size() > kMostHoles) {
        return false;
    }
    double sum_px = 0.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        sum_px += places[i].along_px;
        const double first_px = row.front().across_px;
        if (std::abs(row[i].across_px - first_px) > kSameHole * first_px + 1.0 ||
            std::abs(places[i].in_px - places.front().in_px) > kInRow_px) {
            return false;
        }
    }
    return std::abs(sum_px) <= kEvenHoles * side_px * static_cast<double>(row.size());
}

}  // namespace

cv::Mat1b punched_holes(const cv::Mat1b& ink, const SheetEdges& edges) {
    cv::Mat1b punched(ink.size(), uchar{0});
    const std::vector<Hole> discs = discs_of(ink);
    for (std::size_t side = 0; side < kSides.size(); ++side) {
        const bool is_upright = !kSides[side].is_transposed;
        const double across_px = is_upright ? ink.cols : ink.rows;
        const double side_px = is_upright ? ink.rows : ink.cols;
        std::vector<Hole> row;
        std::vector<Beside> places;
        for (const Hole& disc : discs) {
            const Beside place = beside(side, disc, ink.size(), edges);
            if (place.in_px <= kHoleFromEdge * across_px) {
                row.push_back(disc);
                places.push_back(place);
            }
        }
        if (are_punched(row, places, side_px)) {
            for (const Hole& hole : row) {
                cv::circle(punched, cv::Point(hole.middle),
                           cvRound(0.5 * hole.across_px + kSoftRim_px), cv::Scalar(255),
                           cv::FILLED);
            }
        }
    }
    return punched;
}

}  // namespace touchline
