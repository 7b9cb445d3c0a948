#include "haptics/servo/servo_step.h"

#include "haptics/guidance/frame.h"
#include "haptics/probe/held_shapes.h"
#include "haptics/servo/virtual_damping.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace touchline {
namespace {

// Enough for a hand that sweeps across a dense picture.
constexpr int most_boxes_per_tick = 4096;
constexpr double longest_silence_s = 0.02;
constexpr double measuring_s = 1.0;
constexpr double longest_period_s = 0.02;  // a longer one is a pause, not the loop's period
constexpr double ceiling_rise_N_per_s = 1.0;
constexpr double groove_peak = 0.287;      // of K w: a groove's strongest pull
constexpr double led_groove_N = 0.2;       // strongest pull while the hand is led
constexpr double pending_groove_N = 0.05;  // the same, until force is live
constexpr double share_per_s = 1.0 / 0.3;
constexpr double least_carried_m = 1e-9;  // a remainder below this is rounding, not lack of time
constexpr double finger_lever_m = 0.01;   // from the handle's axis

double count_of(const std::optional<TurningHandle>& handle) {
    return handle ? encoder_quantum_rad(*handle) : 1e-3;
}

LevelLimits limits_of_device(const DeviceProfile& profile) {
    LevelLimits limits;
    limits.encoder_step_m = encoder_step_m(profile);
    limits.f_device_Hz = profile.bandwidth_Hz;
    return limits;
}

}  // namespace

ServoStep::ServoStep(const DeviceProfile& profile, double period_s, const TierLimits& tier)
    : profile_(profile),
      period_s_(period_s),
      tier_(tier),
      chain_(limits_of(profile)),
      position_guard_(encoder_step_m(profile)),
      level_limits_(limits_of_device(profile)),
      level_rule_(level_limits_),
      cost_(period_s),
      boxes_per_tick_(std::min(most_boxes_per_tick, affordable_boxes(period_s))),
      stiffness_(ServoCommands{}.contact.stiffness_N_per_m),
      loop_(loop_settings(profile, period_s, 0.0)),
      measured_period_s_(period_s),
      velocity_(encoder_step_m(profile)),
      turn_(count_of(profile.handle)) {}

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
    const bool had_scene = felt_.scene != nullptr;
    profile_.name = profile.name;
    felt_.scene = scene;
    hand_ = nullptr;
    events_ = {};
    const auto angles = inverse(profile_.geometry, profile_.centre);
    if (!angles || !forward(profile_.geometry, *angles)) return false;
    return had_scene == (scene != nullptr) && !holds_shape() && turn_.is_sound() &&
           period_s_ >= shortest_s && period_s_ <= 1.0 && level_rule_.is_sound() &&
           cost_.is_sound() && velocity_.is_sound() && guidance_.fits(scene) &&
           pattern_.is_sound() && contact_.rebind(scene);
}

JointTorques ServoStep::step(const StepInput& input) {
    const double dt_s = std::max(period_s_, input.now_s - last_s_);
    last_s_ = input.now_s;
    measure_loop(input, dt_s);
    const std::optional<Pose> pose = find_pose(input, dt_s);
    Force wanted_W;
    twist_Nm_ = 0.0;
    if (!pose || sample_ == Sample::jumped) velocity_.reset();
    events_ = {};
    if (pose) {
        const Position before = p_WH_;
        p_WH_ = picture_from_device(profile_, pose->p_DH);
        moved_ = p_WH_ - before;
        (void)velocity_.step(p_WH_, dt_s);
        turn(input, dt_s);
        follow_speed(dt_s);
        follow_wishes(input);
        bound_level(input.commands);
        lead(input);
        wanted_W = feel(input.commands, dt_s) + active_;
        detect(input);
    }
    const SafeForce safe = make_safe(wanted_W, pose, input);
    if (pose) watch(turned(safe.force_D), wanted_W, dt_s);
    handle_Nm_ = safe.handle_Nm;
    fill(input, safe);
    return safe.torques;
}

