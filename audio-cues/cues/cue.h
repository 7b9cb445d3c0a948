// The short sounds by name, and the occasion of one. Threads: values.
#pragma once

#include "config/types/choices.h"
#include "config/types/vec2.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace touchline {

/// In pairs of opposites; the first one rises or is brighter than the second.
enum class Cue : std::uint8_t {
    touch,  // a line is there
    leave,
    corner,  // the line turns
    end,     // the line stops
    label,   // a named spot
    cross,   // to the other side, or to another line
    finer,
    coarser,
    area_entered,
    area_left,
    key,      // a key was accepted
    refused,  // the key means nothing here
};

inline constexpr std::size_t cue_count = 12;

/// A cue at a place in the picture.
struct CueAt {
    Cue cue = Cue::touch;
    double time_s = 0.0;  // when its event occurred, since the servo started
    double pan = 0.0;     // -1 left ... 1 right
    bool is_alert = false;
};

/// Half the width and height of the drawing area.
struct CueArea {
    double half_width_m = 0.058;
    double half_height_m = 0.042;
};

/// Returns -1 at the left edge of the area ... 1 at the right one, clamped; 0 if not finite.
[[nodiscard]] double pan_of(Position place_W, const CueArea& area);

}  // namespace touchline
