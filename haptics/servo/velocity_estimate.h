// Velocity of the handle from positions that jump by encoder steps: first-order adaptive windowing
// (Janabi-Sharifi, Hayward, Chen 2000), each axis on its own. Threads: one, the servo's. A plain
// value.
#pragma once

#include "config/types/vec2.h"

#include <array>
#include <cstddef>

namespace touchline {

class VelocityEstimate {
  public:
    /// `noise_m` > 0: how far a sample may lie from the truth; one encoder step.
    explicit VelocityEstimate(double noise_m) : noise_m_(noise_m) {}

    /// Slope from the newest sample back over the longest window, at most 16 periods, on whose line
    /// all samples between lie to within the noise. The first sample gives 0, and so does one that
    /// is not finite, which also forgets all others. `dt_s` > 0 since the last one.
    Velocity step(Position position, double dt_s);

    void reset() { count_ = 0; }

    [[nodiscard]] Velocity velocity() const { return velocity_; }

    /// Whether a copy from bytes may be stepped.
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
