#include "haptics/safety/safety_state.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace touchline {
namespace {

constexpr std::array rules{
    FaultRule{Fault::device_lost, FaultClears::when_gone},
    FaultRule{Fault::too_fast, FaultClears::when_gone},
    FaultRule{Fault::energy, FaultClears::on_rearm},
    FaultRule{Fault::ringing, FaultClears::on_rearm},
    FaultRule{Fault::knob_lost, FaultClears::by_operator},
    FaultRule{Fault::position_jump, FaultClears::by_operator},
    FaultRule{Fault::not_finite, FaultClears::by_operator},
    FaultRule{Fault::emergency_stop, FaultClears::by_operator},
};
static_assert(rules.size() + 1 == fault_count);

FaultClears clears_of(Fault fault) {
    return rules[static_cast<std::size_t>(fault) - 1].clears;
}

/// The highest bit is the gravest.
Fault gravest(std::uint16_t faults) {
    return static_cast<Fault>(std::bit_width(faults) - 1);
}

bool is_cleared(Fault fault, const SafetyFlags& flags) {
    switch (clears_of(fault)) {
        case FaultClears::when_gone:
            return true;
        case FaultClears::on_rearm:
            return !flags.is_wanted || flags.is_cleared;
        case FaultClears::by_operator:
            return flags.is_cleared;
    }
    return false;
}

SafetyState silent(ForceState state, Fault fault = Fault::none) {
    return {state, fault, 0.0, 0.0, 0.0};
}

SafetyState armed_next(const SafetyState& before, const SafetyFlags& flags,
                       const SafetyTimes& times, double dt_s) {
    SafetyState after = before;
    after.quiet_s = flags.is_quiet && !flags.is_hand_off ? before.quiet_s + dt_s : 0.0;
    if (after.quiet_s < times.arm_s) return after;
    return {ForceState::ramp, Fault::none, 0.0, 0.0, 1.0 / times.start_s};
}

SafetyState ramp_next(const SafetyState& before, const SafetyFlags& flags, const SafetyTimes& times,
                      double dt_s) {
    SafetyState after = before;
    const bool is_falling = flags.is_fading || flags.is_hand_off;
    if (is_falling) after.rise_per_s = 1.0 / times.resume_s;
    const double per_s = is_falling ? -1.0 / times.fade_s : after.rise_per_s;
    after.gain = std::clamp(before.gain + per_s * dt_s, 0.0, 1.0);
    if (flags.is_hand_off && after.gain == 0.0) return silent(ForceState::armed);
    after.state = after.gain == 1.0 ? ForceState::live : ForceState::ramp;
    return after;
}

}  // namespace

std::span<const FaultRule> fault_rules() {
    return rules;
}

SafetyState next(const SafetyState& before, const SafetyFlags& flags, const SafetyTimes& times,
                 double dt_s) {
    const bool has_time = std::isfinite(dt_s) && dt_s > 0.0;
    const std::uint16_t faults =
        has_time ? flags.faults
                 : static_cast<std::uint16_t>(flags.faults | bit_of(Fault::not_finite));
    if (faults != 0) return silent(ForceState::fault, std::max(before.fault, gravest(faults)));
    const bool stays = before.state == ForceState::fault && !is_cleared(before.fault, flags);
    if (stays) return before;
    if (!flags.is_wanted) return silent(ForceState::off);
    switch (before.state) {
        case ForceState::off:
        case ForceState::fault:
            return silent(ForceState::armed);
        case ForceState::armed: {
            const SafetyState after = armed_next(before, flags, times, dt_s);
            return after.state == ForceState::ramp ? ramp_next(after, flags, times, dt_s) : after;
        }
        case ForceState::ramp:
        case ForceState::live:
            return ramp_next(before, flags, times, dt_s);
    }
    return silent(ForceState::off);
}

}  // namespace touchline
