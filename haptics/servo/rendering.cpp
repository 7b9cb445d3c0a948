#include "haptics/servo/rendering.h"

#include <utility>

namespace touchline {
namespace {

// What a change of the lines may do to a hand in one tick.
constexpr double unfelt_N = 0.02;
constexpr double unfelt_J = 1e-6;
constexpr double least_carried_m = 1e-9;  // a remainder below this is rounding, not lack of time

LevelLimits limits_of_device(const DeviceProfile& profile) {
    LevelLimits limits;
    limits.encoder_step_m = encoder_step_m(profile);
    limits.f_device_Hz = profile.bandwidth_Hz;
    return limits;
}

}  // namespace

ShapeInHand::ShapeInHand() {
    for (std::size_t i = 0; i < held_shape_count; ++i)
        shapes_.push_back(held_shape(static_cast<HeldShape>(i)));
    proxy_.reserve();
}

HeldProbe ShapeInHand::probe(HeldShape shape) {
    if (shape == HeldShape::none) return {};
    return {&shapes_[static_cast<std::size_t>(shape)], &proxy_};
}

Rendering::Rendering(const DeviceProfile& profile, double period_s)
    : limits_(limits_of_device(profile)),
      level_rule_(limits_),
      period_s_(period_s),
      cost_(period_s) {}

void Rendering::begin(const Scene* scene, double radius_m, const HeldProbe& probe) {
    scene_ = scene;
    probe_ = probe;
    rendered_ = {};
    if (scene == nullptr) return;
    if (holds_shape()) shape_speed_ = ShapeSpeed(probe.shape->r_max_m());
    take(*scene, holds_shape() ? probe.shape->radius_m() : radius_m);
    cost_ = CostTerm(period_s_);
}

void Rendering::take(const Scene& scene, double radius_m) {
    limits_.spacing_m = scene.curves.finest_spacing_m();
    limits_.radius_m = radius_m;
    limits_.percept = scene.percept_level;
    limits_.safe = scene.curves.coarsest();
}

bool Rendering::follow(const Scene& scene, const ProbePose& handle, const ContactSettings& settings,
                       const Budget& budget) {
    if (holds_shape()) return false;
    const auto felt_by = [&](ContactMachine machine) {
        return machine.step(handle.place(), rendered_level(), settings, budget, period_s_);
    };
    ContactMachine moved = contact_;
    moved.move_to(scene);
    const ContactReport before = felt_by(contact_);
    const ContactReport after = felt_by(moved);
    // Every comparison is written so that NaN fails it.
    const bool is_same = before.state == after.state && before.outline == after.outline &&
                         norm(after.force - before.force) <= unfelt_N &&
                         after.stored_J - before.stored_J <= unfelt_J;
    if (!is_same) return false;
    scene_ = &scene;
    contact_ = moved;
    take(scene, limits_.radius_m);
    return true;
}

void Rendering::place(const ProbePose& handle, double level) {
    if (holds_shape()) {
        probe_.proxy->reset(*probe_.shape, *scene_, handle, level);
    } else {
        contact_.reset(*scene_, handle.place(), level);
    }
}

void Rendering::measure_speed(const ProbePose& handle, double dt_s) {
    if (holds_shape()) {
        const double speed2 = shape_speed_.step(handle.place(), handle.angle_rad, dt_s);
        (void)level_rule_.step_at(speed2, dt_s);
    } else {
        (void)level_rule_.step(handle.place(), dt_s);
    }
}

void Rendering::bound_level(double finest, double coarsest) {
    limits_.finest = finest;
    limits_.coarsest = coarsest;
    limits_.cost = cost_.level();
    level_rule_.set_limits(limits_);
}

const Rendered& Rendering::step(const ProbePose& handle, double level,
                                const ContactSettings& settings, const Budget& budget,
                                double dt_s) {
    if (scene_ == nullptr) {
        rendered_.contact.p_WP = handle.place();
        rendered_.contact.level = level;
    } else if (holds_shape()) {
        feel_shape(handle, level, settings.stiffness_N_per_m, budget, dt_s);
    } else {
        rendered_.contact = contact_.step(handle.place(), level, settings, budget, dt_s);
        (void)cost_.step(work_of(rendered_.contact), contact_.rendered_level());
    }
    return rendered_;
}

void Rendering::feel_shape(const ProbePose& handle, double level, double stiffness_N_per_m,
                           const Budget& budget, double dt_s) {
    const ProbeReport report =
        probe_.proxy->step(handle, level, {stiffness_N_per_m, 0.0}, budget, dt_s);
    rendered_ = {contact_of(report, scene_->curves), report.torque_Nm, report.pose.angle_rad,
                 report.is_placed};
    (void)cost_.step({report.boxes, report.carried_m > least_carried_m}, report.level);
}

bool Rendering::rebind(const Scene* scene) {
    const bool had_scene = std::exchange(scene_, scene) != nullptr;
    const bool held_shape = probe_.shape != nullptr || probe_.proxy != nullptr;
    probe_ = {};
    return had_scene == (scene != nullptr) && !held_shape && level_rule_.is_sound() &&
           cost_.is_sound() && contact_.rebind(scene);
}

}  // namespace touchline
