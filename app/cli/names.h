// The words of RUN.csv. Stable: scripts rely on them.
// Threads: pure functions.
#pragma once

#include "config/types/hand_state.h"

#include <array>
#include <string_view>

namespace touchline {

[[nodiscard]] constexpr std::string_view name_of(ContactState state) {
    constexpr std::array<std::string_view, 3> names{"free", "edge", "vertex"};
    return names[static_cast<std::size_t>(state)];
}

[[nodiscard]] constexpr std::string_view name_of(ForceState state) {
    constexpr std::array<std::string_view, force_state_count> names{"off", "armed", "ramp", "live",
                                                                    "fault"};
    return names[static_cast<std::size_t>(state)];
}

[[nodiscard]] constexpr std::string_view name_of(Fault fault) {
    constexpr std::array<std::string_view, fault_count> names{
        "none",      "device_lost",   "too_fast",   "energy",        "ringing",
        "knob_lost", "position_jump", "not_finite", "emergency_stop"};
    return names[static_cast<std::size_t>(fault)];
}

[[nodiscard]] constexpr std::string_view name_of(Limit limit) {
    constexpr std::array<std::string_view, limit_count> names{
        "none",   "gain", "slew",  "torque", "force",       "heat",
        "damped", "pose", "speed", "hand",   "unreachable", "fault"};
    return names[static_cast<std::size_t>(limit)];
}

}  // namespace touchline
