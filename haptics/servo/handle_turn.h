// How far the shape in the hand is turned: by a handle that turns, else by keys or a knob.
// Threads: one, the servo's. A plain value.
#pragma once

#include "haptics/servo/velocity_estimate.h"

#include <optional>

namespace touchline {

class HandleTurn {
  public:
    /// `count_rad` > 0: one count of the handle's encoder; any value if it has none.
    explicit HandleTurn(double count_rad) : speed_(count_rad) {}

    /// Advances one tick of dt_s > 0. Takes `device_rad` if the handle turns. Otherwise the angle
    /// follows `wanted_rad` at 2 rad/s, but runs no further ahead of the shape, at `shape_rad`,
    /// than a hand that feels it stuck would turn. Values that are not finite change nothing.
    void step(std::optional<double> device_rad, double wanted_rad, double shape_rad, double dt_s);

    [[nodiscard]] double angle_rad() const { return angle_rad_; }

    /// The turn in the last tick.
    [[nodiscard]] double turned_rad() const { return turned_rad_; }

    [[nodiscard]] double rad_per_s() const { return speed_.velocity().x; }

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const { return speed_.is_sound(); }

  private:
    double angle_rad_ = 0.0;
    double turned_rad_ = 0.0;
    VelocityEstimate speed_;  // the angle's speed, as metres at 1 m
};

}  // namespace touchline
