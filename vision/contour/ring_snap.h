// A ring that lies about where a thing ends, drawn onto its edge.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Each point moves along its normal to the strongest edge within `reach_px`, near before far; then
/// seven neighbours agree by their middle one. Points on the picture's frame stay. `strength`: of
/// the gradient, at pixel centres; the ring's points about a pixel apart. O(points x reach).
void snap(Chain& ring, const cv::Mat1f& strength, double reach_px);

/// The strength at the nearest pixel; 0 outside.
[[nodiscard]] float strength_at(const cv::Mat1f& strength, const cv::Point2d& at);

/// Whether a place is within a pixel of the picture's frame, or beyond it.
[[nodiscard]] bool is_on_frame(const cv::Point2d& at, cv::Size size);

}  // namespace touchline
