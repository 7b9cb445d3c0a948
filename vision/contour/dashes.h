// Broken lines: dashes and dots in a row are one line to a hand.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Dashes (short open lines, up to 7 mm) and dots (small rings, up to 3 mm across) that follow one
/// another in one course, at gaps of at most 4.2 mm, alike in length and in gaps, become one line
/// through them, LineOf::dashed or LineOf::dotted; closed where the last leads to the first. Three
/// dashes or five dots make a line. Dots that lie in a field, letters that are not alike, and more
/// than 2000 pieces stay. Lengths in pixels: `mm_px` is a millimetre. O(pieces squared in the worst
/// case, of those near each other else).
[[nodiscard]] std::vector<Chain> with_dashes_joined(std::vector<Chain> lines, double mm_px);

}  // namespace touchline
