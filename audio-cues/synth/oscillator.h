// Waves from a table. Threads: an Oscillator is the rendering thread's.
#pragma once

#include "audio-cues/synth/frames.h"

#include <cstdint>

namespace touchline {

/// pure: a sine. hollow: odd harmonics, like a clarinet. bright: octave and twelfth, like a bell.
enum class Timbre : std::uint8_t { pure, hollow, bright };

/// Continuous in phase whatever the frequency does. The phase stays in 0 ... 1, so that an hour
/// adds no error of its own.
class Oscillator {
  public:
    /// One frame on. `frequency_Hz` in 0 ... 8000, so that no harmonic folds back; else 0. Peaks at
    /// most 1, begins at 0 and rises.
    float next(Timbre timbre, double frequency_Hz);

  private:
    double phase_ = 0.0;
};

}  // namespace touchline
