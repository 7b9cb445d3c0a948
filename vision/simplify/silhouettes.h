// Joins the lines round a thing where others meet them.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"
#include "vision/simplify/surroundings.h"

#include <vector>

namespace touchline {

/// If just two of the arms where lines meet have the outside on one side, and all others lie within
/// the thing, those two become one: arcs that lead into a thing become one ring round it. A
/// junction with an arm that stands out (the outside is on both of its sides) stays as it is.
/// O(points log points).
[[nodiscard]] std::vector<Chain> with_silhouettes_joined(std::vector<Chain> lines,
                                                         const Outside& outside);

}  // namespace touchline
