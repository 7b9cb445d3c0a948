// Joins areas of a flat picture that fade into one another: shadows and gradients.
// Threads: pure function.
#pragma once

#include "vision/contour/gradient.h"

#include <vector>

namespace touchline {

/// Joins regions of the map if their common border is no step, but part of a slow change of colour.
/// Each joined region gets its own colour at the end of the palette; the ground keeps its colour.
/// Does not join two regions of one even colour each, because a step may be blurred, nor two that
/// meet in a step elsewhere: a shape that fades into the ground on one side stays whole. Returns
/// 255 where remaining borders run without a step, a pixel to each side.
/// At most 256 colours; regions beyond that stay apart. More than 1500 regions are grain and stay
/// as they are. O(pixels + regions squared).
[[nodiscard]] cv::Mat1b join_fading(cv::Mat1b& map, std::vector<cv::Vec3f>& palette,
                                    const LabPicture& lab);

}  // namespace touchline
