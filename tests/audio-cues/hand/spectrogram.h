// Draws a sound: time runs to the right, pitch upwards, and loud is bright.
// Threads: pure functions.
#pragma once

#include "audio-cues/synth/frames.h"

#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

/// A grey picture, rows from the top: the left ear above the right one.
struct Spectrogram {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

/// A column is 10 ms, or more if the sound is longer than `width` columns. A row is a twelfth of an
/// octave from 110 Hz to 7 kHz. Black is 70 dB below a full sine.
[[nodiscard]] Spectrogram spectrogram_of(std::span<const StereoFrame> sound, int width);

}  // namespace touchline
