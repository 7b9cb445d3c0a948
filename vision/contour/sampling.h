// Turns edge lines, as irregular as the pixel grid left them, into evenly spaced points.
// Threads: pure functions, O(points).
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// Returns the chain with points about `spacing_px` apart (equal arc lengths between two fixed
/// points), smoothed along the line by about one spacing; fixed points and ends are kept exactly. A
/// chain without points stays without; a ring gets at least four, all in one place if it had only
/// one.
[[nodiscard]] Chain resampled(const Chain& chain, double spacing_px);

/// Returns n + 1 points that cut the polyline into n parts of equal arc length; the first and last
/// are its own. Strengths are interpolated. If the polyline has no length, all points lie in its
/// place; n >= 1. Returns none if it has no points.
[[nodiscard]] std::vector<EdgePoint> evenly_spaced(const std::vector<EdgePoint>& line, int n);

}  // namespace touchline
