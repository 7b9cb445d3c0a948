#include "vision/prepare/rectify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

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
