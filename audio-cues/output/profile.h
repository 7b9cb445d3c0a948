// Loudness: the volume steps between the levels that an operator set (config/settings/sound.h), and
// what they mean for the mixer. Threads: values and pure functions.
#pragma once

#include "audio-cues/synth/mixer.h"
#include "config/settings/sound.h"

#include <cstddef>

namespace touchline {

/// The engine's speech is this much below a full sine.
inline constexpr double speech_below_full_dB = 18.8;

/// Returns the number of steps, at least 1.
[[nodiscard]] std::size_t volume_steps(const OutputProfile& profile);

[[nodiscard]] std::size_t default_volume(const OutputProfile& profile);

/// Returns the level of speech at that step, clamped to the existing ones.
[[nodiscard]] double level_dB_of(const OutputProfile& profile, std::size_t step);

struct VolumeChange {
    std::size_t step = 0;
    bool is_at_end = false;  // nothing changed: this is the loudest or softest step
};

/// Goes one step up (`change` > 0) or down.
[[nodiscard]] VolumeChange change_volume(const OutputProfile& profile, std::size_t step,
                                         int change);

/// Returns the mixer's setting.
[[nodiscard]] SetOutput output_of(const OutputProfile& profile, std::size_t step);

}  // namespace touchline
