#include "haptics/servo/servo_step.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace touchline {
namespace {

constexpr double longest_silence_s = 0.02;
constexpr double ceiling_rise_N_per_s = 1.0;

bool is_finite(const OffPlane& plane) {
    return std::isfinite(plane.off_m) && std::isfinite(plane.m_per_s) &&
           std::isfinite(plane.on_plane) && std::isfinite(plane.across_N);
}

bool is_unreadable(const std::optional<DeviceReading>& told) {
    if (!told) return false;
    const bool is_number = is_finite(told->joints) && is_finite(told->p_D.value_or(Position{})) &&
                           is_finite(told->jacobian.value_or(Jacobian{})) &&
                           is_finite(told->velocity_D.value_or(Velocity{})) &&
                           is_finite(told->off_plane.value_or(OffPlane{})) &&
                           std::isfinite(told->handle_rad.value_or(0.0));
    return !is_number;
}

/// Of force and torques the device gets its own.
DeviceCommand command_of(const SafeForce& safe, const DeviceProfile& profile) {
    if (has_joints(profile)) return {{}, safe.torques, safe.handle_Nm, 0.0};
    return {safe.force_D, {}, safe.handle_Nm, safe.plane_share};
}

bool is_steppable(const DeviceProfile& profile) {
    if (!has_joints(profile)) return profile.cartesian->step_m > 0.0;
    const auto angles = inverse(profile.geometry, profile.centre);
    return angles && forward(profile.geometry, *angles);
}

}  // namespace

