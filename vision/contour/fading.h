// Areas of a flat picture that fade into one another: shadows and gradients.
// Threads: pure function.
#pragma once

#include "vision/contour/gradient.h"

#include <vector>

namespace touchline {

/// Regions of the map whose common border is no step, but part of a slow change of colour, become
/// one, with a colour of its own at the end of the palette; the ground keeps its colour. Not where
/// both are of one even colour each, for a step may be blurred, nor where the two meet in a step
/// elsewhere: a shape that fades into the ground on one side stays whole. Gives where such borders
/// that are left run without a step, 255 there, a pixel to each side.
/// At most 256 colours; what is beyond stays apart. More than 1500 regions are grain and stay as
/// they are. O(pixels + regions squared).
[[nodiscard]] cv::Mat1b join_fading(cv::Mat1b& map, std::vector<cv::Vec3f>& palette,
                                    const LabPicture& lab);

}  // namespace touchline
