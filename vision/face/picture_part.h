// The part of a box that lies in a picture. Numbers may be anything, because boxes come from
// networks.
// Threads: pure functions, O(1).
#pragma once

#include <algorithm>

#include <opencv2/core.hpp>

namespace touchline {

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
