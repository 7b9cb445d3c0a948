// Keeps every sample below a cap, whatever comes in, for the safety of ears. Threads: the rendering
// thread's.
#pragma once

#include "audio-cues/synth/frames.h"

#include <array>
#include <span>

namespace touchline {

/// Looks `look_ahead_frames` ahead, so that the gain goes down before a peak arrives, without
/// distorting what is below the cap; it comes back by 1/e in 100 ms.
class Limiter {
  public:
    /// 1.3 ms, by which it delays everything.
    static constexpr int look_ahead_frames = 64;

    /// Works in place, `look_ahead_frames` late. No |sample| of the output is above `cap` (0 ... 1,
    /// else 0: silence); samples that are not finite become silence. O(frames), and a peak costs no
    /// more than others.
    void process(std::span<StereoFrame> frames, double cap);

  private:
    static constexpr int window = look_ahead_frames + 1;

    float lowest_gain(float wanted);

    struct Candidate {
        float gain = 1.0F;
        std::int64_t frame = 0;
    };

    std::array<StereoFrame, window> ahead_{};
    std::array<Candidate, window> candidates_{};  // a ring, gains rising from the oldest
    int oldest_ = 0;
    int count_ = 0;
    std::array<float, window> smoothed_ = ones();  // gains to be averaged
    std::int64_t frame_ = 0;
    float released_ = 1.0F;

    static constexpr std::array<float, window> ones() {
        std::array<float, window> gains{};
        gains.fill(1.0F);
        return gains;
    }

    double sum_ = window;
};

}  // namespace touchline
