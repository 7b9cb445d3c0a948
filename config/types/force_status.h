// Whether the device may push, what prevents it, and what reduced its force.
// Threads: plain values; handed over with the hand's state.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace touchline {

/// off: zero, because no force is wanted. armed: zero until a hand is there and the wanted force
/// has been small for a while, so that nobody is pushed when force comes on. ramp: the gain is on
/// its way up or down. live: full gain. fault: zero until its cause is cleared; tracking, events
/// and sound go on.
enum class ForceState : std::uint8_t { off, armed, ramp, live, fault };

inline constexpr std::size_t force_state_count = 5;

/// Causes of the fault state, the gravest last.
enum class Fault : std::uint8_t {
    none,
    device_lost,    // the device does not answer, or takes no torques
    too_fast,       // the handle was faster than a hand can be
    energy,         // the device gave the hand more energy than it may
    ringing,        // the loop rings although it was softened
    knob_lost,      // the loop rings and only the device's own mass moves
    position_jump,  // the handle cannot have moved so far
    not_finite,     // NaN or infinity: a bug or a broken device
    emergency_stop
};

inline constexpr std::size_t fault_count = 9;

/// What reduced the force in a tick, the gravest last.
enum class Limit : std::uint8_t {
    none,
    gain,    // on the way up or down, or off
    slew,    // limit on change and growth
    torque,  // limit of a motor
    force,   // limit on the vector's length
    heat,    // motor too warm
    damped,  // energy was given to the hand: damping is added
    pose,    // near a singular pose
    speed,   // nothing may drive on a fast hand
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
    std::array<std::uint32_t, limit_count> limited{};  // ticks so far in which each limit acted
};

}  // namespace touchline
