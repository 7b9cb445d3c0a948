#include "haptics/device/homing.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double listen_s = 3.0;     // of a step's words, before a rest counts
constexpr double rest_s = 1.0;       // of stillness
constexpr double patience_s = 30.0;  // without a motion: say the step again
constexpr double longest_silence_s = 0.5;
constexpr double fit_m = 3e-3;  // of the elbows, between where they read and must be
constexpr double stops_apart_m =
    2e-3;                              // by which a unit's stop may stand elsewhere than its kind's
constexpr double same_place_m = 1e-3;  // two rests at one stop
constexpr double leave_m = 3e-3;       // from where the words began, before a rest counts
constexpr double least_aside = 0.25;   // of the arms' opening, where the hand also came nearer
constexpr double aside_m = 10e-3;      // of the elbows: to the left, or to the right
constexpr int largest_misses = 3;
constexpr int most_reversals = 3;
constexpr double beyond_m = 2e-3;  // past a stop
constexpr double beyond_s = 0.3;

// Counts that units are known to make, of those that their kind does: as many, 4096 for 4880, and
// twice that by a decoder that sees each edge. Each to 6.5 per cent, as users' programs correct it.
constexpr double known_scales[]{1.0, 4880.0 / 4096.0, 0.5, 0.5 * 4880.0 / 4096.0};
constexpr double scale_tolerance = 0.065;

bool is_known_scale(double scale) {
    return std::ranges::any_of(known_scales, [scale](double known) {
        return std::abs(scale / known - 1.0) <= scale_tolerance;
    });
}

// Encoders do not differ from each other; where the two joints do, a stop stands elsewhere.
double scale_of(JointAngles wanted, JointAngles turn) {
    return (std::abs(wanted.x) + std::abs(wanted.y)) / (std::abs(turn.x) + std::abs(turn.y));
}

// The two stops alone cannot tell a linkage from its mirror image.
Plugs mirrored(const Plugs& plugs) {
    return {!plugs.are_swapped, !plugs.is_2_reversed, !plugs.is_1_reversed};
}

/// Two counts and what a hand that leans on a stop still trembles.
JointAngles resting_band(const HomingPlan& plan) {
    const double tremble = 3e-4 / plan.arm_m;
    return {2.0 * plan.quantum.x + tremble, 2.0 * plan.quantum.y + tremble};
}

}  // namespace

HomingPlan homing_plan(const DeviceProfile& profile, JointAngles stop_off) {
    const bool is_home_stretched = profile.home_place == StopPlace::towards;
    HomingPlan plan{profile.home, profile.check.angles, profile.geometry.proximal_m,
                    encoder_quantum(profile), is_home_stretched};
    (is_home_stretched ? plan.check : plan.home) += stop_off;
    return plan;
}

Homing::Homing(const HomingPlan& plan, const Calibration& stored)
    : plan_(plan), calibration_(stored), stillness_(resting_band(plan)) {
    if (!stored.is_measured) calibration_.stop_off = {};
    if (!stored.is_measured) calibration_.encoders = {};
}

Calibration Homing::bare() const {
    Calibration bare = calibration_;
    bare.offset = {};
    bare.scale = 1.0;
    bare.encoders = {};
    return bare;
}

double Homing::elbow_m(JointAngles turn) const {
    return plan_.arm_m * std::max(std::abs(turn.x), std::abs(turn.y));
}

