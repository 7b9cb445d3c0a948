// A knob on a joystick: an axis whose whole range is one turn. Threads: a plain value.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace touchline {

class Knob {
  public:
    /// Returns how far it turned since it last moved, counter-clockwise; the axis is -1 ... 1,
    /// clockwise. An endless knob wraps around. Returns 0 for a missing axis, for the first value
    /// after it comes back, and for noise.
    [[nodiscard]] double step(std::optional<double> axis) {
        constexpr double noise = 0.004;  // one count of 8 bits is 0.008
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
