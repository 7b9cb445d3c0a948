// The level for a shape in the hand, by the speed of its fastest point.
// Threads: one, the servo's. No allocation, no clock.
#pragma once

#include "haptics/resolution/level_rule.h"

namespace touchline {

/// The speed of a shape's fastest point as the rule sees it: at most |v| + |w| r, both after a 10
/// Hz low-pass, and the largest of the last half second.
class ShapeSpeed {
  public:
    /// `r_max_m` >= 0 is the largest distance of the shape's points from the point that the hand
    /// holds.
    explicit ShapeSpeed(double r_max_m) : r_max_m_(r_max_m) {}

    /// Takes the handle's position and angle after dt_s > 0. Returns the square of the held speed
    /// in m^2/s^2.
    double step(Position handle, double angle_rad, double dt_s);

  private:
    double r_max_m_;
    Position last_;
    double last_angle_rad_ = 0.0;
    bool has_last_ = false;
    Velocity low_pass_;
    double low_pass_rad_per_s_ = 0.0;
    PeakHold peak_{0.05};  // seconds a slot; squared speeds
};

/// LevelRule at that speed.
class ShapeLevelRule {
  public:
    ShapeLevelRule(const LevelLimits& limits, double r_max_m) : rule_(limits), speed_(r_max_m) {}

    /// Advances one servo tick; dt_s > 0. Returns the wanted level. A pose that is not finite
    /// changes nothing.
    double step(Position handle, double angle_rad, double dt_s) {
        if (!is_finite(handle) || !std::isfinite(angle_rad) || !(dt_s > 0.0)) return rule_.level();
        return rule_.step_at(speed_.step(handle, angle_rad, dt_s), dt_s);
    }

    void set_limits(const LevelLimits& limits) { rule_.set_limits(limits); }

    [[nodiscard]] double speed_m_per_s() const { return rule_.speed_m_per_s(); }

  private:
    LevelRule rule_;
    ShapeSpeed speed_;
};

}  // namespace touchline
