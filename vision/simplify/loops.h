// A line that crosses itself, taken apart where it does. Chains here are in millimetres.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

namespace touchline {

/// The line as parts that do not cross themselves, on the grid of a map's points neither: each loop
/// that a crossing closes becomes a closed line of its own (a fixed point where it was cut off),
/// the rest goes on through the crossing. Parts of crossing lines shorter than `least_mm` are
/// dropped; none may be left. O(points) per cut.
[[nodiscard]] std::vector<Chain> without_self_crossings(const Chain& line, double least_mm);

}  // namespace touchline
