// The units of sound here. Threads: constants and values.
#pragma once

#include <cstdint>

namespace touchline {

inline constexpr int frame_rate_Hz = 48000;

/// The most frames rendered at once; 2.7 ms.
inline constexpr int block_frames = 128;

/// Converts a 16-bit sample, of which full scale is 32767.
[[nodiscard]] constexpr float of_full_scale(std::int16_t sample) {
    return static_cast<float>(sample) / 32767.0F;
}

/// Frames since the mixer's first.
using FrameTime = std::int64_t;

/// One sample for each ear; full scale is -1 ... 1.
struct StereoFrame {
    float left = 0.0F;
    float right = 0.0F;

    friend bool operator==(const StereoFrame&, const StereoFrame&) = default;
};

}  // namespace touchline
