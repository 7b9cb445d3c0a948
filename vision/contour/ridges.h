// A map of how likely a boundary is, as a field whose lines can be followed like a gradient's.
// Threads: pure function, O(pixels).
#pragma once

#include "vision/contour/edge_lines.h"

namespace touchline {

inline constexpr double kRidgeSmoothing_px = 1.5;

/// Boundaries are followed from one half (as likely as not) down to one fifth.
inline constexpr Hysteresis kRidgeLimits{0.2, 0.5};

/// strength: the probability (0..1), smoothed by kRidgeSmoothing_px; normal: the direction in which
/// it is most convex, across the ridge; no light side.
[[nodiscard]] GradientField ridges_of(const cv::Mat1f& probability);

}  // namespace touchline
