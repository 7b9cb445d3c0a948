#include "vision/prepare/page_candidates.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int level_step = 12;        // grey levels between thresholds
constexpr double least_share = 0.03;  // of the picture
constexpr double frame_margin_px = 2.5;
constexpr int most_corners = 8;
constexpr double beyond = 5.0;  // a fifth of the picture further out

using Contour = std::vector<cv::Point>;

/// Returns the outline of the region's hull, coarser and coarser until it has at most four corners
/// or has become as coarse as a side may be.
Contour polygon_of(const Contour& region) {
    Contour hull;
    cv::convexHull(region, hull);
    const double length_px = cv::arcLength(hull, true);
    Contour polygon;
    for (double share = 0.01; share < 0.06; share *= 1.4) {
        cv::approxPolyDP(hull, polygon, share * length_px, true);
        if (polygon.size() <= 4) break;
    }
    return polygon;
}

bool is_on_frame(cv::Point a, cv::Point b, cv::Size size) {
    const auto both = [](int p, int q, double least, double most) {
        return (p < least && q < least) || (p > most && q > most);
    };
    return both(a.x, b.x, frame_margin_px, size.width - 1 - frame_margin_px) ||
           both(a.y, b.y, frame_margin_px, size.height - 1 - frame_margin_px);
}

/// Returns the frame's line beside which this side runs, moved out of the picture, because the page
/// ends somewhere beyond.
Line beyond_frame(cv::Point a, cv::Point b, cv::Size size) {
    const cv::Point2d middle = (cv::Point2d(a) + cv::Point2d(b)) / 2.0;
    const cv::Point2d centre((size.width - 1) / 2.0, (size.height - 1) / 2.0);
    const bool is_upright = std::abs(a.x - b.x) < std::abs(a.y - b.y);
    const cv::Point2d out(
        is_upright ? std::copysign(size.width / beyond, middle.x - centre.x) : 0.0,
        is_upright ? 0.0 : std::copysign(size.height / beyond, middle.y - centre.y));
    return {middle + out, is_upright ? cv::Point2d(0.0, 1.0) : cv::Point2d(1.0, 0.0)};
}

/// Sides along the frame are where the picture ends, not the page. If only a corner was cut off,
/// the neighbours of such a side are extended until they meet; otherwise the page ends beyond the
/// frame.
void add_pages(const Contour& polygon, cv::Size size, std::vector<Quad>& quads) {
    std::vector<Line> own;
    std::vector<Line> all;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const cv::Point a = polygon[i];
        const cv::Point b = polygon[(i + 1) % polygon.size()];
        const bool is_frame = is_on_frame(a, b, size);
        if (!is_frame) own.push_back(line_through(a, b));
        all.push_back(is_frame ? beyond_frame(a, b, size) : line_through(a, b));
    }
    const auto add = [&](const std::vector<Line>& sides) {
        if (sides.size() != 4) return;
        const auto quad = quad_of({sides[0], sides[1], sides[2], sides[3]});
        if (quad && is_sheet_like(*quad)) quads.push_back(ordered(*quad));
    };
    add(own);
    if (own.size() != all.size() && own.size() >= 2) add(all);
}

}  // namespace

std::vector<Quad> bright_regions(const cv::Mat1b& light) {
    std::vector<Quad> quads;
    double darkest = 0.0;
    double brightest = 0.0;
    cv::minMaxLoc(light, &darkest, &brightest);
    const double least_px = least_share * static_cast<double>(light.total());
    const cv::Mat kernel = cv::getStructuringElement(cv::MORPH_RECT, {5, 5});
    for (double level = darkest + level_step; level < brightest; level += level_step) {
        cv::Mat mask = light > level;
        cv::morphologyEx(mask, mask, cv::MORPH_OPEN, kernel);
        std::vector<Contour> regions;
        cv::findContours(mask, regions, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
        for (const Contour& region : regions) {
            if (cv::contourArea(region) < least_px) continue;
            const Contour polygon = polygon_of(region);
            if (polygon.size() < 4 || polygon.size() > most_corners) continue;
            add_pages(polygon, light.size(), quads);
        }
    }
    return quads;
}

}  // namespace touchline
