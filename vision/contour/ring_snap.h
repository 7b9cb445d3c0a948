// Draws a ring that lies roughly round a thing onto the thing's edge.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Moves each point along its normal to the strongest edge within `reach_px`, preferring near ones;
/// then the median of seven neighbours decides. Points on the picture's frame stay. `strength` is
/// the gradient's, at pixel centres; the ring's points are about a pixel apart. O(points x reach).
void snap(Chain& ring, const cv::Mat1f& strength, double reach_px);

/// Returns the strength at the nearest pixel; 0 outside.
[[nodiscard]] float strength_at(const cv::Mat1f& strength, const cv::Point2d& at);

/// Returns whether a place is within a pixel of the picture's frame, or beyond it.
[[nodiscard]] bool is_on_frame(const cv::Point2d& at, cv::Size size);

}  // namespace touchline
