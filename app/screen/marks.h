// Moving marks as strokes: outlines at the current level, boxes of the boundary section, handle,
// proxy and force.
// Threads: pure functions.
#pragma once

#include "app/screen/strokes.h"
#include "config/types/hand_state.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/curve/curve_set.h"

#include <span>

namespace touchline {

/// All pieces as rendered at `level`. O(segments).
void add_outlines(Strokes& strokes, const View& view, const CurveSet& curves, double level,
                  double width_px, const Palette& palette = white_on_black);

/// The edges of the boxes.
void add_boxes(Strokes& strokes, const View& view, std::span<const ErrorBox> boxes,
               double width_px);

/// Handle (ring), proxy (a disc of its radius, or the held shape), the spring between them and the
/// force on the hand (an arrow from the handle). The shapes differ, so nobody has to tell colours
/// apart. `unit_px`: width of a thin line.
void add_hand(Strokes& strokes, const View& view, const HandState& hand, double proxy_radius_m,
              double unit_px, const Palette& palette = white_on_black);

}  // namespace touchline
