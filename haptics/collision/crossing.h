// Decides exactly where a point's straight way meets a segment: signs by expansion arithmetic after
// Shewchuk (1997) behind a floating-point filter. Threads: pure functions, no allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <optional>

namespace touchline {

/// Returns +1 if c lies to the left of the line from a to b, -1 if to the right, 0 if on it. Exact
/// for coordinates whose products neither overflow nor underflow (1e-140 ... 1e150).
[[nodiscard]] int orientation(Position a, Position b, Position c);

/// The first common point of a way and a segment, both closed.
struct Crossing {
    double fraction = 0.0;   // of the way, to 4 ulp
    double parameter = 0.0;  // on the segment, to 4 ulp
    bool from_left = false;  // the way starts on the segment's left, or on its line
};

/// Returns nothing if they have no common point, exactly.
[[nodiscard]] std::optional<Crossing> crossing(Position from, Position to, const Segment& segment);

/// Returns whether the way, moved to its right by less than any distance, passes through the
/// segment. So the ways and segments of a closed curve count consistently at vertices and along
/// segments.
[[nodiscard]] bool passes(Position from, Position to, const Segment& segment);

}  // namespace touchline
