// Turns gradients into sub-pixel lines by non-maximum suppression and hysteresis.
// Threads: pure function.
#pragma once

#include "vision/contour/chain.h"
#include "vision/contour/gradient.h"

namespace touchline {

/// Thresholds on the gradient strength, grey levels per pixel: a line is followed while it is at
/// least `low`, and kept if it reaches `high` somewhere.
struct Hysteresis {
    double low = 0.0;
    double high = 0.0;
};

/// Returns the lines along which the gradient strength has a maximum across the edge: Canny's
/// definition (Canny 1986), solved as the zero crossings of the strength's slope along the normal,
/// cell by cell as in marching squares. So the points are sub-pixel, neighbours are known from the
/// cell that they share, and no thinning or pixel following is needed. A line ends where the
/// crossing does: at the threshold, at the frame, near a junction. Deterministic order (by first
/// row, column). O(pixels).
[[nodiscard]] std::vector<Chain> edge_lines(const GradientField& field, const Hysteresis& limits);

}  // namespace touchline
