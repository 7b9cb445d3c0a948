// A knob as a joystick has it: an axis whose whole range is one turn. Threads: a plain value.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace touchline {

class Knob {
  public:
    /// How far it turned since the last time it moved, counter-clockwise; the axis is -1 ... 1,
    /// clockwise. An endless one comes out at the other end; 0 for what is not there, where it
    /// comes back, and for less than noise.
    [[nodiscard]] double step(std::optional<double> axis) {
        constexpr double noise = 0.004;  // a count of 8 bits is 0.008
        const double now = axis.value_or(nowhere);
        const double turned = std::remainder(now - last_, 2.0);
        if (std::abs(turned) < noise) return 0.0;
        last_ = now;
        return std::isfinite(turned) ? -std::numbers::pi * turned : 0.0;
    }

  private:
    static constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

    double last_ = nowhere;
};

}  // namespace touchline
