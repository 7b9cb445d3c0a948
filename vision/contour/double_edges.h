// Merges the two edges of a narrow stripe (a pole, a pen stroke, a branch) into one line along its
// middle.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Merges two lines less than `widest_px` apart into one in the middle if they face each other with
/// opposite light (both sides of a dark stripe are lighter, of a light one darker) along more than
/// 70 % of the shorter one. `width_px` is their mean distance if the stripe is most of the line,
/// else 0. A ring that faces itself in this way becomes an open line. The shorter line's other
/// stretches are dropped, unless they continue the longer one beyond its end; the longer line's
/// stay. A line is merged once, the narrowest pairs first. Fixed points move with their line, as do
/// those of other lines that share them. Lines whose light side is not known stay as they are.
/// Lines that are not merged keep their order. O(points x points within reach).
[[nodiscard]] std::vector<Chain> with_double_edges_merged(std::vector<Chain> chains,
                                                          cv::Size picture, double widest_px);

}  // namespace touchline
