// The level of resolution follows the hand's speed: coarse while the hand is fast, fine while it is
// slow. A detail of wavelength lambda crossed at speed v is a force of frequency v / lambda; what
// is faster than the servo, the device and the hand can follow is left out (paper, sections 1 and
// 5). Threads: one, the servo's. No allocation.
#pragma once

#include "config/types/vec2.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace touchline {

struct LevelLimits {
    double spacing_m = 1e-4;       // h0: point spacing of level 0, > 0
    double encoder_step_m = 1e-4;  // smallest motion of the tip that the device can tell, >= 0
    double f_device_Hz = 100.0;    // bandwidth of the device
    double finest = 0.0;           // the operator's bounds
    double coarsest = 16.0;
};

/// Shortest wavelength that level l carries: four points, lambda_l = 4 h0 2^l.
[[nodiscard]] double wavelength_m(const LevelLimits& limits, double level);

/// Highest detail frequency worth rendering: min(f_s / 10, f_device, 100 Hz), f_s = 1 / dt.
[[nodiscard]] double highest_detail_Hz(const LevelLimits& limits, double dt_s);

/// log2(v / (f_max lambda_0)): the level at which v crosses details at exactly f_max; negative for
/// a slow hand.
[[nodiscard]] double speed_level(const LevelLimits& limits, double speed_m_per_s, double dt_s);

/// l_encoder: the finest level whose spacing the encoders can tell, lambda_l >= 4 Delta.
[[nodiscard]] double encoder_level(const LevelLimits& limits);

/// The hand's speed as the rule sees it: largest |10 Hz low-pass of v| of the last half second, so
/// that a tremor does not switch levels. Starts at rest.
class SpeedMeasure {
  public:
    /// The handle after dt_s > 0. Returns the square of the held speed in m^2/s^2: a root at every
    /// tick costs as much as all the rest.
    double step(Position handle, double dt_s);

  private:
    static constexpr std::size_t slots = 10;
    static constexpr double slot_s = 0.05;

    void set_period(double dt_s);
    void begin_slots();

    double dt_s_ = 0.0;
    double per_dt_Hz_ = 0.0;
    double share_ = 0.0;  // of a new velocity in the low-pass
    Position last_;
    bool has_last_ = false;
    Velocity low_pass_;
    std::array<double, slots + 1> peaks_{};  // squared, of the running slot and the ten before it
    std::size_t newest_ = 0;
    double older_ = 0.0;  // largest of the ten
    double slot_age_s_ = 0.0;
};

/// Whole level = min(coarsest, max(ceil(l_speed), l_encoder, finest)). Coarsens at once; refines a
/// quarter of an octave later than it coarsened, and not within 150 ms of the last change.
class LevelRule {
  public:
    explicit LevelRule(const LevelLimits& limits);

    /// One servo tick; dt_s > 0. Returns the wanted level.
    double step(Position handle, double dt_s);

    /// New limits take effect at the next step.
    void set_limits(const LevelLimits& limits) {
        limits_ = limits;
        dt_s_ = 0.0;
    }

    [[nodiscard]] double level() const { return level_; }

    [[nodiscard]] double speed_m_per_s() const { return std::sqrt(speed2_m2_per_s2_); }

  private:
    [[nodiscard]] double bounded(double speed_level) const;
    void set_thresholds(double dt_s);

    LevelLimits limits_;
    double dt_s_ = 0.0;  // the period that the thresholds are for; 0: none yet
    // Between these speeds, squared, the level stays as it is.
    double refine_below_m2_per_s2_ = 0.0;
    double coarsen_above_m2_per_s2_ = 0.0;
    SpeedMeasure measure_;
    double level_ = 0.0;
    double speed2_m2_per_s2_ = 0.0;
    double since_change_s_ = 1.0;
};

}  // namespace touchline
