// The few colours that a flat picture is made of.
// Threads: pure function.
#pragma once

#include "vision/contour/gradient.h"

#include <vector>

namespace touchline {

/// At most 64 colours, the commonest first, at least 16 grey levels apart: the peaks of the
/// histogram (bins of 8) of all pixels that are like their neighbours. Colours of less than 0.05 %
/// of the picture are left out. Never empty. O(pixels).
[[nodiscard]] std::vector<cv::Vec3f> palette_of(const LabPicture& lab, double noise);

/// The nearest colour of the palette for each pixel. O(pixels).
[[nodiscard]] cv::Mat1b nearest_colours(const LabPicture& lab,
                                        const std::vector<cv::Vec3f>& palette);

}  // namespace touchline
