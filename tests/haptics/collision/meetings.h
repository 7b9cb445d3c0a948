// Where lines meet that are not neighbours, at any level: brute force, exact.
#pragma once

#include "haptics/curve/curve_set.h"

namespace touchline::trials {

/// Pairs of segments that meet at a level and are not held by neighbours.
[[nodiscard]] int meetings(const CurveSet& curves, double level);

/// How many of the levels, a sixteenth apart, have meetings.
[[nodiscard]] int levels_with_meetings(const CurveSet& curves);

}  // namespace touchline::trials