/// What the loop may render follows from how it runs, not from what was asked for. Averages slowly
/// over a second, and works the settings out again once a second.
void ServoStep::measure_loop(const StepInput& input, double dt_s) {
    const double weight = std::min(1.0, dt_s / measuring_s);
    measured_period_s_ += weight * (std::min(dt_s, longest_period_s) - measured_period_s_);
    if (input.delay_s >= 0.0) {
        measured_delay_s_ +=
            weight * (std::min(input.delay_s, longest_period_s) - measured_delay_s_);
    }
    if (--ticks_to_measure_ > 0) return;
    ticks_to_measure_ = static_cast<int>(measuring_s / period_s_);
    loop_ = loop_settings(profile_, measured_period_s_, measured_delay_s_);
}

/// Where the handle is, or was a few ticks ago: a jump is not believed at once.
std::optional<Pose> ServoStep::find_pose(const StepInput& input, double dt_s) {
    silent_s_ = input.angles ? 0.0 : silent_s_ + period_s_;
    const auto pose = input.angles ? forward(profile_.geometry, *input.angles) : std::nullopt;
    sample_ = Sample::good;
    if (!pose) {
        position_guard_.miss(dt_s);
        return pose;
    }
    sample_ = position_guard_.step(pose->p_DH, dt_s);
    if (sample_ != Sample::held) good_pose_ = pose;
    return good_pose_;
}

SafeForce ServoStep::make_safe(Force wanted_W, const std::optional<Pose>& pose,
                               const StepInput& input) {
    ChainInput chain;
    chain.wanted_D = turned(wanted_W);
    if (pose) chain.jacobian = pose->jacobian;
    chain.p_D = device_from_picture(profile_, p_WH_);
    chain.velocity_D = turned(velocity_.velocity());
    chain.is_unreadable = (input.angles && !is_finite(*input.angles)) ||
                          (input.handle_rad && !std::isfinite(*input.handle_rad));
    chain.wanted_turn_Nm = damped_twist_Nm();
    chain.handle_rad = turn_.angle_rad();
    chain.turn_rad_per_s = turn_.rad_per_s();
    chain.share = input.force_share;
    ceiling_N_ =
        std::min(input.commands.force_ceiling_N, ceiling_N_ + ceiling_rise_N_per_s * period_s_);
    chain.ceiling_N = ceiling_N_;
    chain.is_wanted = input.commands.is_force_wanted;
    chain.is_fading = is_swapping_ || is_stopping_;
    chain.is_cleared = std::exchange(faults_cleared_, input.commands.faults_cleared) !=
                       input.commands.faults_cleared;
    chain.is_stopped = input.commands.is_emergency_stop;
    chain.is_lost = std::exchange(is_refused_, false) || silent_s_ > longest_silence_s;
    chain.has_jumped = sample_ == Sample::jumped;
    chain.cuts = monitor_.cuts();
    // Ramps and slew advance by one period however late the tick is.
    return chain_.step(chain, period_s_);
}

void ServoStep::bound_level(const ServoCommands& commands) {
    const bool is_fixed = !commands.is_level_auto;
    level_limits_.finest = is_fixed ? commands.level : commands.finest_level;
    level_limits_.coarsest = is_fixed ? commands.level : commands.coarsest_level;
    level_limits_.cost = cost_.level();
    level_rule_.set_limits(level_limits_);
}

void ServoStep::turn(const StepInput& input, double dt_s) {
    const double shape_rad = holds_shape() ? proxy_angle_rad_ : turn_.angle_rad();
    turn_.step(input.handle_rad, input.commands.turn_rad, shape_rad, dt_s);
}

void ServoStep::follow_speed(double dt_s) {
    if (holds_shape()) {
        (void)level_rule_.step_at(shape_speed_.step(p_WH_, turn_.angle_rad(), dt_s), dt_s);
    } else {
        (void)level_rule_.step(p_WH_, dt_s);
    }
}

