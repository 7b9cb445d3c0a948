#include "haptics/safety/stability_monitor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

constexpr double low_Hz = 20.0;
constexpr double high_Hz = 300.0;
constexpr double ringing_s = 0.1;  // looked at
constexpr double most_swings = 3.0;
constexpr double energy_forgotten_s = 1.0;  // of the energy
constexpr double cut_s = 0.02;
constexpr double apart_s = 0.1;
constexpr double least_gain = 0.125;
constexpr double restore_per_s = 0.05;

/// The share of the way that a first-order low pass goes in a tick.
double share(double cutoff_Hz, double dt_s) {
    return 1.0 - std::exp(-2.0 * std::numbers::pi * cutoff_Hz * dt_s);
}

constexpr double rise_per_s = 0.05;    // of the stiffness itself
constexpr double fall_N_per_s = 15.0;  // of the force: below what is felt as a jolt
constexpr double least_depth_m = 1e-6;

}  // namespace

void StabilityMonitor::begin_anew() {
    has_before_ = false;
    slow_ = fast_ = rest_ = {};
    swing_ = {};
    swings_ = recent_J_ = generated_J_ = 0.0;
}

double StabilityMonitor::step(const Tick& tick, double dt_s) {
    const bool is_sound = is_finite(tick.force) && is_finite(tick.moved) &&
                          std::isfinite(tick.stored_J) && std::isfinite(tick.turning_J) &&
                          std::isfinite(dt_s) && dt_s > 0.0;
    if (!is_sound || !tick.is_continued) {
        begin_anew();
        return gain_;
    }
    if (!has_before_) {
        slow_ = fast_ = tick.force;
        has_before_ = true;
    } else {
        const double work_J = dot(force_, tick.moved) + tick.turning_J + tick.stored_J - stored_J_;
        generated_J_ = std::max(0.0, generated_J_ * std::exp(-dt_s / energy_forgotten_s) + work_J);
        recent_J_ = recent_J_ * std::exp(-dt_s / ringing_s) + work_J;
    }
    force_ = tick.force;
    stored_J_ = tick.stored_J;
    slow_ += share(low_Hz, dt_s) * (tick.force - slow_);
    fast_ += share(high_Hz, dt_s) * (tick.force - fast_);
    // The high pass is applied twice; otherwise pressing and letting go would look like ringing.
    const Force band = fast_ - slow_;
    rest_ += share(low_Hz, dt_s) * (band - rest_);
    count_swings(band - rest_, dt_s);
    since_cut_s_ += dt_s;
    const Ringing cause = found();
    if (cause != Ringing::none && since_cut_s_ >= apart_s) cut(cause);
    if (gain_ > goal_) {
        gain_ = std::max(goal_, gain_ - goal_ * dt_s / cut_s);
    } else {
        goal_ = gain_ = std::min(1.0, gain_ + restore_per_s * dt_s);
    }
    return gain_;
}

void StabilityMonitor::count_swings(Force ripple, double dt_s) {
    swings_ *= std::exp(-dt_s / ringing_s);
    const bool is_large = norm(ripple) > std::numbers::sqrt2 * limits_.ripple_N;
    if (!is_large) return;
    if (dot(ripple, swing_) < 0.0) swings_ += 1.0;
    swing_ = ripple;
}

Ringing StabilityMonitor::found() const {
    if (generated_J_ > limits_.energy_J) return Ringing::energy;
    const bool is_ringing = swings_ > most_swings && recent_J_ > limits_.ripple_W * ringing_s;
    return is_ringing ? Ringing::ripple : Ringing::none;
}

void StabilityMonitor::cut(Ringing cause) {
    goal_ = std::max(least_gain, 0.5 * gain_);
    cause_ = cause;
    ++cuts_;
    since_cut_s_ = 0.0;
    swings_ = generated_J_ = 0.0;
}

double StiffnessRamp::step(double wanted_N_per_m, double depth_m, double dt_s) {
    const bool is_sound = std::isfinite(wanted_N_per_m) && wanted_N_per_m > 0.0 &&
                          std::isfinite(depth_m) && std::isfinite(dt_s) && dt_s > 0.0;
    if (!is_sound) return stiffness_N_per_m_;
    const double before = stiffness_N_per_m_;
    const double lowest = before - fall_N_per_s * dt_s / std::max(std::abs(depth_m), least_depth_m);
    const double wanted = std::max(wanted_N_per_m, lowest);
    stiffness_N_per_m_ = std::min(wanted, before * (1.0 + rise_per_s * dt_s));
    booked_J_ += 0.5 * (stiffness_N_per_m_ - before) * depth_m * depth_m;
    return stiffness_N_per_m_;
}

}  // namespace touchline
