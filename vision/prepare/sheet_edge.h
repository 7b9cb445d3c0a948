// What a scan holds that is not of its sheet.
// Threads: pure function.
#pragma once

#include <opencv2/core.hpp>

namespace touchline {

/// The picture with what lies around its sheet painted over in the paper's colour: the bed beyond a
/// straight edge, the edge and its shadow, the bed in rounded corners and punched holes. Edges lean
/// at most 10 degrees and lie within a quarter of the picture's side from its frame. The same where
/// there is no such edge, too little paper, or no grain: what a program painted is all of the
/// picture. 8-bit BGR; a grey picture comes back as it is. O(pixels).
[[nodiscard]] cv::Mat within_sheet(const cv::Mat& picture);

}  // namespace touchline
