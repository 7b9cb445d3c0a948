// How the handle leads the hand and how it speaks: what the kiosk asks, and what comes back.
// Threads: plain values; handed over with the servo's commands and its report.
#pragma once

#include "config/types/vec2.h"

#include <cstddef>
#include <cstdint>

namespace touchline {

/// What the handle can say to a visitor who neither sees nor hears: short shakes that differ.
/// focus: another item. chosen: it was taken. error: that is not possible. edge: the end of a list
/// or of the drawing area. time_out: the session ends soon. How each one feels:
/// haptics/guidance/guidance.h.
enum class HandlePattern : std::uint8_t { none, focus, chosen, error, edge, time_out };

inline constexpr std::size_t handle_pattern_count = 6;

/// none: leads nowhere, and stops the present guidance. tour: along outlines, from start to end.
/// to_place: straight to a place. to_line: to the nearest point of any outline.
enum class GuidanceKind : std::uint8_t { none, tour, to_place, to_line };

/// none: no command yet. waiting: it leads but does not go on, because the hand is held back, force
/// is not on yet or the kiosk holds it. pausing: at a corner or label. arrived, stopped: it has
/// ended.
enum class GuidancePhase : std::uint8_t { none, running, waiting, pausing, arrived, stopped };

/// A new serial number is a new command: the guidance before it ends within 50 ms. The first number
/// that a servo receives begins nothing, so that a restarted servo never moves the handle by
/// itself.
struct GuidanceCommand {
    GuidanceKind kind = GuidanceKind::none;
    bool is_held = false;  // tour: stay where it leads now; may change at any time
    std::uint32_t serial = 0;
    std::int32_t outline = -1;     // tour: index in the map; -1: all, in the map's order
    Position place;                // to_place: in W; kept within the drawing area
    double speed_m_per_s = 0.035;  // 0.005 ... 0.1

    friend bool operator==(const GuidanceCommand&, const GuidanceCommand&) = default;
};

/// A new serial number plays the pattern once; the first that a servo receives plays nothing.
struct PatternCommand {
    HandlePattern pattern = HandlePattern::none;
    std::uint32_t serial = 0;

    friend bool operator==(const PatternCommand&, const PatternCommand&) = default;
};

struct GuidanceStatus {
    std::uint32_t serial = 0;  // the command that this report is about
    GuidancePhase phase = GuidancePhase::none;
    bool is_on_line = false;    // a tour leads along an outline, not to the start of one
    std::int32_t outline = -1;  // the tour is on it, or on its way there; -1: none
    std::int32_t label = -1;    // map label that the tour reached last; -1: none
    Position leading;           // the leading point in W; the handle's place while nothing leads
    std::uint32_t pattern_serial = 0;  // last pattern that was begun or left out

    friend bool operator==(const GuidanceStatus&, const GuidanceStatus&) = default;
};

}  // namespace touchline
