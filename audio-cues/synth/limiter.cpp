#include "audio-cues/synth/limiter.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

const float release = static_cast<float>(1.0 - std::exp(-1.0 / (0.100 * frame_rate_Hz)));

float sound_of(float sample) {
    return std::isfinite(sample) ? sample : 0.0F;
}

}  // namespace

/// Returns the lowest gain that any of the last `window` frames wants.
float Limiter::lowest_gain(float wanted) {
    const auto at = [this](int i) -> Candidate& {
        return candidates_[static_cast<std::size_t>((oldest_ + i) % window)];
    };
    if (count_ > 0 && at(0).frame <= frame_ - window) {
        oldest_ = (oldest_ + 1) % window;
        --count_;
    }
    while (count_ > 0 && at(count_ - 1).gain >= wanted) --count_;
    at(count_++) = {wanted, frame_};
    return at(0).gain;
}

void Limiter::process(std::span<StereoFrame> frames, double cap) {
    const float top = cap >= 0.0 && cap <= 1.0 ? static_cast<float>(cap) : 0.0F;
    for (StereoFrame& frame : frames) {
        const StereoFrame now{sound_of(frame.left), sound_of(frame.right)};
        const float peak = std::max(std::abs(now.left), std::abs(now.right));
        const float lowest = lowest_gain(peak > top ? top / peak : 1.0F);
        released_ = std::min(lowest, released_ + release * (1.0F - released_));
        // The mean over the window is low enough once the peak arrives, and moves without a step.
        const auto slot = static_cast<std::size_t>(frame_ % window);
        sum_ += static_cast<double>(released_) - static_cast<double>(smoothed_[slot]);
        smoothed_[slot] = released_;
        if (slot == 0) {  // sums drift; start again once a window
            sum_ = 0.0;
            for (const float gain : smoothed_) sum_ += static_cast<double>(gain);
        }
        const auto gain = static_cast<float>(std::min(1.0, sum_ / window));
        ahead_[slot] = now;
        const StereoFrame& then = ahead_[static_cast<std::size_t>((frame_ + 1) % window)];
        frame = {std::clamp(gain * then.left, -top, top), std::clamp(gain * then.right, -top, top)};
        ++frame_;
    }
}

}  // namespace touchline
