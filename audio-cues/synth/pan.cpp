#include "audio-cues/synth/pan.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace touchline {

Ears ears_of(double pan) {
    static_assert(far_ear_delay_s * frame_rate_Hz + 1.0 < PannedSource::tail_frames);
    const double side = std::isnan(pan) ? 0.0 : std::clamp(pan, -1.0, 1.0);
    const double quarter = std::numbers::pi / 4.0;
    const double turn = side * (quarter - std::atan(std::pow(10.0, -pan_limit_dB / 20.0)));
    const double delay_frames = far_ear_delay_s * frame_rate_Hz;
    return {static_cast<float>(std::cos(quarter + turn)),
            static_cast<float>(std::cos(quarter - turn)),
            static_cast<float>(std::max(side, 0.0) * delay_frames),
            static_cast<float>(std::max(-side, 0.0) * delay_frames)};
}

float PannedSource::delayed(int frame, float delay_frames) const {
    const float place = static_cast<float>(tail_frames + frame) - delay_frames;
    const auto before = static_cast<std::size_t>(place);
    const float part = place - static_cast<float>(before);
    if (part == 0.0F) return heard_[before];
    return heard_[before] + part * (heard_[before + 1] - heard_[before]);
}

void PannedSource::add(std::span<const float> mono, double pan, std::span<StereoFrame> out) {
    assert(mono.size() <= static_cast<std::size_t>(block_frames) && mono.size() == out.size());
    const Ears to = ears_of(pan);
    if (!is_placed_) ears_ = to;
    is_placed_ = true;
    std::copy(mono.begin(), mono.end(), heard_.begin() + tail_frames);
    const float share = 1.0F / static_cast<float>(std::max<std::size_t>(mono.size(), 1));
    for (std::size_t i = 0; i < mono.size(); ++i) {
        const float t = static_cast<float>(i + 1) * share;
        const auto between = [t](float a, float b) { return a + t * (b - a); };
        const int frame = static_cast<int>(i);
        out[i].left += between(ears_.left_gain, to.left_gain) *
                       delayed(frame, between(ears_.left_delay_frames, to.left_delay_frames));
        out[i].right += between(ears_.right_gain, to.right_gain) *
                        delayed(frame, between(ears_.right_delay_frames, to.right_delay_frames));
    }
    ears_ = to;
    const auto last = heard_.begin() + static_cast<std::ptrdiff_t>(mono.size());
    std::copy(last, last + tail_frames, heard_.begin());
}

}  // namespace touchline
