// How loud: the volume steps between the levels that an operator set (config/settings/sound.h), and
// what the mixer makes of them. Threads: values and pure functions.
#pragma once

#include "audio-cues/synth/mixer.h"
#include "config/settings/sound.h"

#include <cstddef>

namespace touchline {

/// Speech as the engine makes it is this much below a full sine.
inline constexpr double speech_below_full_dB = 18.8;

/// At least 1.
[[nodiscard]] std::size_t volume_steps(const OutputProfile& profile);

[[nodiscard]] std::size_t default_volume(const OutputProfile& profile);

/// Of speech at that step, clamped to those there are.
[[nodiscard]] double level_dB_of(const OutputProfile& profile, std::size_t step);

struct VolumeChange {
    std::size_t step = 0;
    bool is_at_end = false;  // nothing changed: this is the loudest or the softest
};

/// One step up (`change` > 0) or down.
[[nodiscard]] VolumeChange change_volume(const OutputProfile& profile, std::size_t step,
                                         int change);

/// For the mixer.
[[nodiscard]] SetOutput output_of(const OutputProfile& profile, std::size_t step);

}  // namespace touchline
