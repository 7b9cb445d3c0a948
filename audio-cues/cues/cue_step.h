// Turns events into cues, and cues into commands for the mixer: pure steps. Threads: values and
// pure functions.
#pragma once

#include "audio-cues/cues/cue_table.h"
#include "audio-cues/synth/mixer.h"

#include <array>
#include <optional>

namespace touchline {

struct CueState {
    CueAmount amount = CueAmount::cues;
    CueArea area;
    double level = 0.0;  // last rendered, to tell finer from coarser
    /// When each cue last sounded, by the servo's clock; initially before everything.
    std::array<double, cue_count> last_s = [] {
        std::array<double, cue_count> times{};
        times.fill(-1e9);
        return times;
    }();
};

struct CueStep {
    CueState state;
    std::optional<CueAt> cue;
};

/// Gives no cue if sounds are off, if the same cue sounded less than its `apart_s` ago, or if the
/// level did not change. An invalid kind gives none. O(1).
[[nodiscard]] CueStep cue_step(const CueState& state, const ContactEvent& event);

/// The same for the screen; `time_s` by the servo's clock. The cue is always in the middle.
[[nodiscard]] CueStep cue_step(const CueState& state, ScreenEvent event, double time_s);

/// Returns what the mixer plays; `frame` is when it sounds.
[[nodiscard]] MixerCommand sound_of(const CueAt& cue, FrameTime frame);

}  // namespace touchline
