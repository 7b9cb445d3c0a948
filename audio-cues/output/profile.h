// How loud: levels of a headset or a speaker as they arrive at the ear, and the volume steps
// between them. Threads: values and pure functions.
#pragma once

#include "audio-cues/synth/mixer.h"
#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace touchline {

enum class OutputKind : std::uint8_t { headset, speaker };

/// Of one output at one place; all levels in dB SPL (dB(A) on a speaker) where the visitor's ear
/// is.
struct OutputProfile {
    OutputKind kind = OutputKind::headset;
    double full_scale_dB = 110.0;  // measured: a full sine in the middle
    double quietest_dB = 50.0;     // of speech
    double loudest_dB = 80.0;
    double step_dB = 5.0;
    double default_dB = 65.0;  // at the start of every session
    double cap_dB = 100.0;     // no peak is above
    double ambient_dB = 45.0;  // of the room, as the operator measured it
    bool is_mono = false;
};

/// Before they are calibrated on site: cautious, for common hardware.
[[nodiscard]] OutputProfile default_profile(OutputKind kind);

/// Speech as the engine makes it is this much below a full sine.
inline constexpr double speech_below_full_dB = 18.8;

/// The rules: steps of 1 to 6 dB (so that one lies at +12 dB), a range of 18 dB at least, 20 dB
/// above a room of more than 45 dB, a speaker that reaches 65 dB, a default of 60 to 70 dB (65 at
/// most on a speaker) that is one of the steps, a cap between the loudest speech and what the
/// output can give, at most 105 dB. One line that names what is wrong.
[[nodiscard]] Result<void> check(const OutputProfile& profile);

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
