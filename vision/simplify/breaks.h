// Closes small breaks in lines. Chains here are in millimetres.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

namespace touchline {

/// A break up to this long is closed: a groove must not end by accident.
inline constexpr double kSmallBreak_mm = 4.0;

/// Joins free ends that are nearer than `reach_mm` and point at each other, cheapest first: cost =
/// distance x (1 + bending in radians), at most 70 degrees at each end (any bending under a quarter
/// of the reach). A line closes on itself if it is longer than four times the break. Ends that
/// other lines share (junctions) are not free. O(n log n + pairs near).
[[nodiscard]] std::vector<Chain> with_breaks_closed(std::vector<Chain> lines, double reach_mm);

}  // namespace touchline
