// Whether force may act: off -> armed -> ramp -> live, any -> fault. A pure function of the state
// before, the conditions now and the time passed, so that every combination can be tried.
// Threads: values and pure functions.
#pragma once

#include "config/types/hand_state.h"

#include <cstdint>
#include <span>

namespace touchline {

/// How a fault ends once its cause is gone. The operator can end every fault.
enum class FaultClears : std::uint8_t {
    when_gone,    // by itself
    on_rearm,     // when force is switched off
    by_operator,  // when the operator says so
};

struct FaultRule {
    Fault fault = Fault::none;
    FaultClears clears = FaultClears::when_gone;
};

/// One rule for each fault except none, in order of severity, the gravest last. A graver fault is
/// never easier to clear.
[[nodiscard]] std::span<const FaultRule> fault_rules();

/// Faults are a set, one bit each.
[[nodiscard]] constexpr std::uint16_t bit_of(Fault fault) {
    return static_cast<std::uint16_t>(1U << static_cast<unsigned>(fault));
}

/// The conditions in a tick.
struct SafetyFlags {
    bool is_wanted = true;     // force is switched on
    bool is_quiet = true;      // the wanted force is small
    bool is_fading = false;    // gain to 0: a picture is changed, or the servo ends
    bool is_hand_off = false;  // nobody holds the handle
    bool is_cleared = false;   // the operator clears a fault, in this tick
    std::uint16_t faults = 0;  // conditions that hold now, bit_of() each but none
};

struct SafetyState {
    ForceState state = ForceState::off;
    Fault fault = Fault::none;
    double gain = 0.0;        // 0 ... 1, of the force
    double quiet_s = 0.0;     // armed: how long the wanted force has been small
    double rise_per_s = 0.0;  // of the gain when it goes up

    friend bool operator==(const SafetyState&, const SafetyState&) = default;
};

struct SafetyTimes {
    double arm_s = 0.2;     // quiet for so long: armed -> ramp
    double start_s = 0.5;   // gain 0 -> 1 after arming
    double resume_s = 0.3;  // gain 0 -> 1 after fading
    double fade_s = 0.05;   // gain 1 -> 0
};

/// Returns the state dt_s later. A dt_s that is not above 0 is a fault of a number. If two faults
/// meet, the graver one stays. O(1).
[[nodiscard]] SafetyState next(const SafetyState& before, const SafetyFlags& flags,
                               const SafetyTimes& times, double dt_s);

}  // namespace touchline
