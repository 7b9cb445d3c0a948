// What the kiosk asks of a handle that leads the hand, and what it is told of it.
// Threads: plain values; handed over with the servo's commands and its report.
#pragma once

#include "config/types/handle_pattern.h"
#include "config/types/vec2.h"

#include <cstdint>

namespace touchline {

/// none: leads nowhere, which stops what leads now. tour: along outlines, from their start to their
/// end. to_place: straight to a place. to_line: to the nearest point of any outline.
enum class GuidanceKind : std::uint8_t { none, tour, to_place, to_line };

/// none: nothing was asked yet. waiting: it leads but does not go on, because the hand is held
/// back, force is not on yet or the kiosk holds it. pausing: at a corner or label. arrived,
/// stopped: it has ended.
enum class GuidancePhase : std::uint8_t { none, running, waiting, pausing, arrived, stopped };

/// Another serial number is a new command: what led before ends within 50 ms. The first number that
/// a servo is told begins nothing, so that one that starts anew never moves the handle by itself.
struct GuidanceCommand {
    GuidanceKind kind = GuidanceKind::none;
    bool is_held = false;  // of a tour: stay where it leads to now; may change at any time
    std::uint32_t serial = 0;
    std::int32_t outline = -1;     // of a tour: index in the map; -1: all, in the map's order
    Position place;                // to_place: in W; kept within the drawing area
    double speed_m_per_s = 0.035;  // 0.005 ... 0.1

    friend bool operator==(const GuidanceCommand&, const GuidanceCommand&) = default;
};

/// Another serial number plays it, once; the first that a servo is told plays nothing.
struct PatternCommand {
    HandlePattern pattern = HandlePattern::none;
    std::uint32_t serial = 0;

    friend bool operator==(const PatternCommand&, const PatternCommand&) = default;
};

struct GuidanceStatus {
    std::uint32_t serial = 0;  // of the command that this is about
    GuidancePhase phase = GuidancePhase::none;
    bool is_on_line = false;           // a tour leads along an outline, not to where one begins
    std::int32_t outline = -1;         // a tour is on it, or on its way there; -1: none
    std::int32_t label = -1;           // of the map; a tour has come to it last; -1: none
    Position leading;                  // the point that leads, in W; while none leads the handle
    std::uint32_t pattern_serial = 0;  // of the last pattern that was begun or left out

    friend bool operator==(const GuidanceStatus&, const GuidanceStatus&) = default;
};

}  // namespace touchline
