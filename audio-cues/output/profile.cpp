#include "audio-cues/output/profile.h"

#include "audio-cues/synth/gain.h"

#include <algorithm>
#include <cmath>

namespace touchline {

std::size_t volume_steps(const OutputProfile& profile) {
    const double steps =
        std::floor((profile.loudest_dB - profile.quietest_dB) / profile.step_dB + 0.01);
    return steps >= 0.0 && steps < 1000.0 ? static_cast<std::size_t>(steps) + 1 : 1;
}

std::size_t default_volume(const OutputProfile& profile) {
    const double step = std::round((profile.default_dB - profile.quietest_dB) / profile.step_dB);
    const auto last = static_cast<double>(volume_steps(profile) - 1);
    return step >= 0.0 ? static_cast<std::size_t>(std::min(step, last)) : 0;
}

double level_dB_of(const OutputProfile& profile, std::size_t step) {
    const std::size_t there = std::min(step, volume_steps(profile) - 1);
    return profile.quietest_dB + static_cast<double>(there) * profile.step_dB;
}

VolumeChange change_volume(const OutputProfile& profile, std::size_t step, int change) {
    const std::size_t last = volume_steps(profile) - 1;
    const std::size_t now = std::min(step, last);
    if (change > 0) return now == last ? VolumeChange{now, true} : VolumeChange{now + 1, false};
    return now == 0 ? VolumeChange{now, true} : VolumeChange{now - 1, false};
}

SetOutput output_of(const OutputProfile& profile, std::size_t step) {
    const double gain_dB =
        level_dB_of(profile, step) - profile.full_scale_dB + speech_below_full_dB;
    // The middle gives each ear the square root of a half, so the cap applies to what arrives
    // there.
    const double cap = gain_of_dB(profile.cap_dB - profile.full_scale_dB - 3.01);
    return {gain_of_dB(gain_dB), std::min(cap, 1.0), profile.is_mono};
}

}  // namespace touchline
