#include "haptics/safety/force_chain.h"

#include <algorithm>
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

constexpr double cuts_forgotten_s = 1.0;
constexpr double one_cut = 0.5;
constexpr double finger_lever_m = 0.01;  // from the handle's axis
// The spring is at its softest after three cuts; two more within half a second show that softening
// does not help.
constexpr double hopeless_cuts = 3.5;

// Every clamp is written so that NaN fails it.
Force clamped(Force force, double limit_N) {
    const double magnitude = norm(force);
    return magnitude <= limit_N ? force : limit_N / magnitude * force;
}

bool is_sound(const ChainInput& input, double dt_s) {
    return is_finite(input.wanted_D) && is_finite(input.p_D) && is_finite(input.velocity_D) &&
           std::isfinite(input.across_m_per_s) && std::isfinite(input.across_N) &&
           std::isfinite(input.wanted_turn_Nm) && std::isfinite(input.handle_rad) &&
           std::isfinite(input.turn_rad_per_s) && std::isfinite(dt_s) && dt_s > 0.0 &&
           (!input.jacobian || is_finite(*input.jacobian));
}

// Returns 1 if the pose is good, 0 if it is singular or nearly so.
double pose_gain(const Jacobian& jacobian, const ForceLimits& limits) {
    const double margin = limits.condition_zero - condition(jacobian);
    if (!(margin > 0.0)) return 0.0;
    return std::min(1.0, margin / (limits.condition_zero - limits.condition_full));
}

/// A NaN share lets nothing through.
double share_of(const ChainInput& input) {
    return input.share > 0.0 ? std::min(input.share, 1.0) : 0.0;
}

/// Nor does a NaN here.
double on_plane_of(const ChainInput& input) {
    return input.on_plane > 0.0 ? std::min(input.on_plane, 1.0) : 0.0;
}

double speed_of(const ChainInput& input) {
    return std::hypot(norm(input.velocity_D), input.across_m_per_s);
}