/// From home to check, of this unit.
JointAngles Homing::wanted_turn() const {
    const double sign = plan_.is_home_stretched ? 1.0 : -1.0;
    return plan_.check - plan_.home + sign * calibration_.stop_off;
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
    if (since_s_ >= patience_s && !has_left_) lose_patience();
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

/// Who leans on a stop that does not fit cannot move on.
void Homing::lose_patience() {
    if (view_.remark == HomingRemark::misfit) return miss(view_.misfit_m);
    go(view_.step, HomingRemark::not_moved);
}

void Homing::rest(JointAngles read) {
    switch (view_.step) {
        case HomingStep::to_home:
            return rest_at_home(read);
        case HomingStep::to_check:
            return rest_at_check(read);
        case HomingStep::to_left:
            return rest_at_left(read);
        case HomingStep::to_home_again:
            return rest_at_home_again(read);
        case HomingStep::to_check_again:
            return rest_at_check_again(read);
        case HomingStep::done:
            return;
    }
}

void Homing::rest_at_home(JointAngles read) {
    read_at_home_ = read;
    go(HomingStep::to_check, HomingRemark::none);
}

double Homing::misfit_m(JointAngles turn) const {
    const double scale = calibration_.is_measured ? calibration_.scale : 1.0;
    const JointAngles size{scale * std::abs(turn.x), scale * std::abs(turn.y)};
    const JointAngles wanted = wanted_turn();
    return elbow_m({size.x - std::abs(wanted.x), size.y - std::abs(wanted.y)});
}

/// Encoders with which the turn is that from stop to stop, on the ports where they were found, else
/// on their own; nothing where no scale makes it that.
std::optional<Plugs> Homing::plugs_that_fit(JointAngles turn) const {
    const bool are_swapped = calibration_.encoders.are_swapped;
    const JointAngles at = at_joints({are_swapped, false, false}, turn);
    const JointAngles wanted = wanted_turn();
    const bool is_known = calibration_.is_measured;
    const double scale = is_known ? calibration_.scale : scale_of(wanted, at);
    const JointAngles apart{scale * std::abs(at.x) - std::abs(wanted.x),
                            scale * std::abs(at.y) - std::abs(wanted.y)};
    if (!is_known && !is_known_scale(scale)) return std::nullopt;
    if (!(elbow_m(apart) <= (is_known ? fit_m : stops_apart_m))) return std::nullopt;
    return Plugs{are_swapped, at.x * wanted.x < 0.0, at.y * wanted.y < 0.0};
}

void Homing::rest_at_check(JointAngles read) {
    const JointAngles turn = read - read_at_home_;
    read_at_check_ = read;
    view_.misfit_m = misfit_m(turn);
    view_.turn_share = 1.0 / scale_of(wanted_turn(), turn);
    const auto fitting = plugs_that_fit(turn);
    if (!fitting) return miss(view_.misfit_m);
    if (calibration_.is_measured) return check_known(*fitting);
    encoders_ = *fitting;
    go(HomingStep::to_left, HomingRemark::none);
}

/// Plugs that were changed read as the two stops do when they are visited in the wrong order. So it
/// must come again and again before the unit is measured anew.
void Homing::check_known(const Plugs& fitting) {
    const Plugs& known = calibration_.encoders;
    if (fitting == (known.are_swapped ? mirrored(known) : known)) return finish(HomingRemark::none);
    if (++reversals_ < most_reversals) return go(HomingStep::to_home, HomingRemark::reversed);
    calibration_.is_measured = false;
    calibration_.encoders = {};
    calibration_.stop_off = {};
    go(HomingStep::to_home, HomingRemark::replugged);
}

/// To the left both joints turn down, and up in the mirror image. What is otherwise than the
/// profile has it could be the stops in the wrong order: it must come twice.
void Homing::rest_at_left(JointAngles read) {
    const JointAngles turn = at_joints(encoders_, read - read_at_check_);
    const double aside = 0.5 * (turn.x + turn.y);
    const double apart = 0.5 * (turn.x - turn.y);
    if (!(elbow_m({aside, aside}) >= aside_m && std::abs(aside) >= least_aside * std::abs(apart)))
        return go(HomingStep::to_left, HomingRemark::not_left);
    if (aside > 0.0) encoders_ = mirrored(encoders_);
    const bool is_usual = encoders_ == Plugs{};
    if (is_usual || seen_ == encoders_) return go(HomingStep::to_home_again, HomingRemark::none);
    seen_ = encoders_;
    go(HomingStep::to_home, HomingRemark::reversed);
}

void Homing::rest_at_home_again(JointAngles read) {
    const double misfit_m = elbow_m(read - read_at_home_);
    if (!(misfit_m <= same_place_m)) return miss(misfit_m);
    go(HomingStep::to_check_again, HomingRemark::none);
}

/// The same place twice: a stop, and not where a hand happened to pause.
void Homing::rest_at_check_again(JointAngles read) {
    const double misfit_m = elbow_m(read - read_at_check_);
    if (!(misfit_m <= same_place_m)) return miss(misfit_m);
    read_at_check_ = read;
    const JointAngles turn = at_joints(encoders_, read - read_at_home_);
    const JointAngles wanted = plan_.check - plan_.home;
    calibration_.scale = scale_of(wanted, turn);
    calibration_.encoders = encoders_;
    calibration_.stop_off =
        (plan_.is_home_stretched ? 1.0 : -1.0) * (calibration_.scale * turn - wanted);
    calibration_.is_measured = true;
    finish(HomingRemark::measured);
}

/// By both stops, for each is only as good as the hand that leans on it.
void Homing::finish(HomingRemark remark) {
    const JointAngles unit_home =
        plan_.home + (plan_.is_home_stretched ? JointAngles{} : calibration_.stop_off);
    const auto offset_by = [this](JointAngles stop, JointAngles read) {
        const JointAngles turn = at_joints(calibration_.encoders, read - plan_.home);
        return stop - plan_.home - calibration_.scale * turn;
    };
    calibration_.offset = 0.5 * (offset_by(unit_home, read_at_home_) +
                                 offset_by(unit_home + wanted_turn(), read_at_check_));
    go(HomingStep::done, remark);
}

void Homing::miss(double misfit_m) {
    view_.misfit_m = misfit_m;
    ++misses_;
    if (misses_ < largest_misses) return go(view_.step, HomingRemark::misfit);
    misses_ = 0;
    go(HomingStep::to_home, HomingRemark::starting_over);
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
