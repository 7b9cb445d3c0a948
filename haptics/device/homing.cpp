#include "haptics/device/homing.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace touchline {
namespace {

// The counts of units of one kind differ by less than this. With more, units stopped at 168 degrees
// could not be told from those stopped at 172, which turn by 5.6 per cent farther.
constexpr double scale_tolerance = 0.025;
constexpr double straight_rad = 0.05;
// Measured at the elbows. Smaller differences cannot be read if the stretched arms lie straight, as
// those of a gen 2 do.
constexpr double kinds_apart_m = 2e-3;
// Of a joint's angle away from the stops: the count's tolerance over 120 degrees, and a stop that
// stands 3 mm away.
constexpr double doubt_rad = 0.1;

JointAngles bent_of(const DeviceProfile& kind) {
    return kind.home_place == StopPlace::towards ? kind.check.angles : kind.home;
}

bool is_straight(JointAngles bent) {
    return std::abs(bent.x - std::numbers::pi) < straight_rad && std::abs(bent.y) < straight_rad;
}

JointAngles stretched_of(const DeviceProfile& kind) {
    return kind.home_place == StopPlace::towards ? kind.home : kind.check.angles;
}

/// Whether a unit of the kind could be taken for one of the chosen kind and would then have wrong
/// links or wrong stops.
bool is_another(const DeviceProfile& kind, const DeviceProfile& chosen) {
    if (kind.geometry != chosen.geometry) return true;
    const JointAngles off = bent_of(kind) - bent_of(chosen);
    const double off_m = chosen.geometry.proximal_m * std::max(std::abs(off.x), std::abs(off.y));
    return kind.handle.has_value() == chosen.handle.has_value() && off_m > kinds_apart_m;
}

/// Adds a kind's units, on boards driven as the chosen kind's. A decoder that sees each edge is
/// known on boards that are told twice their resolution.
void add_known(const DeviceProfile& kind, const DeviceProfile& chosen, bool are_own,
               std::vector<KnownUnits>& known) {
    const bool is_bent_at_check = chosen.home_place == StopPlace::towards;
    KnownUnits units{turn_of_both_rad(kind.check.angles - kind.home),
                     1.0,
                     are_own,
                     is_straight(bent_of(kind)),
                     kind.geometry == chosen.geometry,
                     kind.geometry,
                     is_bent_at_check ? bent_of(kind) : stretched_of(kind)};
    const double driven = turn_of_both_rad(chosen.counts_per_turn);
    for (const double counts :
         {turn_of_both_rad(kind.counts_per_turn), 2.0 * kind.other_counts_per_turn}) {
        if (!(counts > 0.0)) continue;
        units.scale = driven / counts;
        known.push_back(units);
        units.scale = 0.5 * driven / counts;
        if (kind.wiring.told_per_count > 1.0) known.push_back(units);
    }
}

/// The share by which this turn misses that of a unit.
double off_by(const KnownUnits& units, JointAngles read) {
    return std::abs(units.scale * turn_of_both_rad(read) / units.turn_rad - 1.0);
}

/// The same of the nearest unit for which `counts` is true.
template <class Counts>
double least_off_by(const std::vector<KnownUnits>& known, JointAngles read, Counts counts) {
    double least = std::numeric_limits<double>::infinity();
    for (const KnownUnits& units : known)
        if (counts(units)) least = std::min(least, off_by(units, read));
    return least;
}

/// Returns whether arms of these links could be at the angles, or anywhere near them.
bool can_be_at(const Geometry& links, JointAngles angles) {
    for (const double off_1 : {-doubt_rad, 0.0, doubt_rad})
        for (const double off_2 : {-doubt_rad, 0.0, doubt_rad})
            if (forward(links, angles + JointAngles{off_1, off_2})) return true;
    return false;
}

constexpr double listen_s = 3.0;         // after a step's prompt begins, before a rest counts
constexpr double rest_s = 1.0;           // of stillness
constexpr double patience_s = 30.0;      // without motion: say the step again
constexpr double longest_wait_s = 60.0;  // for a moving hand to rest: say the step again
constexpr double longest_silence_s = 0.5;
constexpr double fit_m = 3e-3;          // at the elbows, between where they read and must be
constexpr double stops_apart_m = 2e-3;  // by which a unit's stop may stand away from its kind's
constexpr double same_place_m = 1e-3;   // between two rests at one stop
constexpr double leave_m = 3e-3;        // from where the prompt began, before a rest counts
constexpr double least_aside = 0.25;    // of the arms' opening, if the hand also came nearer
constexpr double aside_m = 10e-3;       // at the elbows: to the left, or to the right
constexpr int largest_misses = 3;
constexpr int most_reversals = 3;
constexpr double beyond_m = 2e-3;  // past a stop
constexpr double beyond_s = 0.3;

// Encoders do not differ from each other; if the two joints do, a stop stands elsewhere.
double scale_of(JointAngles wanted, JointAngles turn) {
    return turn_of_both_rad(wanted) / turn_of_both_rad(turn);
}

// The two stops alone cannot tell a linkage from its mirror image.
Plugs mirrored(const Plugs& plugs) {
    return {!plugs.are_swapped, !plugs.is_2_reversed, !plugs.is_1_reversed};
}

/// Two counts, and the tremble of a hand that leans on a stop.
JointAngles resting_band(const HomingPlan& plan) {
    const double tremble = 3e-4 / plan.arm_m;
    return {2.0 * plan.quantum.x + tremble, 2.0 * plan.quantum.y + tremble};
}

}  // namespace

