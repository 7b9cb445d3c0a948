// A shape in the hand, as strokes.
// Threads: pure functions.
#pragma once

#include "app/screen/strokes.h"
#include "config/types/hand_state.h"

namespace touchline {

/// Bold where lines hold it, thin where the hand would have it, and an arc with a head for its
/// torque, about the handle: a third of a turn for 15 mN m. Nothing where a point is held.
void add_shape(Strokes& strokes, const View& view, const HandState& hand, double unit_px,
               const Palette& palette);

}  // namespace touchline
