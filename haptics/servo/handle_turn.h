// How far what is held is turned: by a handle that turns, else by keys or a knob.
// Threads: one, the servo's. A plain value.
#pragma once

#include "haptics/servo/velocity_estimate.h"

#include <optional>

namespace touchline {

class HandleTurn {
  public:
    /// `count_rad` > 0: a count of the handle's encoder; any where it has none.
    explicit HandleTurn(double count_rad) : speed_(count_rad) {}

    /// One tick of dt_s > 0. `device_rad` where the handle turns. Else the angle follows
    /// `wanted_rad` at 2 rad/s, and goes no further ahead of the shape, at `shape_rad`, than a hand
    /// that feels how it is stuck would. What is not finite changes nothing.
    void step(std::optional<double> device_rad, double wanted_rad, double shape_rad, double dt_s);

    [[nodiscard]] double angle_rad() const { return angle_rad_; }

    /// In the last tick.
    [[nodiscard]] double turned_rad() const { return turned_rad_; }

    [[nodiscard]] double rad_per_s() const { return speed_.velocity().x; }

    /// Whether a copy from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return speed_.is_sound(); }

  private:
    double angle_rad_ = 0.0;
    double turned_rad_ = 0.0;
    VelocityEstimate speed_;  // of the angle, as a way in metres at 1 m
};

}  // namespace touchline
