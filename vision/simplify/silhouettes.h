// The lines round a thing, put together where others meet them.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"
#include "vision/simplify/surroundings.h"

#include <vector>

namespace touchline {

/// Where lines meet and just two of their arms have the outside on one side, all others lying
/// within the thing, those two go on as one: what was drawn in arcs that lead into it becomes one
/// ring round it. A junction with an arm that stands out (both of its sides see the outside) stays
/// as it is. O(points log points).
[[nodiscard]] std::vector<Chain> with_silhouettes_joined(std::vector<Chain> lines,
                                                         const Outside& outside);

}  // namespace touchline
