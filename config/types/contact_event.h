// The events of the hand that are worth a word or a sound.
// Threads: a plain value; handed over by haptics/servo/exchange.h.
#pragma once

#include "config/types/vec2.h"

#include <cstddef>
#include <cstdint>

namespace touchline {

enum class ContactEventKind : std::uint8_t {
    contact_made,
    contact_lost,
    vertex_passed,    // a corner or a junction of the outline
    line_crossed,     // not in wall mode: the hand changed sides, or another line took over
    end_reached,      // of an open outline
    level_changed,    // a whole level is now rendered
    outline_changed,  // from one outline to another
    area_entered,     // the drawing area
    area_left,
    popped_through,  // through a wall that gave way
};

inline constexpr std::size_t contact_event_count =
    static_cast<std::size_t>(ContactEventKind::popped_through) + 1;  // the last kind

struct ContactEvent {
    ContactEventKind kind = ContactEventKind::contact_made;
    double time_s = 0.0;     // since the servo started
    Position place_W;        // the proxy's; the handle's for the area
    int outline = -1;        // index in the map, -1: none
    double parameter = 0.0;  // on the outline, in level-0 segments; 0 without an outline
    double level = 0.0;      // rendered
    std::uint64_t map_version = 0;
};

}  // namespace touchline
