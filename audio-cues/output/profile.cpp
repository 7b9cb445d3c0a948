#include "audio-cues/output/profile.h"

#include "audio-cues/synth/decibel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {

OutputProfile default_profile(OutputKind kind) {
    OutputProfile profile;
    profile.kind = kind;
    if (kind == OutputKind::speaker) {
        profile.full_scale_dB = 95.0;
        profile.loudest_dB = 75.0;
        profile.cap_dB = 92.0;
    }
    return profile;
}

Result<void> check(const OutputProfile& profile) {
    const std::array levels{profile.full_scale_dB, profile.quietest_dB, profile.loudest_dB,
                            profile.step_dB,       profile.default_dB,  profile.cap_dB,
                            profile.ambient_dB};
    if (!std::all_of(levels.begin(), levels.end(), [](double dB) { return std::isfinite(dB); })) {
        return failure("Every level of an output is a number.");
    }
    if (profile.step_dB < 1.0 || profile.step_dB > 6.0) {
        return failure("A volume step is 1 to 6 dB.");
    }
    if (profile.loudest_dB - profile.quietest_dB < 18.0) {
        return failure("The volume has a range of 18 dB at least.");
    }
    if (profile.ambient_dB > 45.0 && profile.loudest_dB < profile.ambient_dB + 20.0) {
        return failure("In a room of more than 45 dB the volume reaches 20 dB above it.");
    }
    const bool is_speaker = profile.kind == OutputKind::speaker;
    if (is_speaker && profile.loudest_dB < 65.0) {
        return failure("A speaker reaches 65 dB.");
    }
    if (profile.default_dB < 60.0 || profile.default_dB > (is_speaker ? 65.0 : 70.0)) {
        return failure(is_speaker ? "A speaker begins with 60 to 65 dB."
                                  : "A headset begins with 60 to 70 dB.");
    }
    if (std::abs(level_dB_of(profile, default_volume(profile)) - profile.default_dB) > 0.01) {
        return failure("The volume to begin with is one of its steps.");
    }
    if (profile.cap_dB < profile.loudest_dB || profile.cap_dB > 105.0 ||
        profile.cap_dB > profile.full_scale_dB) {
        return failure(
            "The cap lies above the loudest speech, within 105 dB and what the output gives.");
    }
    return {};
}

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
    // The middle gives each ear the square root of a half: the cap is of what arrives.
    const double cap = gain_of_dB(profile.cap_dB - profile.full_scale_dB - 3.01);
    return {gain_of_dB(gain_dB), std::min(cap, 1.0), profile.is_mono};
}

}  // namespace touchline
