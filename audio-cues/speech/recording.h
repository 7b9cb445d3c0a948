// Words that somebody recorded, as they are kept until they are heard: as loud as the voice.
// Threads: values and pure functions.
#pragma once

#include "audio-cues/synth/frames.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace touchline {

/// Mono at frame_rate_Hz.
struct VoiceRecording {
    std::vector<std::int16_t> samples;  // full scale 32767
    float gain = 1.0F;                  // with which they are heard
};

/// Shared, because it is large and never changes.
using VoiceRecordingPtr = std::shared_ptr<const VoiceRecording>;

/// The level in dB below a full sine, of the loud parts alone: pauses do not count. Speech that
/// people made peaks 12 to 18 dB above it. Infinite for silence. O(samples).
[[nodiscard]] double speech_level_dB(std::span<const std::int16_t> samples);

inline constexpr double most_gain_dB = 20.0;  // else a recording of noise would be made as loud

/// The samples with the gain that makes them as loud as the voice, so that a visitor's volume, and
/// what the operator measured, hold for both. O(samples).
[[nodiscard]] VoiceRecording recording_of(std::vector<std::int16_t> samples);

[[nodiscard]] inline double length_s(const VoiceRecording& recording) {
    return static_cast<double>(recording.samples.size()) / frame_rate_Hz;
}

inline constexpr double longest_name_s = 5.0;

/// The recording if it is as short as a name, else null. In a row of a list a longer one would keep
/// the listener from hearing what follows the name: there the voice says it.
[[nodiscard]] inline VoiceRecordingPtr if_short(const VoiceRecordingPtr& recording) {
    return recording && length_s(*recording) <= longest_name_s ? recording : nullptr;
}

}  // namespace touchline
