// Edge lines, as irregular as the pixel grid left them, to evenly spaced points.
// Threads: pure functions, O(points).
#pragma once

#include "vision/contour/chain.h"

namespace touchline {

/// The chain with points about `spacing_px` apart (equal arc lengths between two fixed points),
/// smoothed along the line by about one spacing; fixed points and ends are kept exactly. A chain
/// without points stays one; a ring comes out with four at least, in one place if it had but one.
[[nodiscard]] Chain resampled(const Chain& chain, double spacing_px);

/// n + 1 points that cut the polyline into n parts of equal arc length; first and last are its
/// own. Strengths are interpolated. Where the polyline has no length all lie in its place; n >= 1.
/// None, where it has no points.
[[nodiscard]] std::vector<EdgePoint> evenly_spaced(const std::vector<EdgePoint>& line, int n);

}  // namespace touchline
