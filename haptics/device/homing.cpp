#include "haptics/device/homing.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double listen_s = 3.0;     // of a step's words, before a rest counts
constexpr double rest_s = 1.0;       // of stillness
constexpr double patience_s = 30.0;  // without a motion: say the step again
constexpr double longest_silence_s = 0.5;
constexpr double fit_m = 3e-3;         // of the elbows, between where they read and must be
constexpr double same_place_m = 1e-3;  // two rests at one stop
constexpr double leave_m = 3e-3;       // from where the words began, before a rest counts
constexpr double largest_scale_error = 0.15;
constexpr int largest_misses = 3;
constexpr double beyond_m = 2e-3;  // past a stop
constexpr double beyond_s = 0.3;

JointAngles scaled(JointAngles scale, JointAngles turn) {
    return {scale.x * turn.x, scale.y * turn.y};
}

bool is_scale(JointAngles scale) {
    return std::abs(scale.x - 1.0) <= largest_scale_error &&
           std::abs(scale.y - 1.0) <= largest_scale_error;
}

/// Two counts and what a hand that leans on a stop still trembles.
JointAngles resting_band(const HomingPlan& plan) {
    const double tremble = 3e-4 / plan.arm_m;
    return {2.0 * plan.quantum.x + tremble, 2.0 * plan.quantum.y + tremble};
}

}  // namespace

HomingPlan homing_plan(const DeviceProfile& profile) {
    return {profile.home, profile.check.angles, profile.geometry.proximal_m,
            encoder_quantum(profile)};
}

Homing::Homing(const HomingPlan& plan, const std::optional<Calibration>& stored)
    : plan_(plan),
      is_scale_known_(stored && is_scale(stored->scale)),
      calibration_(stored.value_or(Calibration{})),
      stillness_(resting_band(plan)) {
    if (!is_scale_known_) calibration_.scale = {1.0, 1.0};
}

Calibration Homing::bare() const {
    Calibration bare = calibration_;
    bare.offset = {};
    bare.scale = {1.0, 1.0};
    return bare;
}

double Homing::elbow_m(JointAngles turn) const {
    return plan_.arm_m * std::max(std::abs(turn.x), std::abs(turn.y));
}

void Homing::go(HomingStep step, HomingRemark remark) {
    view_.step = step;
    view_.remark = remark;
    ++view_.prompts;
    is_prompted_ = true;
    since_s_ = 0.0;
}

HomingView Homing::step(const std::optional<JointAngles>& read, double dt_s) {
    if (view_.step == HomingStep::done) return view_;
    view_.held = 0.0;
    if (!read || !is_finite(*read)) {
        miss_reading(dt_s);
        return view_;
    }
    silent_s_ = 0.0;
    if (view_.remark == HomingRemark::silent) go(view_.step, HomingRemark::none);
    watch(*read, dt_s);
    if (since_s_ >= patience_s && !has_left_) go(view_.step, HomingRemark::not_moved);
    // Nobody who has not moved since the words began has understood them.
    if (!has_left_) return view_;
    view_.held = std::min(1.0, stillness_.still_s() / rest_s);
    if (view_.held == 1.0) rest(*read);
    return view_;
}

void Homing::miss_reading(double dt_s) {
    stillness_.start_again();
    silent_s_ += dt_s;
    if (silent_s_ < longest_silence_s || view_.remark == HomingRemark::silent) return;
    go(view_.step, HomingRemark::silent);
}

void Homing::watch(JointAngles read, double dt_s) {
    if (is_prompted_) {
        prompted_at_ = read;
        has_left_ = false;
        is_prompted_ = false;
    }
    since_s_ += dt_s;
    stillness_.step(read, dt_s);
    has_left_ = has_left_ || !(elbow_m(read - prompted_at_) < leave_m);
    if (!(since_s_ >= listen_s)) stillness_.start_again();
}

void Homing::rest(JointAngles read) {
    switch (view_.step) {
        case HomingStep::to_home:
            return rest_at_home(read);
        case HomingStep::to_check:
        case HomingStep::to_check_again:
            return rest_at_check(read);
        case HomingStep::to_home_again:
            return rest_at_home_again(read);
        case HomingStep::done:
            return;
    }
}

void Homing::rest_at_home(JointAngles read) {
    read_at_home_ = read;
    go(HomingStep::to_check, HomingRemark::none);
}

void Homing::rest_at_check(JointAngles read) {
    const JointAngles turn = read - read_at_home_;
    const JointAngles wanted = plan_.check - plan_.home;
    const double misfit_m = elbow_m(scaled(calibration_.scale, turn) - wanted);
    const JointAngles scale{wanted.x / turn.x, wanted.y / turn.y};
    const JointAngles crossed{wanted.x / turn.y, wanted.y / turn.x};
    view_.misfit_m = misfit_m;
    if (view_.step == HomingStep::to_check_again) {
        // The same place twice: a stop, and not where a hand happened to pause.
        if (!(elbow_m(read - read_at_check_) <= same_place_m)) return miss(misfit_m);
        calibration_.scale = scale;
        return finish(HomingRemark::measured);
    }
    if (is_scale_known_ && misfit_m <= fit_m) return finish(HomingRemark::none);
    if (!is_scale(scale) && is_scale(crossed)) return cross();
    if (is_scale_known_ || !is_scale(scale)) return miss(misfit_m);
    read_at_check_ = read;
    go(HomingStep::to_home_again, HomingRemark::none);
}

void Homing::finish(HomingRemark remark) {
    calibration_.offset = scaled(calibration_.scale, plan_.home - read_at_home_);
    go(HomingStep::done, remark);
}

void Homing::rest_at_home_again(JointAngles read) {
    const double misfit_m = elbow_m(read - read_at_home_);
    if (!(misfit_m <= same_place_m)) return miss(misfit_m);
    go(HomingStep::to_check_again, HomingRemark::none);
}

void Homing::miss(double misfit_m) {
    view_.misfit_m = misfit_m;
    ++misses_;
    if (misses_ < largest_misses) return go(view_.step, HomingRemark::misfit);
    misses_ = 0;
    go(HomingStep::to_home, HomingRemark::starting_over);
}

/// Swapped plugs read as the two stops do when they are visited in the wrong order: nothing else
/// tells one from the other on arms that are alike. So it must come again, and more often on a unit
/// whose plugs were right once.
void Homing::cross() {
    ++crossings_;
    if (crossings_ < (is_scale_known_ ? 3 : 2))
        return go(HomingStep::to_home, HomingRemark::reversed);
    crossings_ = 0;
    calibration_.are_motors_swapped = !calibration_.are_motors_swapped;
    go(HomingStep::to_home, HomingRemark::swapped);
}

bool DriftWatch::step(JointAngles angles, double dt_s) {
    const JointAngles way = plan_.check - plan_.home;
    const auto past = [](double angle, double way_of_joint) {
        return way_of_joint < 0.0 ? -angle : angle;
    };
    const double limit = beyond_m / plan_.arm_m;
    const JointAngles from_home = angles - plan_.home;
    const JointAngles from_check = angles - plan_.check;
    const bool is_beyond_home =
        past(from_home.x, way.x) < -limit && past(from_home.y, way.y) < -limit;
    const bool is_beyond_check =
        past(from_check.x, way.x) > limit && past(from_check.y, way.y) > limit;
    beyond_s_ = is_beyond_home || is_beyond_check ? beyond_s_ + dt_s : 0.0;
    has_drifted_ = has_drifted_ || beyond_s_ >= beyond_s;
    return has_drifted_;
}

}  // namespace touchline
