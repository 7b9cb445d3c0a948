// A held shape as strokes.
// Threads: pure functions.
#pragma once

#include "app/screen/strokes.h"
#include "config/types/hand_state.h"

namespace touchline {

/// Draws it bold where lines hold it, thin where the hand wants it, and its torque as an arc with a
/// head around the handle: a third of a turn for 15 mN m. Draws nothing for a point.
void add_shape(Strokes& strokes, const View& view, const HandState& hand, double unit_px,
               const Palette& palette);

}  // namespace touchline
