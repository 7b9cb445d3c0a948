// Measures what is in a sound: levels, frequencies, times. For tests and their pictures.
// Threads: pure functions.
#pragma once

#include "audio-cues/synth/mixer.h"

#include <cmath>
#include <span>
#include <vector>

namespace touchline {

/// Returns the powers at the frequencies i * frame_rate_Hz / size for i in 0 ... size / 2, of
/// `size` samples (a power of two) under a Blackman-Harris window, whose own leaks are below -92
/// dB. A sine of amplitude 1 has power 1. O(size log size).
[[nodiscard]] std::vector<double> power_spectrum(std::span<const float> samples);

/// Returns the strongest frequency, to a fraction of a bin; 0 for silence.
[[nodiscard]] double strongest_Hz(std::span<const float> samples);

[[nodiscard]] double rms(std::span<const float> samples);

/// Returns -infinity for 0.
[[nodiscard]] inline double dB_of_gain(double gain) {
    return 20.0 * std::log10(gain);
}

[[nodiscard]] float peak(std::span<const float> samples);

/// Returns the level in dB, against a full sine, of the loudest stretch of 512 samples above
/// `above_Hz`: a click is broad, a note is not.
[[nodiscard]] double loudest_above_dB(std::span<const float> samples, double above_Hz);

/// Returns the index of the first sample that is not 0; the size if all are 0.
[[nodiscard]] std::size_t first_sound(std::span<const float> samples);

[[nodiscard]] std::vector<float> left_of_stereo(std::span<const StereoFrame> frames);
[[nodiscard]] std::vector<float> right_of_stereo(std::span<const StereoFrame> frames);

/// Renders the next frames of the mixer, in blocks as a device asks for them.
[[nodiscard]] std::vector<StereoFrame> rendered(Mixer& mixer, std::size_t frames);

}  // namespace touchline
