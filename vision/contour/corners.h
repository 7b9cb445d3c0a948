// Corners that smoothing has rounded, put back.
// Threads: pure function, O(points).
#pragma once

#include "vision/contour/chain.h"

#include <functional>

namespace touchline {

/// The blur of a drawing's edges, by whatever painted or scanned it (Gaussian sigma).
inline constexpr double kDrawingBlur_px = 0.7;

/// Where a line turns by more than 35 degrees within the reach of the blur and its course before
/// and after is straight, the rounded stretch is replaced by the crossing of the two courses, a
/// fixed point. Courses are lines fitted beyond the blur. A corner that is rounder than `blur_px`
/// (Gaussian sigma of picture and smoothing together) explains is a round one and stays as it is.
/// Fixed points stay, and a chain without length or points. A corner that `accepts`, asked with its
/// place and the turn in radians, refuses stays as it is.
[[nodiscard]] Chain with_sharp_corners(
    const Chain& chain, double blur_px,
    const std::function<bool(const cv::Point2d&, double)>& accepts = [](const cv::Point2d&,
                                                                        double) { return true; });

}  // namespace touchline
