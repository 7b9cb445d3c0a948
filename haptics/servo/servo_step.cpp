#include "haptics/servo/servo_step.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace touchline {

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
    const auto angles = inverse(profile_.geometry, profile_.centre);
    return fits && angles && forward(profile_.geometry, *angles) &&
           loop_.period_s() >= shortest_s && loop_.period_s() <= 1.0 && handle_.is_sound();
}

LoopState ServoStep::loop_state(const ServoCommands& commands) const {
    const bool is_live = motor_force_.is_live() && !is_stopping_ && commands.is_force_wanted &&
                         !commands.is_emergency_stop;
    return {loop_.period_s(),           motor_force_.is_silent(), is_live,
            motor_force_.spring_gain(), loop_.stiffness_bound(),  loop_.damping_Ns_per_m()};
}

JointTorques ServoStep::step(const StepInput& input) {
    const double period_s = loop_.period_s();
    const double dt_s = std::max(period_s, input.now_s - last_s_);
    last_s_ = input.now_s;
    loop_.step(profile_, dt_s, input.delay_s);
    const auto shape_rad =
        holds_shape() ? std::optional(hand_force_.rendering().rendered().angle_rad) : std::nullopt;
    const HandleReading handle = handle_.step(profile_, input, shape_rad, period_s, dt_s);
    const WantedForce wanted = hand_force_.step(input, handle, loop_state(input.commands));
    watch_hand(handle, wanted.active);
    const bool is_fading = hand_force_.is_swapping() || is_stopping_;
    const SafeForce safe = motor_force_.step(profile_, input, handle, wanted, is_fading, period_s);
    handle_Nm_ = safe.handle_Nm;
    fill(input, handle, wanted, safe);
    return safe.torques;
}

/// Guidance and patterns move the handle on purpose.
void ServoStep::watch_hand(const HandleReading& handle, Force active) {
    const bool is_told = handle.pose && !handle.has_jumped && active == Force{};
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
