// Takes a line that crosses itself apart where it does. Chains here are in millimetres.
// Threads: pure functions.
#pragma once

#include "vision/contour/chain.h"

#include <vector>

namespace touchline {

/// Returns the line as parts that do not cross themselves: each loop that a crossing closes becomes
/// a closed line of its own (with a fixed point where it was cut off), and the rest goes on through
/// the crossing. Drops parts of crossing lines shorter than `least_mm`; perhaps none is left.
/// O(points) per cut.
[[nodiscard]] std::vector<Chain> without_self_crossings(const Chain& line, double least_mm);

/// Returns whether the line will cross itself once its points are on the grid of a map: a line that
/// leads back along itself may do so only there. False if it only touches itself. O(points).
[[nodiscard]] bool crosses_itself_in_map(const Chain& line);

/// Returns the line as parts that do not cross themselves there. O(points) per cut.
[[nodiscard]] std::vector<Chain> without_crossings_in_map(const Chain& line);

}  // namespace touchline
