#include "vision/prepare/quad.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

double signed_area(const Quad& quad) {
    double twice = 0.0;
    for (std::size_t i = 0; i < 4; ++i) twice += quad[i].cross(quad[(i + 1) % 4]);
    return twice / 2.0;
}

constexpr double snap_share = 0.03;
constexpr double least_focal = 0.5;
constexpr double greatest_focal = 3.0;

cv::Matx33d homography(const std::vector<cv::Point2f>& from, const std::vector<cv::Point2f>& to) {
    return cv::getPerspectiveTransform(from, to);
}

std::vector<cv::Point2f> points_of(const Quad& quad, cv::Point2d origin = {}) {
    std::vector<cv::Point2f> points;
    for (const cv::Point2d corner : quad) points.emplace_back(corner - origin);
    return points;
}

/// Returns the square of the focal length, in units of the longer side. It follows from the right
/// angle between the two directions of the page.
double focal_squared(const cv::Matx33d& h) {
    const double perspective = h(2, 0) * h(2, 1);
    const double squared = -(h(0, 0) * h(0, 1) + h(1, 0) * h(1, 1)) / perspective;
    const bool is_told = std::abs(perspective) > 1e-4 && squared >= least_focal * least_focal &&
                         squared <= greatest_focal * greatest_focal;
    return is_told ? squared : usual_focal_share * usual_focal_share;
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

double aspect_of(const Quad& corners, cv::Size picture) {
    const double unit = std::max(picture.width, picture.height);
    Quad scaled = corners;
    for (cv::Point2d& corner : scaled) corner /= unit;
    const cv::Point2d middle((picture.width - 1) / (2.0 * unit),
                             (picture.height - 1) / (2.0 * unit));
    const cv::Matx33d h = homography({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, points_of(scaled, middle));
    const double focal2 = focal_squared(h);
    const auto length2 = [&](int column) {
        return (h(0, column) * h(0, column) + h(1, column) * h(1, column)) / focal2 +
               h(2, column) * h(2, column);
    };
    return std::sqrt(length2(0) / length2(1));
}

double snapped_aspect(double aspect) {
    for (const double known : {1.0 / a4_aspect, 1.0 / letter_aspect, a4_aspect, letter_aspect})
        if (std::abs(aspect / known - 1.0) <= snap_share) return known;
    return aspect;
}

cv::Mat rectified(const cv::Mat& bgr, const Quad& corners, double aspect, double most_pixels) {
    const double pixels = std::min(most_pixels, std::max(1.0, area_of(corners)));
    const cv::Size size(std::max(1, static_cast<int>(std::sqrt(pixels * aspect))),
                        std::max(1, static_cast<int>(std::sqrt(pixels / aspect))));
    // If many pixels become one, they are averaged first, because warping would pick one of them.
    const double reduction = std::sqrt(pixels / std::max(1.0, area_of(corners)));
    cv::Mat source = bgr;
    if (reduction < 0.7) cv::resize(bgr, source, {}, reduction, reduction, cv::INTER_AREA);
    const double right = size.width - 0.5;
    const double bottom = size.height - 0.5;
    const Quad page{{{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}}};
    const cv::Matx33d to_source =
        homography(points_of(page), points_of(rescaled(corners, bgr.size(), source.size())));
    cv::Mat out;
    cv::warpPerspective(source, out, to_source, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                        cv::BORDER_REPLICATE);
    return out;
}

}  // namespace touchline
