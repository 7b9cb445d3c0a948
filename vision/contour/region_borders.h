// Traces the borders of a map of regions as sub-pixel lines.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"
#include "vision/contour/gradient.h"

namespace touchline {

/// Marching squares with any number of colours: a line crosses between two neighbouring pixels of
/// different colour where the picture is half-way from the one to the other, and runs from cell to
/// cell. A cell with three or four crossings that belong to three or four colours is a junction:
/// the lines end there in one fixed point, the same bit for bit; two colours in a checkerboard are
/// two lines that do not meet. So no line has a loose end except at the frame, none is doubled, and
/// none crosses another. In order of first row, column. O(pixels).
[[nodiscard]] std::vector<Chain> region_borders(const cv::Mat1b& map, const LabPicture& lab,
                                                const std::vector<cv::Vec3f>& palette);

}  // namespace touchline
