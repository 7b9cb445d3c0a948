// Removes what a scan holds besides its sheet.
// Threads: pure function.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// Returns the picture with everything around its sheet painted over in the paper's colour: the bed
/// beyond a straight edge, the edge and its shadow, the bed in rounded corners and punched holes.
/// Edges lean at most 10 degrees and lie within a quarter of the picture's side from its frame.
/// Returns the same picture if there is no such edge, too little paper, or no grain: everything
/// that a program painted belongs to the picture. 8-bit BGR; a grey picture comes back as it is.
/// O(pixels).
[[nodiscard]] cv::Mat within_sheet(const cv::Mat& picture);

}  // namespace touchline
