// Which pixel belongs to which colour, once the mixtures along edges and the specks are gone.
// Threads: pure function.
#pragma once

#include "vision/contour/gradient.h"

#include <vector>

namespace touchline {

/// For each pixel the place of its colour in the palette, as nearest_colours says, but a pixel at
/// an edge whose colour is a mixture of two colours beside it belongs to the nearer of the two,
/// though a third may look like it (black on white has grey edges). O(pixels).
[[nodiscard]] cv::Mat1b region_map(const LabPicture& lab, const std::vector<cv::Vec3f>& palette);

/// Regions (4-connected) of fewer than `least_px` pixels are given to what lies beside them, where
/// there are larger ones. O(pixels).
void overgrow_specks(cv::Mat1b& map, int least_px);

/// The pixels of the mask given to what lies beside them, all at the same pace; none stay where
/// nothing else is. O(pixels).
void overgrow(cv::Mat1b& map, const cv::Mat1b& mask);

}  // namespace touchline
