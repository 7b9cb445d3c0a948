// A face as the points that a network lays on it. Threads: plain values and pure functions.
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

}  // namespace touchline
