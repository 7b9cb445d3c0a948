// From the engine's rate to the mixer's. Threads: one thread's.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

/// 22 050 Hz to 48 000 Hz, that is 320 for 147, by a windowed sinc of 16 samples to each side: what
/// lies below 9.5 kHz passes within 0.1 dB, images are below -70 dB. 16 samples (0.7 ms) later.
class Resampler {
  public:
    Resampler();

    /// Samples of full scale 32767 in, of full scale 1 out; 16 filters' taps a sample.
    void add(std::span<const std::int16_t> samples, std::vector<float>& out);

    /// The last 16 samples, and as new after it.
    void finish(std::vector<float>& out);

  private:
    static constexpr int half = 16;
    static constexpr int up = 320;
    static constexpr int down = 147;

    void push(float sample, std::vector<float>& out);

    std::vector<float> taps_;                // `up` filters of 2 * half
    std::array<float, 2 * half> history_{};  // a ring
    std::size_t newest_ = 0;
    int phase_ = 0;  // of the next output, in 1/up of a sample after the newest
};

}  // namespace touchline
