// Slows the pointer down to a hand's pace. A pointer jumps across a screen and a hand does not: the
// servo would take it for a thrown handle.
// Threads: a pure function.
#pragma once

#include "config/types/vec2.h"

namespace touchline {

inline constexpr double led_m_per_s = 0.6;

/// Moves for dt_s from where the hand means to be towards the pointer.
[[nodiscard]] inline Position paced(Position from, Position pointer, double dt_s) {
    const Position way = pointer - from;
    const double most_m = led_m_per_s * dt_s;
    return norm(way) > most_m ? from + along<Position>(direction_of(way), most_m) : pointer;
}

}  // namespace touchline
