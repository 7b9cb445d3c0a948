#include "vision/prepare/quad.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace touchline {
namespace {

double signed_area(const Quad& quad) {
    double twice = 0.0;
    for (std::size_t i = 0; i < 4; ++i) twice += quad[i].cross(quad[(i + 1) % 4]);
    return twice / 2.0;
}

}  // namespace

Quad ordered(Quad quad) {
    if (signed_area(quad) < 0.0) std::reverse(quad.begin(), quad.end());
    const auto height = [&](std::size_t side) { return quad[side].y + quad[(side + 1) % 4].y; };
    std::size_t top = 0;
    for (std::size_t side = 1; side < 4; ++side)
        if (height(side) < height(top)) top = side;
    std::rotate(quad.begin(), quad.begin() + static_cast<std::ptrdiff_t>(top), quad.end());
    return quad;
}

double area_of(const Quad& quad) {
    return std::abs(signed_area(quad));
}

bool is_sheet_like(const Quad& quad) {
    const double sine_least = std::sin(CV_PI / 4);
    const double sign = signed_area(quad) < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const cv::Point2d in = quad[(i + 1) % 4] - quad[i];
        const cv::Point2d out = quad[(i + 2) % 4] - quad[(i + 1) % 4];
        if (!(sign * in.cross(out) >= sine_least * cv::norm(in) * cv::norm(out))) return false;
    }
    return true;
}

Quad rescaled(const Quad& quad, cv::Size from, cv::Size to) {
    const double sx = static_cast<double>(to.width) / from.width;
    const double sy = static_cast<double>(to.height) / from.height;
    Quad out;
    for (std::size_t i = 0; i < 4; ++i)
        out[i] = {(quad[i].x + 0.5) * sx - 0.5, (quad[i].y + 0.5) * sy - 0.5};
    return out;
}

Line line_through(cv::Point2d a, cv::Point2d b) {
    const double length = cv::norm(b - a);
    return {a, length > 0.0 ? (b - a) / length : cv::Point2d(1.0, 0.0)};
}

std::optional<cv::Point2d> crossing(const Line& a, const Line& b) {
    const double sine = a.direction.cross(b.direction);
    if (std::abs(sine) < std::sin(CV_PI / 12)) return std::nullopt;
    return a.point + a.direction * ((b.point - a.point).cross(b.direction) / sine);
}

std::optional<Quad> quad_of(const std::array<Line, 4>& sides) {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto corner = crossing(sides[(i + 3) % 4], sides[i]);
        if (!corner) return std::nullopt;
        quad[i] = *corner;
    }
    return quad;
}

}  // namespace touchline
