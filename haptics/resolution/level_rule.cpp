#include "haptics/resolution/level_rule.h"

#include <limits>
#include <numbers>

namespace touchline {
namespace {

constexpr double points_per_wavelength = 4.0;    // two samples per half wave
constexpr double samples_per_wavelength = 10.0;  // servo samples, at least
constexpr double spacings_per_radius = 8.0;      // of the proxy, at most
constexpr double f_hand_Hz = 100.0;              // above, a detail is vibration, not shape
constexpr double f_low_pass_Hz = 10.0;           // voluntary motion is slower
constexpr double hysteresis_octaves = 0.25;
constexpr double dwell_s = 0.15;
constexpr double least_speed_m_per_s = 1e-9;  // keeps the logarithm finite

/// Returns the finest level with this spacing or a wider one.
double level_of_spacing(const LevelLimits& limits, double least_m) {
    if (!(least_m > limits.spacing_m)) return 0.0;
    return std::ceil(std::log2(least_m / limits.spacing_m) - 1e-9);
}

double whole_level(double level) {
    return std::max(0.0, std::ceil(level));
}

// The time that each opened box adds to a step: 51 ns from 4 to 16 boxes, 38 ns from 16 to 64
// (tests/lab/bench/results/deadline.csv, fractal, median).
constexpr double s_per_box = 50e-9;
constexpr double share_of_period = 0.3;
constexpr double window_ticks = 64.0;
constexpr double shortest_wait_s = 0.5;
constexpr double longest_wait_s = 8.0;
constexpr int lasting_ticks = 4;  // cut in a row: the proxy does not keep up

}  // namespace

double wavelength_m(const LevelLimits& limits, double level) {
    return points_per_wavelength * limits.spacing_m * std::exp2(level);
}

double highest_detail_Hz(const LevelLimits& limits, double dt_s) {
    return std::min({1.0 / (samples_per_wavelength * dt_s), limits.f_device_Hz, f_hand_Hz});
}

double speed_level(const LevelLimits& limits, double speed_m_per_s, double dt_s) {
    const double crossed_m = highest_detail_Hz(limits, dt_s) * wavelength_m(limits, 0.0);
    return std::log2(std::max(speed_m_per_s, least_speed_m_per_s) / crossed_m);
}

double encoder_level(const LevelLimits& limits) {
    return level_of_spacing(limits, limits.encoder_step_m);
}

double radius_level(const LevelLimits& limits) {
    return level_of_spacing(limits, limits.radius_m / spacings_per_radius);
}

double low_pass_share(double dt_s) {
    return 1.0 - std::exp(-2.0 * std::numbers::pi * f_low_pass_Hz * dt_s);
}

void SpeedMeasure::set_period(double dt_s) {
    dt_s_ = dt_s;
    per_dt_Hz_ = 1.0 / dt_s;
    share_ = low_pass_share(dt_s);
}

double SpeedMeasure::step(Position handle, double dt_s) {
    if (dt_s != dt_s_) set_period(dt_s);
    const Position moved = has_last_ ? handle - last_ : Position{};
    last_ = handle;
    has_last_ = true;
    low_pass_ += share_ * (along<Velocity>(moved, per_dt_Hz_) - low_pass_);
    return peak_.step(dot(low_pass_, low_pass_), dt_s);
}

LevelRule::LevelRule(const LevelLimits& limits) : limits_(limits) {
    adopt_limits();
}

void LevelRule::set_limits(const LevelLimits& limits) {
    if (limits == limits_) return;
    const bool is_other_scale =
        limits.spacing_m != limits_.spacing_m || limits.f_device_Hz != limits_.f_device_Hz;
    limits_ = limits;
    if (is_other_scale && dt_s_ > 0.0) {  // the same speed is another level
        terms_.speed = whole_level(speed_level(limits_, speed_m_per_s(), dt_s_));
        set_thresholds(dt_s_);
    }
    adopt_limits();
}

void LevelRule::adopt_limits() {
    terms_.percept = limits_.percept;
    terms_.finest = limits_.finest;
    terms_.coarsest = limits_.coarsest;
    terms_.encoder = encoder_level(limits_);
    terms_.radius = radius_level(limits_);
    terms_.cost = limits_.cost;
    terms_.safe = limits_.safe;
    level_ = choose_level(terms_).level;
}

/// ceil(z) stays the same between two speeds. They are moved inwards by a rounding error; beyond
/// them the term is computed.
void LevelRule::set_thresholds(double dt_s) {
    constexpr double inwards = 1e-12;
    dt_s_ = dt_s;
    const double crossed_m_per_s =
        highest_detail_Hz(limits_, dt_s) * wavelength_m(limits_, terms_.speed);
    const double refined_m_per_s = crossed_m_per_s * std::exp2(-1.0 - hysteresis_octaves);
    coarsen_above_m2_per_s2_ = crossed_m_per_s * crossed_m_per_s * (1.0 - inwards);
    refine_below_m2_per_s2_ = refined_m_per_s * refined_m_per_s * (1.0 + inwards);
    if (terms_.speed == 0.0) refine_below_m2_per_s2_ = -1.0;  // nothing is finer
}

double LevelRule::step(Position handle, double dt_s) {
    if (!is_finite(handle) || !(dt_s > 0.0)) return level_;
    return step_at(measure_.step(handle, dt_s), dt_s);
}

double LevelRule::step_at(double speed2_m2_per_s2, double dt_s) {
    speed2_m2_per_s2_ = speed2_m2_per_s2;
    since_change_s_ += dt_s;
    const bool is_known = dt_s == dt_s_;
    const bool stays = speed2_m2_per_s2_ <= coarsen_above_m2_per_s2_ &&
                       (speed2_m2_per_s2_ > refine_below_m2_per_s2_ || since_change_s_ < dwell_s);
    if (!is_known || !stays) update_speed_term(dt_s);
    return level_;
}

void LevelRule::update_speed_term(double dt_s) {
    const double z = speed_level(limits_, speed_m_per_s(), dt_s);
    const double coarser = whole_level(z);
    const double finer = whole_level(z + hysteresis_octaves);
    const bool may_refine = finer < terms_.speed && since_change_s_ >= dwell_s;
    if (coarser > terms_.speed || may_refine) {
        terms_.speed = coarser > terms_.speed ? coarser : finer;
        since_change_s_ = 0.0;
        level_ = choose_level(terms_).level;
    }
    set_thresholds(dt_s);
}

double ShapeSpeed::step(Position handle, double angle_rad, double dt_s) {
    const double share = low_pass_share(dt_s);
    const Position moved = has_last_ ? handle - last_ : Position{};
    const double turned_rad = has_last_ ? angle_rad - last_angle_rad_ : 0.0;
    last_ = handle;
    last_angle_rad_ = angle_rad;
    has_last_ = true;
    low_pass_ += share * (along<Velocity>(moved, 1.0 / dt_s) - low_pass_);
    low_pass_rad_per_s_ += share * (turned_rad / dt_s - low_pass_rad_per_s_);
    const double fastest = norm(low_pass_) + std::abs(low_pass_rad_per_s_) * r_max_m_;
    return peak_.step(fastest * fastest, dt_s);
}

Work work_of(const ContactReport& report) {
    return {report.boxes, !(report.clear >= 1.0) || !(report.carried_m <= 0.0)};
}

int affordable_boxes(double period_s) {
    constexpr double most = std::numeric_limits<int>::max();
    return static_cast<int>(std::min(share_of_period * period_s / s_per_box, most));
}

CostTerm::CostTerm(double period_s)
    : period_s_(period_s),
      affordable_(affordable_boxes(period_s)),
      recent_(window_ticks / static_cast<double>(PeakHold::slots)),
      wait_s_(shortest_wait_s) {}

double CostTerm::step(const Work& work, double rendered_level) {
    since_change_s_ += period_s_;
    const double boxes = work.boxes;
    const double worth = work.is_cut ? std::max(boxes, affordable_ + 1.0) : boxes;
    const double most = recent_.step(worth, 1.0);
    cut_in_a_row_ = work.is_cut ? cut_in_a_row_ + 1 : 0;
    if (boxes > affordable_ || cut_in_a_row_ >= lasting_ticks) {
        coarsen(rendered_level);
    } else if (level_ > 0.0 && can_refine(most, rendered_level)) {
        refine();
    }
    return level_;
}

void CostTerm::coarsen(double rendered_level) {
    const double wanted = std::floor(rendered_level) + 1.0;
    if (!(wanted > level_)) return;  // already on the way there
    if (is_refined_) {
        const bool has_lasted = since_change_s_ >= wait_s_;
        wait_s_ = has_lasted ? shortest_wait_s : std::min(2.0 * wait_s_, longest_wait_s);
    }
    level_ = wanted;
    since_change_s_ = 0.0;
    is_refined_ = false;
    cut_in_a_row_ = 0;
}

bool CostTerm::can_refine(double most_boxes, double rendered_level) const {
    if (since_change_s_ < wait_s_) return false;
    const double levels = std::max(rendered_level - (level_ - 1.0), 0.0);
    return most_boxes * std::exp2(levels) <= affordable_;
}

void CostTerm::refine() {
    if (is_refined_) wait_s_ = shortest_wait_s;  // the one before has lasted
    level_ -= 1.0;
    since_change_s_ = 0.0;
    is_refined_ = true;
}

}  // namespace touchline
