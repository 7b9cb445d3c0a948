#include "haptics/resolution/level_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

constexpr double points_per_wavelength = 4.0;    // two samples per half wave
constexpr double samples_per_wavelength = 10.0;  // servo samples, at least
constexpr double f_hand_Hz = 100.0;              // above, a detail is vibration, not shape
constexpr double f_low_pass_Hz = 10.0;           // voluntary motion is slower
constexpr double hysteresis_octaves = 0.25;
constexpr double dwell_s = 0.15;
constexpr double least_speed_m_per_s = 1e-9;  // keeps the logarithm finite

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
    if (!(limits.encoder_step_m > limits.spacing_m)) return 0.0;
    return std::ceil(std::log2(limits.encoder_step_m / limits.spacing_m) - 1e-9);
}

void SpeedMeasure::set_period(double dt_s) {
    dt_s_ = dt_s;
    per_dt_Hz_ = 1.0 / dt_s;
    share_ = 1.0 - std::exp(-2.0 * std::numbers::pi * f_low_pass_Hz * dt_s);
}

/// A long tick may outlast several slots; each is emptied as it begins.
void SpeedMeasure::begin_slots() {
    for (std::size_t i = 0; slot_age_s_ >= slot_s && i <= slots; ++i) {
        slot_age_s_ -= slot_s;
        newest_ = (newest_ + 1) % peaks_.size();
        peaks_[newest_] = 0.0;
    }
    slot_age_s_ = std::min(slot_age_s_, slot_s);
    older_ = *std::max_element(peaks_.begin(), peaks_.end());
}

double SpeedMeasure::step(Position handle, double dt_s) {
    if (dt_s != dt_s_) set_period(dt_s);
    const Position moved = has_last_ ? handle - last_ : Position{};
    last_ = handle;
    has_last_ = true;
    low_pass_ += share_ * (along<Velocity>(moved, per_dt_Hz_) - low_pass_);
    slot_age_s_ += dt_s;
    if (slot_age_s_ >= slot_s) begin_slots();
    peaks_[newest_] = std::max(peaks_[newest_], dot(low_pass_, low_pass_));
    return std::max(older_, peaks_[newest_]);
}

LevelRule::LevelRule(const LevelLimits& limits) : limits_(limits), level_(bounded(0.0)) {}

double LevelRule::bounded(double speed_level) const {
    return std::min(limits_.coarsest, std::max({std::ceil(speed_level), encoder_level(limits_),
                                                limits_.finest, 0.0}));
}

/// ceil(z) stays the same between two speeds. They are taken a rounding error inwards: beyond them
/// the level is worked out.
void LevelRule::set_thresholds(double dt_s) {
    constexpr double inwards = 1e-12;
    dt_s_ = dt_s;
    const double crossed_m_per_s = highest_detail_Hz(limits_, dt_s) * wavelength_m(limits_, level_);
    const double refined_m_per_s = crossed_m_per_s * std::exp2(-1.0 - hysteresis_octaves);
    coarsen_above_m2_per_s2_ = crossed_m_per_s * crossed_m_per_s * (1.0 - inwards);
    refine_below_m2_per_s2_ = refined_m_per_s * refined_m_per_s * (1.0 + inwards);
    constexpr double at_rest = -1e3;
    if (level_ == limits_.coarsest) coarsen_above_m2_per_s2_ = INFINITY;
    if (level_ > limits_.coarsest) coarsen_above_m2_per_s2_ = -1.0;  // new limits: find the level
    if (level_ == bounded(at_rest)) refine_below_m2_per_s2_ = -1.0;
}

double LevelRule::step(Position handle, double dt_s) {
    if (!is_finite(handle) || !(dt_s > 0.0)) return level_;
    speed2_m2_per_s2_ = measure_.step(handle, dt_s);
    since_change_s_ += dt_s;
    const bool is_known = dt_s == dt_s_;
    const bool stays = speed2_m2_per_s2_ <= coarsen_above_m2_per_s2_ &&
                       (speed2_m2_per_s2_ > refine_below_m2_per_s2_ || since_change_s_ < dwell_s);
    if (is_known && stays) return level_;
    const double z = speed_level(limits_, speed_m_per_s(), dt_s);
    const double coarser = bounded(z);
    const double finer = bounded(z + hysteresis_octaves);
    const bool may_refine = finer < level_ && since_change_s_ >= dwell_s;
    if (coarser > level_ || may_refine) {
        level_ = coarser > level_ ? coarser : finer;
        since_change_s_ = 0.0;
    }
    set_thresholds(dt_s);
    return level_;
}

}  // namespace touchline
