// Restores corners that smoothing has rounded.
// Threads: pure function, O(points).
#pragma once

#include "vision/contour/chain.h"

#include <functional>

namespace touchline {

/// The blur of a drawing's edges, from the program or scanner that made it (Gaussian sigma).
inline constexpr double drawing_blur_px = 0.7;

/// Replaces a rounded stretch by the crossing of the courses before and after it, a fixed point, if
/// the line turns by more than 35 degrees within the reach of the blur and both courses are
/// straight. Courses are lines fitted beyond the blur. A corner that is rounder than `blur_px`
/// explains (Gaussian sigma of picture and smoothing together) is really round and stays as it is.
/// Fixed points stay, as does a chain without length or points. `accepts` gets a corner's place and
/// its turn in radians; a corner that it refuses stays as it is.
[[nodiscard]] Chain with_sharp_corners(
    const Chain& chain, double blur_px,
    const std::function<bool(const cv::Point2d&, double)>& accepts = [](const cv::Point2d&,
                                                                        double) { return true; });

}  // namespace touchline
