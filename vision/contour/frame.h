// Lines and the frame of the picture, which runs along the pixel edges: -0.5 and size - 0.5.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

#include <optional>

namespace touchline {

/// Returns where a ray (`way`: unit vector) from inside the picture leaves it, exactly on the side
/// through which it leaves; nothing if that is `far_px` away or more.
[[nodiscard]] std::optional<cv::Point2d> exit_near(const cv::Point2d& from, const cv::Point2d& way,
                                                   cv::Size picture, double far_px);

/// Closes a line with both ends exactly on the frame along it, the shorter way, through the corners
/// on that way (fixed points). It does so if the way is less than 0.7 of the line's length, or if
/// it passes one corner and the shape is as round as a quarter disc, not a strip or a triangle: a
/// shape cut off by the frame is one shape, a horizon is not. O(points).
void close_along_frame(std::vector<Chain>& chains, cv::Size picture);

}  // namespace touchline
