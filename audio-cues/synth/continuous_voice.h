// A continuous sound that follows the hand: position tone, distance, sonar.
// Threads: a ContinuousTone is a value, the voice is the rendering thread's.
#pragma once

#include "audio-cues/synth/oscillator.h"
#include "audio-cues/synth/pan.h"
#include "audio-cues/synth/ramp.h"

#include <span>

namespace touchline {

struct ContinuousTone {
    double frequency_Hz = 440.0;  // 0 ... 8000
    double level = 0.0;           // peak, 0 ... 1; 0: silence
    double pan = 0.0;             // -1 left ... 1 right
    double pulse_Hz = 0.0;        // 0: steady; at most 20
    Timbre timbre = Timbre::pure;
};

/// Glides to each new tone: the level within ramp_s, the pitch by 1/e in 20 ms.
class ContinuousVoice {
  public:
    void set(const ContinuousTone& tone);

    /// See Voice::add().
    void add(std::span<StereoFrame> out, double width);

    [[nodiscard]] bool is_silent() const { return level_.is_silent() && tail_left_ == 0; }

  private:
    float next();

    ContinuousTone tone_;
    Ramp level_;
    Ramp pulse_;
    double pulse_phase_ = 0.0;
    double frequency_Hz_ = 0.0;
    Oscillator oscillator_;
    PannedSource source_;
    int tail_left_ = 0;  // frames that the far ear still hears
};

}  // namespace touchline