/// A hand that is led holds a point, because lines must not stop it.
void ServoStep::follow_wishes(const StepInput& input) {
    const ServoCommands& commands = input.commands;
    const bool may_hold =
        hand_ != nullptr && input.scene != nullptr && !guidance_.leads() && !guidance_.is_pending();
    const Felt wanted{input.scene, commands.contact.radius_m, commands.contact.capture_m,
                      may_hold ? commands.shape : HeldShape::none};
    is_swapping_ = wanted != felt_;
    if (!is_swapping_ || !chain_.is_faded()) return;
    if (felt_.scene != wanted.scene) guidance_.leave_scene();
    felt_ = wanted;
    contact_report_ = {};
    detector_.reset();
    if (felt_.scene == nullptr) return;
    begin_to_feel();
    bound_level(commands);
    if (holds_shape()) {
        hand_->take(felt_.shape, *felt_.scene, handle_pose(), level_rule_.level());
    } else {
        contact_.reset(*felt_.scene, p_WH_, level_rule_.level());
    }
}

void ServoStep::begin_to_feel() {
    level_limits_.spacing_m = felt_.scene->curves.finest_spacing_m();
    level_limits_.radius_m = felt_.radius_m;
    if (holds_shape()) {
        const ProbeShape& shape = hand_->shape_of(felt_.shape);
        level_limits_.radius_m = shape.radius_m();
        shape_speed_ = ShapeSpeed(shape.r_max_m());
        proxy_angle_rad_ = turn_.angle_rad();
    }
    level_limits_.percept = felt_.scene->percept_level;
    level_limits_.safe = felt_.scene->curves.coarsest();
    cost_ = CostTerm(period_s_);
}

StiffnessBound ServoStep::stiffness_bound() const {
    return {tier_.stiffness_share, loop_.largest_stiffness_N_per_m};
}

Force ServoStep::feel(const ServoCommands& commands, double dt_s) {
    const double level = level_rule_.level();
    const double wanted_N_per_m =
        possible_N_per_m(stiffness_bound(), commands.contact.stiffness_N_per_m);
    // Without force, a change of stiffness does no work, so it need not be ramped.
    if (chain_.is_faded()) stiffness_ = StiffnessRamp(wanted_N_per_m);
    const double depth_m = norm(contact_report_.p_WP - p_WH_);
    (void)stiffness_.step(wanted_N_per_m, depth_m, dt_s);
    if (felt_.scene == nullptr) {
        frame_J_ = 0.0;
        contact_report_.p_WP = p_WH_;
        contact_report_.level = level;
        return {};
    }
    const bool is_led = guidance_.leads() || guidance_.is_pending();
    if (holds_shape()) {
        mode_ = Mode::wall;
        feel_shape(level);
    } else {
        mode_ = is_led ? Mode::groove : commands.contact.mode;
        feel_point(commands, level);
    }
    share_lines(commands, is_led);
    const FramePush frame =
        commands.has_frame ? frame_push(felt_.scene->area, p_WH_, stiffness_.stiffness_N_per_m())
                           : FramePush{};
    frame_J_ = frame.stored_J;
    // Softened if it rang, with the damping that keeps it from ringing.
    return damped(monitor_.gain() * (line_share_ * contact_report_.force + frame.force),
                  velocity_.velocity(), loop_.damping_Ns_per_m + tier_.extra_damping_Ns_per_m);
}

void ServoStep::feel_point(const ServoCommands& commands, double level) {
    ContactSettings settings = commands.contact;
    settings.mode = mode_;
    settings.stiffness_N_per_m = stiffness_.stiffness_N_per_m();
    settings.radius_m = felt_.radius_m;
    settings.capture_m = felt_.capture_m;
    settings.pop_through_N /= monitor_.gain();
    contact_report_ = contact_.step(p_WH_, level, settings, Budget{boxes_per_tick_, 0}, period_s_);
    (void)cost_.step(work_of(contact_report_), contact_.rendered_level());
}

void ServoStep::feel_shape(double level) {
    const ProbeReport report = hand_->step(handle_pose(), level, stiffness_.stiffness_N_per_m(),
                                           Budget{boxes_per_tick_, 0}, period_s_);
    contact_report_ = contact_of(report, felt_.scene->curves);
    twist_Nm_ = report.torque_Nm;
    proxy_angle_rad_ = report.pose.angle_rad;
    is_shape_placed_ = report.is_placed;
    (void)cost_.step({report.boxes, report.carried_m > least_carried_m}, report.level);
}