/// A NaN ceiling lets nothing through either.
double ceiling_of(const ChainInput& input) {
    return input.ceiling_N > 0.0 ? input.ceiling_N : 0.0;
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

ForceLimits limits_of(const DeviceProfile& profile) {
    const MechanicsProfile& mechanics = profile.mechanics;
    ForceLimits limits;
    limits.force_N = std::min(most_force_N, profile.force_limit_N);
    limits.torque_Nm = 0.9 * profile.torque_limit_Nm;
    limits.continuous_torque_Nm = mechanics.continuous_torque * profile.torque_limit_Nm;
    limits.warming_s = mechanics.warming_s;
    if (profile.cartesian) limits.continuous_N = profile.cartesian->continuous_N;
    limits.tip = {mechanics.tip_mass_kg, mechanics.viscous_Ns_per_m, mechanics.coulomb_N,
                  encoder_step_m(profile)};
    if (const auto& handle = profile.handle) {
        limits.handle.torque_Nm = 0.9 * handle->torque_limit_Nm;
        limits.handle.continuous_torque_Nm = mechanics.continuous_torque * handle->torque_limit_Nm;
        limits.handle.warming_s = mechanics.warming_s;
    }
    return limits;
}

ForceChain::ForceChain(const ForceLimits& limits)
    : limits_(limits),
      heat_(limits.continuous_N.value_or(limits.continuous_torque_Nm), limits.warming_s),
      handle_(limits.handle),
      hand_(limits.tip) {}

SafeForce ForceChain::step(const ChainInput& input, double dt_s) {
    status_.limit = Limit::none;
    const std::uint16_t found = faults(input, dt_s);
    const bool is_quiet =
        norm(input.wanted_D) < limits_.arm_force_N && handle_.is_quiet(input.wanted_turn_Nm);
    const SafetyFlags flags{input.is_wanted && share_of(input) > 0.0,
                            is_quiet,
                            input.is_fading,
                            hand_.is_off(),
                            input.is_cleared,
                            found};
    safety_ = next(safety_, flags, limits_.times, dt_s);
    SafeForce told = limited(input, dt_s);
    if (!is_finite(told.force_D) || !is_finite(told.torques) || !std::isfinite(told.handle_Nm)) {
        safety_ = {ForceState::fault, Fault::not_finite, 0.0, 0.0, 0.0};
        told = none(Limit::fault);
    }
    const bool is_sound_input = (found & bit_of(Fault::not_finite)) == 0;
    if (is_sound_input) book(input, told, dt_s);
    if (safety_.state == ForceState::fault) forget_motion();
    status_.state = safety_.state;
    status_.fault = safety_.fault;
    told.limit = status_.limit;
    return told;
}

std::uint16_t ForceChain::faults(const ChainInput& input, double dt_s) {
    std::uint16_t found = 0;
    const auto note = [&found](bool holds, Fault fault) {
        if (holds) found = static_cast<std::uint16_t>(found | bit_of(fault));
    };
    note(input.is_stopped, Fault::emergency_stop);
    note(input.is_lost, Fault::device_lost);
    note(input.has_jumped, Fault::position_jump);
    if (input.is_unreadable || !is_sound(input, dt_s)) {
        note(true, Fault::not_finite);
        return found;
    }
    note(speed_.step(speed_of(input), dt_s), Fault::too_fast);
    const Position moved = has_position_ ? input.p_D - p_D_ : Position{};
    const double turned_rad = has_position_ ? input.handle_rad - handle_rad_ : 0.0;
    energy_.step(last_D_, moved, dt_s, handle_.told_Nm() * turned_rad);
    note(energy_.is_too_much(), Fault::energy);
    note(is_ringing(input.cuts, dt_s), Fault::ringing);
    // A hand that only turns the handle is there too.
    const Position fingers_D = input.p_D + Position{finger_lever_m * input.handle_rad, 0.0};
    (void)hand_.step(last_D_, input.velocity_D, fingers_D, dt_s);
    const bool rang = recent_cuts_ > one_cut;
    note(hand_.is_alone() && rang, Fault::knob_lost);
    return found;
}

bool ForceChain::is_ringing(std::uint64_t cuts, double dt_s) {
    recent_cuts_ = recent_cuts_ * std::max(0.0, 1.0 - dt_s / cuts_forgotten_s) +
                   static_cast<double>(cuts - cuts_);
    cuts_ = cuts;
    return recent_cuts_ > hopeless_cuts;
}

SafeForce ForceChain::limited(const ChainInput& input, double dt_s) {
    if (safety_.state == ForceState::fault) return none(Limit::fault);
    const bool has_joints = !limits_.continuous_N;
    if (!input.is_placed || (has_joints && !input.jacobian)) return none(Limit::unreachable);
    const bool braked = is_braked(speed_of(input));
    const Force target = bounded(input, braked);
    // What drives on a fast hand goes at once, not by the slew.
    if (braked) last_D_ = without_drive(last_D_, input.velocity_D);
    Force force = slewed(target, dt_s);
    if (force != target) limit_by(Limit::slew);
    if (braked) force = without_drive(force, input.velocity_D);
    if (!has_joints) {
        plane_share_ = plane_share(input, dt_s);
        return {force, {}, limited_turn(input, dt_s), plane_share_, Limit::none};
    }

    JointTorques torques = joint_torques(*input.jacobian, force);
    const double peak = std::max(std::abs(torques.x), std::abs(torques.y));
    if (!(peak <= limits_.torque_Nm)) {
        const double scale = limits_.torque_Nm / peak;
        force = scale * force;
        torques = scale * torques;
        limit_by(Limit::torque);
    }
    return {force, torques, limited_turn(input, dt_s), 0.0, Limit::none};
}

/// Uses the force's state, gains and ceiling: a torque is a force at a lever.
double ForceChain::limited_turn(const ChainInput& input, double dt_s) {
    const double ceiling = std::min(1.0, ceiling_of(input) / limits_.force_N);
    const double share = share_of(input);
    return handle_.step(input.wanted_turn_Nm, input.turn_rad_per_s, share * safety_.gain,
                        share * ceiling, dt_s);
}

/// The handle stays on the plane while the force of the picture fades to another one; it comes
/// there slowly.
double ForceChain::plane_share(const ChainInput& input, double dt_s) const {
    const bool may_act = safety_.state == ForceState::ramp || safety_.state == ForceState::live;
    if (!may_act) return 0.0;
    const double ceiling = std::min(1.0, ceiling_of(input) / limits_.force_N);
    const double most = share_of(input) * ceiling * heat_.allowed();
    return std::min(most, plane_share_ + dt_s / limits_.times.start_s);
}

/// Applies every limit except the slew and the motors'.
Force ForceChain::bounded(const ChainInput& input, bool is_braked) {
    const double share = share_of(input);
    if (safety_.gain != 1.0 || share != 1.0) limit_by(Limit::gain);
    if (hand_.is_off()) limit_by(Limit::hand);
    const double on_plane = limits_.continuous_N ? on_plane_of(input) : 1.0;
    const double pose = limits_.continuous_N ? on_plane : pose_gain(*input.jacobian, limits_);
    if (pose != 1.0) limit_by(Limit::pose);
    Force force = share * safety_.gain * pose * input.wanted_D;
    const double cool = heat_.allowed();
    if (cool != 1.0) limit_by(Limit::heat);
    force = cool * force;
    const double damping = safety_.gain * energy_.damping_Ns_per_m();
    if (damping > 0.0) {
        limit_by(Limit::damped);
        force += along<Force>(input.velocity_D, -damping);
    }
    const Force within =
        clamped(force, share * on_plane * std::min(limits_.force_N, ceiling_of(input)));
    if (within != force) limit_by(Limit::force);
    if (!is_braked) return within;
    limit_by(Limit::speed);
    return without_drive(within, input.velocity_D);
}

Force ForceChain::slewed(Force target_D, double dt_s) const {
    const Force change = clamped(target_D - last_D_, limits_.change_N_per_s * dt_s);
    return clamped(last_D_ + change, norm(last_D_) + limits_.rise_N_per_s * dt_s);
}

void ForceChain::book(const ChainInput& input, const SafeForce& told, double dt_s) {
    last_D_ = told.force_D;
    p_D_ = input.p_D;
    handle_rad_ = input.handle_rad;
    has_position_ = true;
    if (limits_.continuous_N)
        heat_.bear({norm(told.force_D), input.across_N}, dt_s);
    else
        heat_.step(told.torques, dt_s);
}

/// Without force there is nothing to judge by, and a fault must not keep itself alive.
void ForceChain::forget_motion() {
    energy_ = {};
    hand_ = HandPresence(limits_.tip);
    recent_cuts_ = 0.0;
    has_position_ = false;
}

void ForceChain::limit_by(Limit limit) {
    status_.limit = std::max(status_.limit, limit);
    ++status_.limited[static_cast<std::size_t>(limit)];
}

SafeForce ForceChain::none(Limit limit) {
    limit_by(limit);
    last_D_ = {};
    plane_share_ = 0.0;
    handle_.stop();
    return {};
}

}  // namespace touchline
