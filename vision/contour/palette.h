// Finds the few colours of a flat picture.
// Threads: pure function.
#pragma once

#include "vision/contour/gradient.h"

#include <vector>

namespace touchline {

/// Returns at most 64 colours, the commonest first, at least 16 grey levels apart: the peaks of the
/// histogram (bins of 8) of all pixels that are like their neighbours. Leaves out colours of less
/// than 0.05 % of the picture, or of 0.6 % of one within 45 grey levels. Never empty. O(pixels).
[[nodiscard]] std::vector<cv::Vec3f> palette_of(const LabPicture& lab, double noise);

/// Returns the nearest colour of the palette for each pixel. O(pixels).
[[nodiscard]] cv::Mat1b nearest_colours(const LabPicture& lab,
                                        const std::vector<cv::Vec3f>& palette);

}  // namespace touchline