double turn_of_both_rad(JointAngles turn) {
    return std::abs(turn.x) + std::abs(turn.y);
}

std::vector<KnownUnits> known_units(const DeviceProfile& chosen,
                                    std::span<const DeviceProfile> kinds) {
    std::vector<KnownUnits> known;
    add_known(chosen, chosen, true, known);
    for (const DeviceProfile& kind : kinds)
        if (is_another(kind, chosen)) add_known(kind, chosen, false, known);
    return known;
}

bool is_of_kind(const std::vector<KnownUnits>& known, JointAngles read) {
    const bool are_straight = are_own_straight(known);
    const double own =
        least_off_by(known, read, [](const KnownUnits& units) { return units.are_own; });
    const double alike = least_off_by(known, read, [&](const KnownUnits& units) {
        return !units.are_own && units.have_own_links && units.are_straight == are_straight;
    });
    return own <= scale_tolerance && own < alike;
}

LinksOf links_of(const std::vector<KnownUnits>& known, JointAngles read, JointAngles turned) {
    bool is_alone = true;
    bool can_be_own = false;
    bool can_be_other = false;
    for (const KnownUnits& units : known) {
        const bool is_asked = units.are_straight != are_own_straight(known);
        if (is_asked || !(off_by(units, read) <= scale_tolerance)) continue;
        const bool can_be = can_be_at(units.links, units.at_check + units.scale * turned);
        is_alone = is_alone && units.have_own_links;
        (units.have_own_links ? can_be_own : can_be_other) |= can_be;
    }
    if (is_alone || (can_be_own && !can_be_other)) return LinksOf::chosen_kind;
    return can_be_own ? LinksOf::either : LinksOf::other_kind;
}

bool needs_an_answer(const std::vector<KnownUnits>& known, JointAngles read) {
    const bool are_straight = are_own_straight(known);
    const double other = least_off_by(
        known, read, [&](const KnownUnits& units) { return units.are_straight != are_straight; });
    return other <= scale_tolerance;
}

bool are_own_straight(const std::vector<KnownUnits>& known) {
    return !known.empty() && known.front().are_straight;
}

