// Gains of samples: from levels in dB, and moving without a click. Threads: pure functions and
// plain values.
#pragma once

#include "audio-cues/synth/frames.h"

#include <cmath>

namespace touchline {

/// Returns the factor on samples; 0 dB is 1. NaN gives 0: silence.
[[nodiscard]] inline double gain_of_dB(double level_dB) {
    return std::isnan(level_dB) ? 0.0 : std::pow(10.0, level_dB / 20.0);
}

/// Long enough to avoid a click, short enough to avoid a lag.
inline constexpr double ramp_s = 0.005;

/// Moves from one value to another along 3t^2 - 2t^3, so that the slope is continuous at both ends.
class Ramp {
  public:
    explicit Ramp(double value = 0.0, double length_s = ramp_s)
        : from_(static_cast<float>(value)),
          to_(from_),
          step_(static_cast<float>(1.0 / (length_s * frame_rate_Hz))) {}

    /// Starts from the present value. A target that is not finite counts as 0.
    void go_to(double target) {
        const float wanted = std::isfinite(target) ? static_cast<float>(target) : 0.0F;
        if (wanted == to_) return;
        from_ = value();
        to_ = wanted;
        progress_ = 0.0F;
    }

    [[nodiscard]] float value() const {
        if (is_still()) return to_;
        const float t = progress_;
        return from_ + (to_ - from_) * t * t * (3.0F - 2.0F * t);
    }

    /// Returns the next frame's value.
    float next() {
        if (!is_still()) progress_ += step_;
        return value();
    }

    [[nodiscard]] bool is_still() const { return progress_ >= 1.0F; }

    [[nodiscard]] bool is_silent() const { return is_still() && to_ == 0.0F; }

  private:
    float from_;
    float to_;
    float step_;
    float progress_ = 1.0F;
};

}  // namespace touchline
