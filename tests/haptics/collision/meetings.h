// Where lines that are not neighbours meet, at any level: brute force, exact.
#pragma once

#include "haptics/curve/curve_set.h"

namespace touchline::trials {

/// Returns how many pairs of segments meet at a level and do not belong to neighbours.
[[nodiscard]] int meetings(const CurveSet& curves, double level);

/// Returns how many of the levels, a sixteenth apart, have meetings.
[[nodiscard]] int levels_with_meetings(const CurveSet& curves);

}  // namespace touchline::trials
