// A face as the points that a network lays on it, and boxes of any numbers in a picture, because
// they come from networks.
// Threads: plain values and pure functions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/core.hpp>

namespace touchline {

/// Pixels of the picture, in the order of MediaPipe's FaceMesh. Its numbers count from 0: 10 is the
/// top of the forehead, 152 the chin, 1 the tip of the nose, 234 and 454 the sides of the face, 33
/// and 263 the outer corners of the eyes; 33 and 234 are on the left as long as the head is
/// upright.
using FaceMesh = std::array<cv::Point2d, 468>;

/// Returns the upright box that holds it. O(points).
[[nodiscard]] inline cv::Rect2d box_of(const FaceMesh& mesh) {
    const auto [left, right] = std::ranges::minmax(mesh, {}, &cv::Point2d::x);
    const auto [top, bottom] = std::ranges::minmax(mesh, {}, &cv::Point2d::y);
    return {left.x, top.y, right.x - left.x, bottom.y - top.y};
}

[[nodiscard]] inline cv::Point2d centre_of(const cv::Rect2d& box) {
    return 0.5 * (box.tl() + box.br());
}

/// Returns how far to turn the picture's upright to get the face's: the angle of the line through
/// the outer corners of the eyes, radians, y down, positive clockwise as seen.
[[nodiscard]] inline double tilt_of(const FaceMesh& mesh) {
    const cv::Point2d across = mesh[263] - mesh[33];
    return std::atan2(across.y, across.x);
}

/// Returns the part of the box that lies in the picture, pixels. Empty if there is none, if a side
/// of the box is negative, or if its numbers are NaN.
[[nodiscard]] inline cv::Rect2d box_within(const cv::Rect2d& box, cv::Size picture) {
    const double left = std::max(box.x, 0.0);
    const double top = std::max(box.y, 0.0);
    const double right = std::min(box.x + box.width, static_cast<double>(picture.width));
    const double bottom = std::min(box.y + box.height, static_cast<double>(picture.height));
    if (!(right > left && bottom > top)) return {};
    return {left, top, right - left, bottom - top};
}

/// The same in whole pixels. It rounds corners: a rounded side beside a rounded corner may end
/// beyond the picture.
[[nodiscard]] inline cv::Rect part_within(const cv::Rect2d& box, cv::Size picture) {
    const cv::Rect2d within = box_within(box, picture);
    return cv::Rect(cv::Point(within.tl()), cv::Point(within.br())) & cv::Rect({}, picture);
}

}  // namespace touchline
