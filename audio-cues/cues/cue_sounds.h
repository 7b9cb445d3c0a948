// Cues as the mixer takes them. Threads: pure functions.
#pragma once

#include "audio-cues/cues/cue.h"
#include "audio-cues/synth/mixer.h"

namespace touchline {

/// `frame`: when it sounds.
[[nodiscard]] MixerCommand sound_of(const CueAt& cue, FrameTime frame);

}  // namespace touchline