/// Damps the twist as damped() does a force, by the force at the fingers.
double ServoStep::damped_twist_Nm() const {
    const Force spring{monitor_.gain() * line_share_ * twist_Nm_ / finger_lever_m, 0.0};
    const Velocity fingers{turn_.rad_per_s() * finger_lever_m, 0.0};
    const double damping_Ns_per_m = loop_.damping_Ns_per_m + tier_.extra_damping_Ns_per_m;
    return finger_lever_m * damped(spring, fingers, damping_Ns_per_m).x;
}

/// The hand is led across lines too, so they must not hold it back, nor keep force from coming on
/// before.
void ServoStep::share_lines(const ServoCommands& commands, bool is_led) {
    const double groove_N =
        groove_peak * stiffness_.stiffness_N_per_m() * commands.contact.capture_m;
    const double led_N = guidance_.leads() ? led_groove_N : pending_groove_N;
    const double goal = is_led ? std::min(1.0, led_N / groove_N) : 1.0;
    const double step = share_per_s * period_s_;
    line_share_ = std::clamp(goal, line_share_ - step, line_share_ + step);
}

/// Adds what pushes by itself, in a tick with a pose; a held shape has been put down before.
void ServoStep::lead(const StepInput& input) {
    const bool is_live = chain_.state() == ForceState::live && !is_swapping_ && !is_stopping_ &&
                         input.commands.is_force_wanted && !input.commands.is_emergency_stop;
    active_ = guidance_.step({felt_.scene, p_WH_, velocity_.velocity(), is_live && !holds_shape(),
                              input.commands.guidance},
                             period_s_);
    active_ += pattern_.step(input.commands.pattern, is_live, period_s_);
}

/// Watches what the motors were told, not what was asked for, because that is what rings. A spring
/// whose force is cut short gives back no more than what is told; pressed beyond that it would seem
/// to give energy.
void ServoStep::watch(Force told, Force wanted, double dt_s) {
    const double gain = monitor_.gain();
    // Guidance is meant to give energy and a pattern to swing, so only the rest is watched.
    const double let_through = norm(wanted) > norm(told) ? norm(told) / norm(wanted) : 1.0;
    told = told - let_through * active_;
    const double lost_N =
        std::max(0.0, gain * line_share_ * norm(contact_report_.force) - norm(told));
    const double lost_J = 0.5 * lost_N * lost_N / (gain * stiffness_.stiffness_N_per_m());
    const double stored_J = gain * (line_share_ * contact_report_.stored_J + frame_J_) - lost_J;
    const double turning_J = gain * line_share_ * twist_Nm_ * turn_.turned_rad();
    monitor_.step({told, moved_, stored_J, !is_swapping_, turning_J}, dt_s);
}

void ServoStep::detect(const StepInput& input) {
    if (felt_.scene == nullptr) return;
    events_ =
        detector_.step({input.now_s, p_WH_, mode_, contact_report_, rendered_level(), felt_.scene});
}

void ServoStep::fill(const StepInput& input, const SafeForce& safe) {
    HandState& hand = report_.hand;
    hand.time_s = input.now_s;
    hand.p_WH = p_WH_;
    hand.p_WP = contact_report_.p_WP;
    hand.force = turned(safe.force_D);
    hand.speed_m_per_s = level_rule_.speed_m_per_s();
    hand.level = contact_report_.level;
    hand.level_terms = level_rule_.terms();
    hand.is_level_auto = input.commands.is_level_auto;
    hand.stiffness_N_per_m = stiffness_.stiffness_N_per_m();
    hand.stiffness_bound = stiffness_bound();
    hand.spring_gain = monitor_.gain();
    hand.mode = mode_;
    hand.state = contact_report_.state;
    hand.outline = contact_report_.outline;
    ++hand.ticks;
    hand.missed_ticks = input.missed_ticks;
    hand.map_version = felt_.scene == nullptr ? 0 : felt_.scene->map_version;
    hand.guidance = guidance_.status();
    hand.guidance.pattern_serial = pattern_.serial();
    hand.shape = felt_.shape;
    hand.is_shape_placed = holds_shape() && is_shape_placed_;
    hand.angle_rad = turn_.angle_rad();
    hand.proxy_angle_rad = holds_shape() ? proxy_angle_rad_ : turn_.angle_rad();
    hand.torque_Nm = monitor_.gain() * twist_Nm_;
    report_.force = chain_.status();
}

}  // namespace touchline
