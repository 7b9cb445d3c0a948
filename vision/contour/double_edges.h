// The two edges of a narrow stripe (a pole, a pen stroke, a branch) as one line along its middle.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Two lines less than `widest_px` apart that face each other with opposite light (both sides of a
/// dark stripe are lighter, of a light one darker) along more than 70 % of the shorter become one
/// line in the middle; `width_px` is their mean distance if the stripe is most of the line, else 0.
/// A ring that so faces itself becomes an open line. The shorter's other stretches go, except where
/// they continue the longer one beyond its end; the longer's stay. A line is merged once, the
/// narrowest pairs first. Fixed points move with their line, also those of other lines that share
/// them. Lines whose light side is not known stay as they are. Lines that take no part keep their
/// order. O(points x points within reach).
[[nodiscard]] std::vector<Chain> with_double_edges_merged(std::vector<Chain> chains,
                                                          cv::Size picture, double widest_px);

}  // namespace touchline
