// Waves from a table. Threads: an Oscillator is the rendering thread's.
#pragma once

#include "audio-cues/synth/frames.h"

#include <cstdint>

namespace touchline {

/// pure: a sine. hollow: odd harmonics, like a clarinet. bright: octave and twelfth, like a bell.
enum class Timbre : std::uint8_t { pure, hollow, bright };

/// Its phase is continuous whatever the frequency does, and stays in 0 ... 1, so that an hour adds
/// no error of its own.
class Oscillator {
  public:
    /// Advances one frame. `frequency_Hz` in 0 ... 8000, so that no harmonic folds back; else 0.
    /// Peaks at most at 1, begins at 0 and rises.
    float next(Timbre timbre, double frequency_Hz);

  private:
    double phase_ = 0.0;
};

}  // namespace touchline
