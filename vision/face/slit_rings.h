// Eyes and mouths: rings with two corners, whose sides are near each other. Lengths in millimetres.
// Threads: pure functions.
#pragma once

#include "vision/simplify/own_spacing.h"

namespace touchline {

/// Returns the ring with its sides as far apart as a finger needs to find two lines: at least 3.6
/// mm in the middle, and as much more, up to 6 mm, as keeps it from coming too near to itself. A
/// ring without two fixed points, or without width, stays as it is. O(points x points near).
[[nodiscard]] Chain opened_for_finger(const Chain& ring, const SpacingScale& scale);

/// Returns the line halfway between its sides, from corner to corner. A ring without two fixed
/// points stays as it is. O(points).
[[nodiscard]] Chain middle_of(const Chain& ring);

}  // namespace touchline
