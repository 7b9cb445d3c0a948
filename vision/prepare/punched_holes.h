// Finds holes that a punch made in a scanned sheet.
// Threads: pure function.
#pragma once

#include "vision/prepare/sheet_sides.h"

namespace touchline {

/// Returns 255 where holes are: two to six discs that are alike, in a row beside one side of the
/// sheet, even about its middle. `ink`: neither paper nor beyond the sheet. O(pixels).
[[nodiscard]] cv::Mat1b punched_holes(const cv::Mat1b& ink, const SheetEdges& edges);

}  // namespace touchline