HomingPlan homing_plan(const DeviceProfile& profile, JointAngles stop_off) {
    const bool is_home_stretched = profile.home_place == StopPlace::towards;
    HomingPlan plan{profile.home,
                    profile.check.angles,
                    profile.geometry.proximal_m,
                    encoder_quantum(profile),
                    is_home_stretched,
                    known_units(profile)};
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

/// This unit's turn from home to check.
JointAngles Homing::wanted_turn() const {
    const double sign = plan_.is_home_stretched ? 1.0 : -1.0;
    return plan_.check - plan_.home + sign * calibration_.stop_off;
}

void Homing::advance(HomingStep step) {
    misses_ = 0;
    go(step, HomingRemark::none);
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
    if (since_s_ >= longest_wait_s) say_again();
    // A hand that has not moved since the prompt began has not understood it.
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

/// A hand that leans on a stop that does not fit cannot move on.
void Homing::lose_patience() {
    if (view_.remark == HomingRemark::misfit) return miss(view_.misfit_m);
    go(view_.step, HomingRemark::not_moved);
}

/// The place that the hand has reached meanwhile stays good.
void Homing::say_again() {
    view_.remark = HomingRemark::none;
    ++view_.prompts;
    since_s_ = 0.0;
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
        case HomingStep::to_answer:
            return rest_at_answer(read);
        case HomingStep::done:
            return;
    }
}

void Homing::rest_at_home(JointAngles read) {
    read_at_home_ = read;
    go(HomingStep::to_check, HomingRemark::none);
}

Homing::Fit Homing::fit_of(JointAngles turn) const {
    const bool are_swapped = calibration_.encoders.are_swapped;
    const JointAngles at = at_joints({are_swapped, false, false}, turn);
    const JointAngles wanted = wanted_turn();
    const auto apart_m = [&](double scale) {
        return elbow_m({scale * std::abs(at.x) - std::abs(wanted.x),
                        scale * std::abs(at.y) - std::abs(wanted.y)});
    };
    const bool is_known = calibration_.is_measured;
    const double scale = is_known ? calibration_.scale : scale_of(wanted, at);
    return {Plugs{are_swapped, at.x * wanted.x < 0.0, at.y * wanted.y < 0.0}, scale, apart_m(scale),
            apart_m(is_known ? scale : 1.0)};
}

bool Homing::does_fit(const Fit& fit, JointAngles turn) const {
    if (calibration_.is_measured) return fit.apart_m <= fit_m;
    return fit.apart_m <= stops_apart_m && is_of_kind(plan_.known, turn);
}

void Homing::rest_at_check(JointAngles read) {
    const JointAngles turn = read - read_at_home_;
    const Fit fit = fit_of(turn);
    read_at_check_ = read;
    view_.turn_share = 1.0 / scale_of(wanted_turn(), turn);
    if (!does_fit(fit, turn)) return miss(fit.misfit_m);
    view_.misfit_m = fit.misfit_m;
    scale_ = fit.scale;
    if (calibration_.is_measured) return check_known(fit.encoders);
    encoders_ = fit.encoders;
    advance(HomingStep::to_left);
}

/// Swapped plugs read as the two stops do when they are visited in the wrong order. So it must come
/// again and again before the unit is measured anew.
void Homing::check_known(const Plugs& fitting) {
    if (fitting == calibration_.encoders) return finish(HomingRemark::none);
    if (++reversals_ < most_reversals) return go(HomingStep::to_home, HomingRemark::reversed);
    calibration_.is_measured = false;
    calibration_.encoders = {};
    calibration_.stop_off = {};
    go(HomingStep::to_home, HomingRemark::replugged);
}

/// To the left both joints turn down. Returns nothing if the handle is neither to the left nor to
/// the right.
std::optional<bool> Homing::is_left(JointAngles read) const {
    const JointAngles turn = scale_ * at_joints(encoders_, read - read_at_check_);
    const double aside = 0.5 * (turn.x + turn.y);
    const double apart = 0.5 * (turn.x - turn.y);
    const bool is_aside =
        elbow_m({aside, aside}) >= aside_m && std::abs(aside) >= least_aside * std::abs(apart);
    return is_aside ? std::optional(aside < 0.0) : std::nullopt;
}

/// The left is the right in the mirror image. A difference from the profile could also come from
/// stops in the wrong order, so it must come twice.
void Homing::rest_at_left(JointAngles read) {
    const auto is_to_left = is_left(read);
    if (!is_to_left) return go(HomingStep::to_left, HomingRemark::not_left);
    if (!*is_to_left) encoders_ = mirrored(encoders_);
    turned_left_ = at_joints(encoders_, read - read_at_check_);
    const bool is_usual = encoders_ == Plugs{};
    if (is_usual || seen_ == encoders_) return advance(HomingStep::to_home_again);
    seen_ = encoders_;
    go(HomingStep::to_home, HomingRemark::reversed);
}

void Homing::rest_at_home_again(JointAngles read) {
    const double misfit_m = scale_ * elbow_m(read - read_at_home_);
    if (!(misfit_m <= same_place_m)) return miss(misfit_m);
    advance(HomingStep::to_check_again);
}

/// The same place twice is a stop, and not a place where a hand happened to pause.
void Homing::rest_at_check_again(JointAngles read) {
    const double misfit_m = scale_ * elbow_m(read - read_at_check_);
    const JointAngles turn = read - read_at_home_;
    if (!(misfit_m <= same_place_m)) return miss(misfit_m);
    if (!does_fit(fit_of(turn), turn)) return go(HomingStep::to_home, HomingRemark::no_such_scale);
    read_at_check_ = read;
    judge_links(turn);
}

/// Wrong links would make wrong forces everywhere.
void Homing::judge_links(JointAngles turn) {
    switch (links_of(plan_.known, turn, turned_left_)) {
        case LinksOf::other_kind:
            return go(HomingStep::to_home, HomingRemark::other_kind);
        case LinksOf::either:
            return go(HomingStep::to_home, HomingRemark::either_kind);
        case LinksOf::chosen_kind:
            break;
    }
    if (needs_an_answer(plan_.known, turn)) return advance(HomingStep::to_answer);
    measure();
}

/// A hand that rests anywhere else is still feeling its way.
void Homing::rest_at_answer(JointAngles read) {
    const auto is_yes = is_left(read);
    if (!is_yes) return;
    if (*is_yes == are_own_straight(plan_.known)) return measure();
    go(HomingStep::to_home, HomingRemark::other_kind);
}

void Homing::measure() {
    const JointAngles turn = at_joints(encoders_, read_at_check_ - read_at_home_);
    const JointAngles wanted = plan_.check - plan_.home;
    calibration_.scale = scale_of(wanted, turn);
    calibration_.encoders = encoders_;
    calibration_.stop_off =
        (plan_.is_home_stretched ? 1.0 : -1.0) * (calibration_.scale * turn - wanted);
    calibration_.is_measured = true;
    finish(HomingRemark::measured);
}

/// Averages both stops, since each is only as good as the hand that leans on it.
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
    const bool is_scale_unknown = view_.step == HomingStep::to_check && !calibration_.is_measured;
    go(HomingStep::to_home,
       is_scale_unknown ? HomingRemark::no_such_scale : HomingRemark::starting_over);
}

bool DriftWatch::step(JointAngles angles, double dt_s) {
    const double limit = beyond_m / plan_.arm_m;
    const auto is_past = [&](JointAngles stop, JointAngles other) {
        const JointAngles off = angles - stop;
        const JointAngles outward = stop - other;
        return std::copysign(1.0, outward.x) * off.x > limit &&
               std::copysign(1.0, outward.y) * off.y > limit;
    };
    const bool is_beyond = is_past(plan_.home, plan_.check) || is_past(plan_.check, plan_.home);
    beyond_s_ = is_beyond ? beyond_s_ + dt_s : 0.0;
    has_drifted_ = has_drifted_ || beyond_s_ >= beyond_s;
    return has_drifted_;
}

}  // namespace touchline
