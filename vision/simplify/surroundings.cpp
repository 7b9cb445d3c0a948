#include "vision/simplify/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double kCell_mm = 0.5;
constexpr double kDisc_mm = 0.75;       // radius
constexpr double kLeastWall_mm = 15.0;  // shorter lines hide nothing
constexpr int kRim = 12;                // cells around the area, so that the outside is connected

cv::Point cell_of(cv::Point2d p) {
    return {kRim + static_cast<int>(std::lround(p.x / kCell_mm)),
            kRim + static_cast<int>(std::lround(p.y / kCell_mm))};
}

/// Non-zero where there is no line.
cv::Mat1b free_cells(const std::vector<Chain>& lines, cv::Size2d area_mm) {
    const cv::Point far = cell_of({area_mm.width, area_mm.height});
    cv::Mat1b cells(far.y + kRim + 1, far.x + kRim + 1, uchar{255});
    for (const Chain& line : lines) {
        if (length_of(line) < kLeastWall_mm) {
            continue;
        }
        std::vector<cv::Point> points;
        for (const EdgePoint& p : line.points) {
            points.push_back(cell_of(p.at));
        }
        cv::polylines(cells, points, line.is_closed, cv::Scalar(0), 1, cv::LINE_8);
    }
    return cells;
}

/// Returns the distances from the left, right, upper and lower edge of the picture.
std::array<double, 4> from_edges(const cv::Point2d& at, const cv::Rect2d& picture_mm) {
    return {at.x - picture_mm.x, picture_mm.br().x - at.x, at.y - picture_mm.y,
            picture_mm.br().y - at.y};
}

/// Returns the share of its points that lie within `reach_mm` of an edge of the picture.
double share_beside(const Chain& line, const cv::Rect2d& picture_mm, double reach_mm) {
    const auto beside = std::ranges::count_if(line.points, [&](const EdgePoint& p) {
        return std::ranges::min(from_edges(p.at, picture_mm)) < reach_mm;
    });
    return static_cast<double>(beside) / static_cast<double>(line.points.size());
}

int sides_near(const Chain& line, const cv::Rect2d& picture_mm, double reach_mm) {
    int sides = 0;
    for (std::size_t side = 0; side < 4; ++side) {
        sides += std::ranges::any_of(line.points, [&](const EdgePoint& p) {
            return from_edges(p.at, picture_mm)[side] < reach_mm;
        });
    }
    return sides;
}

}  // namespace

Outside::Outside(const std::vector<Chain>& lines, cv::Size2d area_mm) {
    cv::Mat1f to_line;
    cv::distanceTransform(free_cells(lines, area_mm), to_line, cv::DIST_L2, 5);
    cv::Mat passable = to_line > kDisc_mm / kCell_mm;
    constexpr uchar kOutside = 128;
    cv::floodFill(passable, cv::Point(0, 0), cv::Scalar(kOutside), nullptr, {}, {}, 8);
    cv::distanceTransform(passable != kOutside, to_outside_, cv::DIST_L2, 5);
}

double Outside::share_of(const Chain& line) const {
    constexpr float kReached = static_cast<float>(kDisc_mm / kCell_mm + 1.5);
    const auto reached = std::ranges::count_if(
        line.points, [&](const EdgePoint& p) { return to_outside_(cell_of(p.at)) < kReached; });
    return static_cast<double>(reached) / static_cast<double>(line.points.size());
}

std::vector<double> Outside::shares_of(const std::vector<Chain>& lines) const {
    std::vector<double> shares(lines.size());
    std::ranges::transform(lines, shares.begin(),
                           [&](const Chain& line) { return share_of(line); });
    return shares;
}

double Outside::share_on_both_sides(const Chain& line) const {
    constexpr double kBeside_mm = 2.0;
    const auto is_out = [&](cv::Point2d p) {
        const cv::Point cell = cell_of(p);
        return !cv::Rect({}, to_outside_.size()).contains(cell) || to_outside_(cell) <= 0.0F;
    };
    std::size_t both = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const cv::Point2d at = line.points[i].at;
        const cv::Point2d along = at - line.points[i - 1].at;
        const cv::Point2d beside =
            kBeside_mm / std::max(1e-9, cv::norm(along)) * cv::Point2d(-along.y, along.x);
        both += is_out(at + beside) && is_out(at - beside) ? 1U : 0U;
    }
    return static_cast<double>(both) / static_cast<double>(line.points.size());
}

bool is_frame(const Chain& line, const cv::Rect2d& picture_mm) {
    const double reach_mm = 0.04 * std::min(picture_mm.width, picture_mm.height);
    return share_beside(line, picture_mm, reach_mm) >= 0.9 &&
           sides_near(line, picture_mm, reach_mm) >= 3;
}

bool is_rim(const Chain& line, const cv::Rect2d& picture_mm) {
    constexpr double kUneven_mm = 0.1;
    return share_beside(line, picture_mm, 0.5 * line.width_px + kUneven_mm) >= 0.9;
}

bool is_met(const Chain& line, const std::vector<Chain>& others) {
    constexpr double kMet_mm = 1.0;
    const auto ends_on_it = [&](const EdgePoint& end) {
        return std::ranges::any_of(
            line.points, [&](const EdgePoint& p) { return distance(p.at, end.at) <= kMet_mm; });
    };
    return std::ranges::any_of(others, [&](const Chain& other) {
        return !other.is_closed &&
               (ends_on_it(other.points.front()) || ends_on_it(other.points.back()));
    });
}

double held_area(const Chain& line) {
    double twice = 0.0;
    for (std::size_t i = 0; line.is_closed && i < line.points.size(); ++i) {
        twice += line.points[i].at.cross(line.points[(i + 1) % line.points.size()].at);
    }
    return 0.5 * std::abs(twice);
}

}  // namespace touchline
