// Whether the device may push, what keeps it from it, and what reduced its force.
// Threads: plain values; handed over with the hand's state.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace touchline {

/// off: zero, nobody wants force. armed: zero until a hand is there and the wanted force was small
/// for a while, so that nobody is pushed when force comes on. ramp: gain on its way up or down.
/// live: full gain. fault: zero until its cause is cleared; tracking, events and sound go on.
enum class ForceState : std::uint8_t { off, armed, ramp, live, fault };

inline constexpr std::size_t force_state_count = 5;

/// Causes of the state fault, the gravest last.
enum class Fault : std::uint8_t {
    none,
    device_lost,    // it does not answer, or takes no torques
    too_fast,       // the handle outran what a hand does
    energy,         // the device gave the hand more energy than it may
    ringing,        // the loop rings though it was softened
    knob_lost,      // it rings and nothing but the device's own mass moves
    position_jump,  // the handle cannot have moved so far
    not_finite,     // a number is none: a bug or a broken device
    emergency_stop
};

inline constexpr std::size_t fault_count = 9;

/// What reduced the force of a tick, the gravest last.
enum class Limit : std::uint8_t {
    none,
    gain,    // on its way up or down, or off
    slew,    // change and growth
    torque,  // of a motor
    force,   // length of the vector
    heat,    // of a motor
    damped,  // energy was given to the hand: damping is added
    pose,    // near a singular one
    speed,   // nothing that drives a fast hand on
    hand,    // nobody seems to hold the handle
    unreachable,
    fault
};

inline constexpr std::size_t limit_count = 12;

/// Why the hand feels what it feels, for the operator.
struct ForceStatus {
    ForceState state = ForceState::off;
    Fault fault = Fault::none;
    Limit limit = Limit::none;                         // the gravest of this tick
    std::array<std::uint32_t, limit_count> limited{};  // ticks so far that each limit acted in
};

}  // namespace touchline
