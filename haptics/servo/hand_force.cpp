#include "haptics/servo/hand_force.h"

#include "haptics/servo/loop_settings.h"

#include <algorithm>

namespace touchline {
namespace {

// Enough for a hand that sweeps across a dense picture.
constexpr int most_boxes_per_tick = 4096;
constexpr double groove_peak = 0.287;      // of K w: a groove's strongest pull
constexpr double led_groove_N = 0.2;       // strongest pull while the hand is led
constexpr double pending_groove_N = 0.05;  // the same, until force is live
constexpr double share_per_s = 1.0 / 0.3;
constexpr double finger_lever_m = 0.01;  // from the handle's axis

/// Damps a twist as damped() does a force, by the force at the fingers.
double damped_turn_Nm(double spring_Nm, double rad_per_s, double damping_Ns_per_m) {
    const Force spring{spring_Nm / finger_lever_m, 0.0};
    const Velocity fingers{rad_per_s * finger_lever_m, 0.0};
    return finger_lever_m * damped(spring, fingers, damping_Ns_per_m).x;
}

}  // namespace

HandForce::HandForce(const DeviceProfile& profile, double period_s)
    : rendering_(profile, period_s),
      budget_{std::min(most_boxes_per_tick, affordable_boxes(period_s)), 0},
      stiffness_(ContactSettings{}.stiffness_N_per_m) {}

WantedForce HandForce::step(const StepInput& input, const HandleReading& handle,
                            const LoopState& loop) {
    events_ = {};
    WantedForce wanted;
    if (!handle.is_placed) return wanted;
    const ProbePose pose{handle.p_WH.x, handle.p_WH.y, handle.angle_rad};
    rendering_.measure_speed(pose, handle.dt_s);
    follow_wishes(input.commands, scene_for(input, pose, loop), pose, loop.is_silent);
    bound_level(input.commands);
    wanted.active = lead(input, handle, loop);
    ramp_stiffness(input.commands.contact.stiffness_N_per_m, handle, loop);
    render(input.commands, pose, loop);
    wanted.force = push(input.commands, handle, loop, wanted) + wanted.active;
    detect(input.now_s, handle.p_WH);
    return wanted;
}

void HandForce::bound_level(const ServoCommands& commands) {
    const bool is_fixed = !commands.is_level_auto;
    rendering_.bound_level(is_fixed ? commands.level : commands.finest_level,
                           is_fixed ? commands.level : commands.coarsest_level);
}

/// A hand that is led holds a point, because lines must not stop it.
void HandForce::follow_wishes(const ServoCommands& commands, const Scene* scene,
                              const ProbePose& handle, bool is_silent) {
    const bool may_hold = hand_ != nullptr && scene != nullptr && !is_led();
    const Felt wanted{commands.contact.radius_m, commands.contact.capture_m,
                      may_hold ? commands.shape : HeldShape::none};
    const bool is_other_scene = scene != rendering_.scene();
    is_swapping_ = is_other_scene || wanted != felt_;
    if (!is_swapping_ || !is_silent) return;
    if (is_other_scene) guidance_.leave_scene();
    felt_ = wanted;
    detector_.reset();
    rendering_.begin(scene, felt_.radius_m, may_hold ? hand_->probe(felt_.shape) : HeldProbe{});
    if (scene == nullptr) return;
    bound_level(commands);
    rendering_.place(handle, rendering_.level());
}

/// The wanted one; but the next map of the drawing that is felt waits until the hand cannot tell.
const Scene* HandForce::scene_for(const StepInput& input, const ProbePose& handle,
                                  const LoopState& loop) {
    const Scene* felt = rendering_.scene();
    const Scene* next = input.scene;
    const bool is_one_drawing = felt != nullptr && next != nullptr && next != felt &&
                                next->drawing != 0 && next->drawing == felt->drawing &&
                                next->area == felt->area;
    if (!is_one_drawing || loop.is_silent || rendering_.holds_shape()) return next;
    const ContactSettings settings = settings_of(input.commands, loop.spring_gain);
    if (is_led() || !rendering_.follow(*next, handle, settings, budget_)) return felt;
    guidance_.leave_scene();
    return next;
}

/// Adds what pushes by itself, in a tick with a pose; a held shape has been put down before.
Force HandForce::lead(const StepInput& input, const HandleReading& handle, const LoopState& loop) {
    const bool is_live = loop.is_live && !is_swapping_;
    const Force guiding =
        guidance_.step({rendering_.scene(), handle.p_WH, handle.velocity,
                        is_live && !rendering_.holds_shape(), input.commands.guidance},
                       loop.period_s);
    return guiding + pattern_.step(input.commands.pattern, is_live, loop.period_s);
}

void HandForce::ramp_stiffness(double set_N_per_m, const HandleReading& handle,
                               const LoopState& loop) {
    const double wanted_N_per_m = possible_N_per_m(loop.bound, set_N_per_m);
    // Without force, a change of stiffness does no work, so it need not be ramped.
    if (loop.is_silent) stiffness_ = StiffnessRamp(wanted_N_per_m);
    const double depth_m = norm(rendering_.rendered().contact.p_WP - handle.p_WH);
    (void)stiffness_.step(wanted_N_per_m, depth_m, handle.dt_s);
}

void HandForce::render(const ServoCommands& commands, const ProbePose& handle,
                       const LoopState& loop) {
    if (rendering_.scene() != nullptr) {
        const Mode points_mode = is_led() ? Mode::groove : commands.contact.mode;
        mode_ = rendering_.holds_shape() ? Mode::wall : points_mode;
        share_lines(commands.contact.capture_m, loop.period_s);
    }
    (void)rendering_.step(handle, rendering_.level(), settings_of(commands, loop.spring_gain),
                          budget_, loop.period_s);
}

ContactSettings HandForce::settings_of(const ServoCommands& commands, double spring_gain) const {
    ContactSettings settings = commands.contact;
    settings.mode = mode_;
    settings.stiffness_N_per_m = stiffness_N_per_m();
    settings.radius_m = felt_.radius_m;
    settings.capture_m = felt_.capture_m;
    settings.pop_through_N /= spring_gain;
    return settings;
}

/// The hand is led across lines too, so they must not hold it back, nor keep force from coming on
/// before.
void HandForce::share_lines(double capture_m, double period_s) {
    const double groove_N = groove_peak * stiffness_N_per_m() * capture_m;
    const double led_N = guidance_.leads() ? led_groove_N : pending_groove_N;
    const double goal = is_led() ? std::min(1.0, led_N / groove_N) : 1.0;
    const double step = share_per_s * period_s;
    line_share_ = std::clamp(goal, line_share_ - step, line_share_ + step);
}

/// Adds up what was rendered, softened if it rang, with the damping that keeps it from ringing.
Force HandForce::push(const ServoCommands& commands, const HandleReading& handle,
                      const LoopState& loop, WantedForce& wanted) const {
    const double gain = loop.spring_gain;
    wanted.is_continued = !is_swapping_;
    wanted.stiffness_N_per_m = gain * stiffness_N_per_m();
    if (rendering_.scene() == nullptr) return {};
    const Rendered& rendered = rendering_.rendered();
    const FramePush frame =
        commands.has_frame ? frame_push(rendering_.scene()->area, handle.p_WH, stiffness_N_per_m())
                           : FramePush{};
    wanted.shape_Nm = rendered.twist_Nm;
    wanted.lines_N = gain * line_share_ * norm(rendered.contact.force);
    wanted.lines_Nm = gain * line_share_ * rendered.twist_Nm;
    wanted.turn_Nm = damped_turn_Nm(wanted.lines_Nm, handle.rad_per_s, loop.damping_Ns_per_m);
    wanted.stored_J = gain * (line_share_ * rendered.contact.stored_J + frame.stored_J);
    return damped(gain * (line_share_ * rendered.contact.force + frame.force), handle.velocity,
                  loop.damping_Ns_per_m);
}

void HandForce::detect(double now_s, Position p_WH) {
    if (rendering_.scene() == nullptr) return;
    events_ = detector_.step({now_s, p_WH, mode_, rendering_.rendered().contact,
                              rendering_.rendered_level(), rendering_.scene()});
}

GuidanceStatus HandForce::guidance() const {
    GuidanceStatus status = guidance_.status();
    status.pattern_serial = pattern_.serial();
    return status;
}

bool HandForce::rebind(const Scene* scene) {
    hand_ = nullptr;
    events_ = {};
    return felt_.shape == HeldShape::none && rendering_.rebind(scene) && guidance_.fits(scene) &&
           pattern_.is_sound();
}

}  // namespace touchline
