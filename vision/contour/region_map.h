// Assigns each pixel to a colour, without the mixtures along edges and the specks.
// Threads: pure function.
#pragma once

#include "vision/contour/gradient.h"

#include <vector>

namespace touchline {

/// Returns for each pixel the index of its colour in the palette, as nearest_colours says, except
/// that a pixel at an edge whose colour is a mixture of two colours beside it belongs to the nearer
/// of the two, although a third may look like it (black on white has grey edges). O(pixels).
[[nodiscard]] cv::Mat1b region_map(const LabPicture& lab, const std::vector<cv::Vec3f>& palette);

/// Gives regions (4-connected) of fewer than `least_px` pixels to what lies beside them, if there
/// are larger ones. O(pixels).
void overgrow_specks(cv::Mat1b& map, int least_px);

/// Gives the pixels of the mask to what lies beside them, all at the same pace; none stay, unless
/// there is nothing else. O(pixels).
void overgrow(cv::Mat1b& map, const cv::Mat1b& mask);

}  // namespace touchline
