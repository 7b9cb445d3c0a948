#include "audio-cues/synth/ducker.h"

#include "audio-cues/synth/decibel.h"

#include <algorithm>

namespace touchline {

double Ducker::step(bool is_other_sounding, double seconds) {
    hold_s_ = is_other_sounding ? duck_hold_s : std::max(0.0, hold_s_ - seconds);
    const double wanted_dB = hold_s_ > 0.0 ? duck_dB : 0.0;
    if (wanted_dB == level_dB_) return gain_;
    const double change_dB = -duck_dB * seconds / (wanted_dB < level_dB_ ? duck_down_s : duck_up_s);
    level_dB_ = std::clamp(wanted_dB, level_dB_ - change_dB, level_dB_ + change_dB);
    return gain_ = gain_of_dB(level_dB_);
}

}  // namespace touchline
