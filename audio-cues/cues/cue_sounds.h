// Turns cues into commands for the mixer. Threads: pure functions.
#pragma once

#include "audio-cues/cues/cue.h"
#include "audio-cues/synth/mixer.h"

namespace touchline {

/// `frame` is when it sounds.
[[nodiscard]] MixerCommand sound_of(const CueAt& cue, FrameTime frame);

}  // namespace touchline
