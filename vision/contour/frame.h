// Lines and the frame of the picture: pixel edges, so -0.5 and size - 0.5.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

#include <optional>

namespace touchline {

/// Where a ray (`way`: unit vector) from inside the picture leaves it, exactly on the side that it
/// leaves by; nothing if that is `far_px` away or more.
[[nodiscard]] std::optional<cv::Point2d> exit_near(const cv::Point2d& from, const cv::Point2d& way,
                                                   cv::Size picture, double far_px);

/// A line with both ends exactly on the frame is closed along it, the shorter way, through the
/// corners on that way (fixed points), if the way is less than 0.7 of the line's length, or if it
/// passes one corner and the shape is as round as a quarter disc, not a strip or a triangle: what
/// the frame cuts off is one shape, a horizon is not. O(points).
void close_along_frame(std::vector<Chain>& chains, cv::Size picture);

}  // namespace touchline
