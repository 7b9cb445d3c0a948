// The lines of a photograph with its figure: a ring round it, what lies in it, and what lies behind
// it.
// Threads: pure function.
#pragma once

#include "vision/contour/photo_lines.h"

namespace touchline {

/// Adds to a photo's lines (of `picture`, 8-bit BGR or grey) the rings of a mask of the same
/// proportions (128 and more: figure), each drawn onto the strongest edge within a millimetre and a
/// half: LineOf::ring, for holes too, as strong as the strongest line, open where the picture's
/// frame cuts the figure. Lines in the figure, 3.2 mm and more from its rings, stay as they are;
/// lines as far outside become LineOf::background; lines along a ring go. Changes nothing if no
/// place of the mask has 128. O(pixels).
[[nodiscard]] PhotoLines with_figure(PhotoLines lines, const cv::Mat& picture,
                                     const cv::Mat1b& mask, double longer_side_mm);

}  // namespace touchline
