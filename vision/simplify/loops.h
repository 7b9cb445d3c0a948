// A line that crosses itself, taken apart where it does. Chains here are in millimetres.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

namespace touchline {

/// The line as parts that do not cross themselves: each loop that a crossing closes becomes a
/// closed line of its own (a fixed point where it was cut off), the rest goes on through the
/// crossing. Parts of crossing lines shorter than `least_mm` are dropped; none may be left.
/// O(points) per cut.
[[nodiscard]] std::vector<Chain> without_self_crossings(const Chain& line, double least_mm);

/// Whether the line will cross itself once its points are on the grid of a map: one that leads back
/// along itself may do so only there. Not where it only touches itself. O(points).
[[nodiscard]] bool crosses_itself_in_map(const Chain& line);

/// The line as parts that do not cross themselves there. O(points) per cut.
[[nodiscard]] std::vector<Chain> without_crossings_in_map(const Chain& line);

}  // namespace touchline
