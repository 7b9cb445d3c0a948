// How a leading point goes a way from rest to rest: speeds up and slows down as smoothly as a hand
// does, with an even speed between. Threads: a plain value.
#pragma once

#include <algorithm>

namespace touchline {

/// Each ramp is the one of least jerk between rest and an even speed, v (3 u^2 - 2 u^3). A way too
/// short for the speed is gone at a lower one.
class SpeedProfile {
  public:
    SpeedProfile() = default;

    /// length_m >= 0, speed_m_per_s > 0.
    SpeedProfile(double length_m, double speed_m_per_s)
        : length_m_(length_m), speed_m_per_s_(std::min(speed_m_per_s, length_m / ramp_s)) {}

    [[nodiscard]] double duration_s() const {
        return speed_m_per_s_ > 0.0 ? length_m_ / speed_m_per_s_ + ramp_s : 0.0;
    }

    /// Gone after t_s; any t_s.
    [[nodiscard]] double gone_m(double t_s) const {
        const double left_s = duration_s() - t_s;
        if (!(left_s > 0.0)) return length_m_;
        if (left_s < ramp_s) return length_m_ - ramp_m(left_s);
        if (t_s < ramp_s) return ramp_m(std::max(0.0, t_s));
        return speed_m_per_s_ * (t_s - 0.5 * ramp_s);
    }

  private:
    static constexpr double ramp_s = 0.3;

    [[nodiscard]] double ramp_m(double t_s) const {
        const double u = t_s / ramp_s;
        return speed_m_per_s_ * ramp_s * u * u * u * (1.0 - 0.5 * u);
    }

    double length_m_ = 0.0;
    double speed_m_per_s_ = 0.0;
};

}  // namespace touchline
