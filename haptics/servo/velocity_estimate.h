// Estimates the handle's velocity from positions that jump by encoder steps, by first-order
// adaptive windowing (Janabi-Sharifi, Hayward, Chen 2000), each axis on its own. Threads: one, the
// servo's. A plain value.
#pragma once

#include "config/types/vec2.h"

#include <array>
#include <cstddef>

namespace touchline {

class VelocityEstimate {
  public:
    /// `noise_m` > 0: how far a sample may lie from the truth, which is one encoder step.
    explicit VelocityEstimate(double noise_m) : noise_m_(noise_m) {}

    /// Returns the slope from the newest sample back over the longest window, at most 16 periods,
    /// whose line passes all samples between within the noise. Returns 0 for the first sample and
    /// for one that is not finite, which also clears all others. `dt_s` > 0 is the time since the
    /// last sample.
    Velocity step(Position position, double dt_s);

    void reset() { count_ = 0; }

    [[nodiscard]] Velocity velocity() const { return velocity_; }

    /// Whether a copy made from bytes may be stepped.
    [[nodiscard]] bool is_sound() const {
        return newest_ < samples_.size() && count_ <= samples_.size();
    }

  private:
    static constexpr std::size_t window = 16;

    struct Sample {
        Position position;
        double dt_s = 0.0;  // since the sample before
    };

    [[nodiscard]] const Sample& back(std::size_t i) const {
        return samples_[(newest_ + samples_.size() - i) % samples_.size()];
    }

    double noise_m_;
    std::array<Sample, window + 1> samples_{};
    std::size_t newest_ = 0;
    std::size_t count_ = 0;
    Velocity velocity_;
};

}  // namespace touchline
