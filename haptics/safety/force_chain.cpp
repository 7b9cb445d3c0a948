#include "haptics/safety/force_chain.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

// Every clamp is written so that NaN fails it.
Force clamped(Force force, double limit_N) {
    const double magnitude = norm(force);
    return magnitude <= limit_N ? force : limit_N / magnitude * force;
}

bool is_finite(const Jacobian& j) {
    return touchline::is_finite(j.joint_1) && touchline::is_finite(j.joint_2);
}

// 1 where the pose is good, 0 where it is (nearly) singular.
double pose_gain(const Jacobian& jacobian, const ForceLimits& limits) {
    const double margin = limits.condition_zero - condition(jacobian);
    if (!(margin > 0.0)) return 0.0;
    return std::min(1.0, margin / (limits.condition_zero - limits.condition_full));
}

}  // namespace

ForceLimits limits_of(const DeviceProfile& profile) {
    ForceLimits limits;
    limits.force_N = std::min(3.0, profile.force_limit_N);
    limits.torque_Nm = 0.9 * profile.torque_limit_Nm;
    return limits;
}

void ForceChain::arm() {
    if (state_ != ForceState::off) return;
    state_ = ForceState::armed;
    quiet_s_ = 0.0;
}

void ForceChain::fade() {
    gain_per_s_ = -1.0 / limits_.fade_s;
}

void ForceChain::resume() {
    if (state_ == ForceState::ramp || state_ == ForceState::live) {
        gain_per_s_ = 1.0 / limits_.resume_s;
    }
}

void ForceChain::stop() {
    *this = ForceChain(limits_);
}

void ForceChain::fail(Fault cause) {
    stop();
    state_ = ForceState::fault;
    cause_ = cause;
}

void ForceChain::step_gain(Force wanted_D, double dt_s) {
    if (state_ == ForceState::armed) {
        quiet_s_ = norm(wanted_D) < limits_.arm_force_N ? quiet_s_ + dt_s : 0.0;
        if (quiet_s_ < limits_.arm_s) return;
        state_ = ForceState::ramp;
        gain_per_s_ = 1.0 / limits_.start_s;
    }
    if (state_ == ForceState::off) return;
    gain_ = std::clamp(gain_ + gain_per_s_ * dt_s, 0.0, 1.0);
    state_ = gain_ == 1.0 ? ForceState::live : ForceState::ramp;
}

Force ForceChain::slewed(Force target_D, double dt_s) const {
    const Force change = clamped(target_D - last_D_, limits_.change_N_per_s * dt_s);
    return clamped(last_D_ + change, norm(last_D_) + limits_.rise_N_per_s * dt_s);
}

SafeForce ForceChain::none(Limit limit) {
    last_D_ = {};
    return {{}, {}, limit};
}

SafeForce ForceChain::step(Force wanted_D, const std::optional<Jacobian>& jacobian, double dt_s) {
    const bool is_sound = touchline::is_finite(wanted_D) && std::isfinite(dt_s) && dt_s > 0.0 &&
                          (!jacobian || is_finite(*jacobian));
    if (!is_sound && state_ != ForceState::fault) fail(Fault::not_finite);
    if (state_ == ForceState::fault) return none(Limit::fault);

    step_gain(wanted_D, dt_s);
    if (!jacobian) return none(Limit::unreachable);
    Limit limit = gain_ == 1.0 ? Limit::none : Limit::gain;
    const auto limited_by = [&limit](Limit stage) { limit = std::max(limit, stage); };

    const double pose = pose_gain(*jacobian, limits_);
    if (pose != 1.0) limited_by(Limit::pose);
    const Force faded = gain_ * pose * wanted_D;
    const Force bounded = clamped(faded, limits_.force_N);
    if (bounded != faded) limited_by(Limit::force);
    Force force = slewed(bounded, dt_s);
    if (force != bounded) limited_by(Limit::slew);

    JointTorques torques = joint_torques(*jacobian, force);
    const double peak = std::max(std::abs(torques.x), std::abs(torques.y));
    if (!(peak <= limits_.torque_Nm)) {
        const double scale = limits_.torque_Nm / peak;
        force = scale * force;
        torques = scale * torques;
        limited_by(Limit::torque);
    }
    if (!touchline::is_finite(force) || !touchline::is_finite(torques)) {
        fail(Fault::not_finite);
        return none(Limit::fault);
    }
    last_D_ = force;
    return {force, torques, limit};
}

}  // namespace touchline