SafeForce MotorForce::step(const DeviceProfile& profile, const StepInput& input,
                           const HandleReading& handle, const WantedForce& wanted, bool is_fading,
                           double period_s) {
    const ServoCommands& commands = input.commands;
    ChainInput chain;
    chain.wanted_D = turned(wanted.force);
    chain.is_placed = handle.is_placed;
    chain.jacobian = handle.jacobian;
    chain.p_D = device_from_picture(profile, handle.p_WH);
    chain.velocity_D = turned(handle.velocity);
    if (input.reading && input.reading->off_plane) {
        chain.across_m_per_s = input.reading->off_plane->m_per_s;
        chain.across_N = input.reading->off_plane->across_N;
        chain.on_plane = input.reading->off_plane->on_plane;
    }
    chain.is_unreadable = is_unreadable(input.reading);
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
    if (handle.is_placed) watch(turned(safe.force_D), handle, wanted);
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

ServoStep::ServoStep(const DeviceProfile& profile, double period_s, const TierLimits& tier)
    : profile_(profile),
      loop_(profile, period_s, tier),
      handle_(profile),
      hand_force_(profile, period_s),
      motor_force_(profile),
      hand_work_(limits_of(profile).tip) {}

std::optional<ServoStep> ServoStep::from_memory(std::span<const std::byte> bytes,
                                                const Scene* scene, const DeviceProfile& profile) {
    static_assert(std::is_trivially_copyable_v<ServoStep>);
    if (bytes.size() != sizeof(ServoStep)) return std::nullopt;
    std::optional<ServoStep> step(std::in_place, profile, 1e-3);
    std::memcpy(static_cast<void*>(&*step), bytes.data(), bytes.size());
    if (!step->rebind(scene, profile)) return std::nullopt;
    return step;
}

/// Mends every pointer into the old memory.
bool ServoStep::rebind(const Scene* scene, const DeviceProfile& profile) {
    constexpr double shortest_s = 1e-5;
    profile_.name = profile.name;
    const bool fits = hand_force_.rebind(scene);
    return fits && is_steppable(profile_) && loop_.period_s() >= shortest_s &&
           loop_.period_s() <= 1.0 && handle_.is_sound();
}

LoopState ServoStep::loop_state(const ServoCommands& commands) const {
    const bool is_live = motor_force_.is_live() && !is_stopping_ && commands.is_force_wanted &&
                         !commands.is_emergency_stop;
    return {loop_.period_s(),           motor_force_.is_silent(), is_live,
            motor_force_.spring_gain(), loop_.stiffness_bound(),  loop_.damping_Ns_per_m()};
}

/// The time from the last tick to this one, by plan: what ramps and slew advance by.
double ServoStep::planned_s(double now_s) const {
    const double period_s = loop_.period_s();
    if (!is_resting()) return period_s;
    return std::max(period_s, std::min(now_s - last_s_, resting_period_s));
}

void ServoStep::rest(const StepInput& input, const HandleReading& handle,
                     const DeviceCommand& command) {
    const ServoCommands& commands = input.commands;
    const bool is_idle = commands.may_rest && !commands.is_force_wanted && is_silent() &&
                         command == DeviceCommand{} && !is_stopping_;
    rest_.step(is_idle && handle.is_placed, handle.p_WH, handle.dt_s);
}

DeviceCommand ServoStep::step(const StepInput& input) {
    const double period_s = planned_s(input.now_s);
    const double dt_s = std::max(period_s, input.now_s - last_s_);
    last_s_ = input.now_s;
    // A rest says nothing of how well the loop keeps its period.
    loop_.step(profile_, is_resting() ? loop_.period_s() : dt_s, input.delay_s);
    const auto shape_rad =
        holds_shape() ? std::optional(hand_force_.rendering().rendered().angle_rad) : std::nullopt;
    const HandleReading handle = handle_.step(profile_, input, shape_rad, period_s, dt_s);
    const WantedForce wanted = hand_force_.step(input, handle, loop_state(input.commands));
    watch_hand(handle, wanted.active);
    const bool is_fading = hand_force_.is_swapping() || is_stopping_;
    const SafeForce safe = motor_force_.step(profile_, input, handle, wanted, is_fading, period_s);
    fill(input, handle, wanted, safe);
    const DeviceCommand command = command_of(safe, profile_);
    rest(input, handle, command);
    return command;
}

/// Guidance and patterns move the handle on purpose.
void ServoStep::watch_hand(const HandleReading& handle, Force active) {
    const bool is_told = handle.is_placed && !handle.has_jumped && active == Force{};
    if (is_told)
        hand_work_.step(report_.hand.force, handle.p_WH, handle.dt_s);
    else
        hand_work_.disturb(handle.p_WH);
}

void ServoStep::fill(const StepInput& input, const HandleReading& handle, const WantedForce& wanted,
                     const SafeForce& safe) {
    const Rendering& rendering = hand_force_.rendering();
    const Rendered& rendered = rendering.rendered();
    HandState& hand = report_.hand;
    hand.time_s = input.now_s;
    hand.p_WH = handle.p_WH;
    hand.p_WP = rendered.contact.p_WP;
    hand.force = turned(safe.force_D);
    hand.speed_m_per_s = rendering.level_rule().speed_m_per_s();
    hand.level = rendered.contact.level;
    hand.level_terms = rendering.level_rule().terms();
    hand.is_level_auto = input.commands.is_level_auto;
    hand.stiffness_N_per_m = hand_force_.stiffness_N_per_m();
    hand.stiffness_bound = loop_.stiffness_bound();
    hand.spring_gain = motor_force_.spring_gain();
    hand.mode = hand_force_.mode();
    hand.state = rendered.contact.state;
    hand.outline = rendered.contact.outline;
    ++hand.ticks;
    hand.missed_ticks = input.missed_ticks;
    hand.map_version = rendering.scene() == nullptr ? 0 : rendering.scene()->map_version;
    hand.guidance = hand_force_.guidance();
    hand.shape = hand_force_.shape();
    hand.is_shape_placed = rendering.holds_shape() && rendered.is_placed;
    hand.angle_rad = handle.angle_rad;
    hand.proxy_angle_rad = rendering.holds_shape() ? rendered.angle_rad : handle.angle_rad;
    hand.torque_Nm = motor_force_.spring_gain() * wanted.shape_Nm;
    hand.hand_moves = hand_work_.moves();
    report_.force = motor_force_.status();
}

}  // namespace touchline
