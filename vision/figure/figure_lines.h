// The lines of a photograph with its figure: a ring round it, what lies in it, what lies behind it.
// Threads: pure function.
#pragma once

#include "vision/contour/photo_lines.h"

namespace touchline {

/// Adds to a photo's lines (of `picture`, 8-bit BGR or grey) the rings of a mask of the same
/// proportions (128 and more: figure), each drawn onto the strongest edge within a millimetre and a
/// half: LineOf::ring, holes too, as strong as the strongest line, open where the picture's frame
/// cuts the figure. What of the lines lies in the figure, 3.2 mm and more from its rings, stays as
/// it is; what lies as far outside is LineOf::background; what runs along a ring goes. Without a
/// place of 128 nothing changes. O(pixels).
[[nodiscard]] PhotoLines with_figure(PhotoLines lines, const cv::Mat& picture,
                                     const cv::Mat1b& mask, double longer_side_mm);

}  // namespace touchline
