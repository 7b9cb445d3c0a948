// What sound is made of here. Threads: constants and values.
#pragma once

#include <cstdint>

namespace touchline {

inline constexpr int frame_rate_Hz = 48000;

/// Rendered at once, at most; 2.7 ms.
inline constexpr int block_frames = 128;

/// Frames since the mixer's first.
using FrameTime = std::int64_t;

/// One sample for each ear; full scale is -1 ... 1.
struct StereoFrame {
    float left = 0.0F;
    float right = 0.0F;

    friend bool operator==(const StereoFrame&, const StereoFrame&) = default;
};

}  // namespace touchline
