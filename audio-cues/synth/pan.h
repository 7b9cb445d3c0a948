// Places sound left and right by level and by time.
// Threads: pure functions; a PannedSource is the rendering thread's.
#pragma once

#include "audio-cues/synth/frames.h"

#include <array>
#include <span>

namespace touchline {

/// The limit lets a listener with one good ear still hear the other side.
inline constexpr double pan_limit_dB = 20.0;

/// The delay of the far ear.
inline constexpr double far_ear_delay_s = 0.0006;

struct Ears {
    float left_gain = 0.0F;  // squares sum to 1
    float right_gain = 0.0F;
    float left_delay_frames = 0.0F;  // one of the two is 0
    float right_delay_frames = 0.0F;
};

/// `pan`: -1 left ... 1 right, clamped; NaN is the middle. Constant power; the difference in dB
/// reaches pan_limit_dB at the sides. In the middle both ears are the same, bit for bit.
[[nodiscard]] Ears ears_of(double pan);

/// A mono sound at a place that may move. It sounds far_ear_delay_s longer than it is fed.
class PannedSource {
  public:
    /// Adds `mono` (at most block_frames) to `out`, of the same length, and moves to `pan`
    /// meanwhile; the first call begins there. O(frames).
    void add(std::span<const float> mono, double pan, std::span<StereoFrame> out);

    static constexpr int tail_frames = 32;

  private:
    [[nodiscard]] float delayed(int frame, float delay_frames) const;

    std::array<float, tail_frames + block_frames> heard_{};  // the tail of the last call first
    Ears ears_{};
    bool is_placed_ = false;
};

}  // namespace touchline
