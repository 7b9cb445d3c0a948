// Joins broken lines: a hand takes dashes and dots in a row as one line.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Joins dashes (short open lines, up to 7 mm) and dots (small rings, up to 3 mm across) into one
/// line through them, LineOf::dashed or LineOf::dotted, if they follow one another in one course,
/// at gaps of at most 4.2 mm, and are alike in length and in gaps. The line is closed if the last
/// leads to the first. It takes three dashes or five dots. Dots that lie in a field, letters that
/// are not alike, and more than 2000 pieces stay. Lengths in pixels: `mm_px` is a millimetre.
/// O(pieces squared in the worst case, else of those near each other).
[[nodiscard]] std::vector<Chain> with_dashes_joined(std::vector<Chain> lines, double mm_px);

}  // namespace touchline
