#include "haptics/servo/motor_force.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double longest_silence_s = 0.02;
constexpr double ceiling_rise_N_per_s = 1.0;

bool is_unreadable(const StepInput& input) {
    return (input.angles && !is_finite(*input.angles)) ||
           (input.handle_rad && !std::isfinite(*input.handle_rad));
}

}  // namespace

SafeForce MotorForce::step(const DeviceProfile& profile, const StepInput& input,
                           const HandleReading& handle, const WantedForce& wanted, bool is_fading,
                           double period_s) {
    const ServoCommands& commands = input.commands;
    ChainInput chain;
    chain.wanted_D = turned(wanted.force);
    if (handle.pose) chain.jacobian = handle.pose->jacobian;
    chain.p_D = device_from_picture(profile, handle.p_WH);
    chain.velocity_D = turned(handle.velocity);
    chain.is_unreadable = is_unreadable(input);
    chain.wanted_turn_Nm = wanted.turn_Nm;
    chain.handle_rad = handle.angle_rad;
    chain.turn_rad_per_s = handle.rad_per_s;
    chain.share = input.force_share;
    ceiling_N_ = std::min(commands.force_ceiling_N, ceiling_N_ + ceiling_rise_N_per_s * period_s);
    chain.ceiling_N = ceiling_N_;
    chain.is_wanted = commands.is_force_wanted;
    chain.is_fading = is_fading;
    chain.is_cleared =
        std::exchange(faults_cleared_, commands.faults_cleared) != commands.faults_cleared;
    chain.is_stopped = commands.is_emergency_stop;
    chain.is_lost = std::exchange(is_refused_, false) || handle.silent_s > longest_silence_s;
    chain.has_jumped = handle.has_jumped;
    chain.cuts = monitor_.cuts();
    // Ramps and slew advance by one period however late the tick is.
    const SafeForce safe = chain_.step(chain, period_s);
    if (handle.pose) watch(turned(safe.force_D), handle, wanted);
    return safe;
}

/// Watches what the motors were told, not what was asked for, because that is what rings. A spring
/// whose force is cut short gives back no more than what is told; pressed beyond that it would seem
/// to give energy.
void MotorForce::watch(Force told, const HandleReading& handle, const WantedForce& wanted) {
    // Guidance is meant to give energy and a pattern to swing, so only the rest is watched.
    const double let_through =
        norm(wanted.force) > norm(told) ? norm(told) / norm(wanted.force) : 1.0;
    told = told - let_through * wanted.active;
    const double lost_N = std::max(0.0, wanted.lines_N - norm(told));
    const double lost_J = 0.5 * lost_N * lost_N / wanted.stiffness_N_per_m;
    const double turning_J = wanted.lines_Nm * handle.turned_rad;
    monitor_.step({told, handle.moved, wanted.stored_J - lost_J, wanted.is_continued, turning_J},
                  handle.dt_s);
}

}  // namespace touchline
