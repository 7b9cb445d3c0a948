#include "audio-cues/speech/recording.h"

#include "audio-cues/output/outputs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace touchline {
namespace {

constexpr std::size_t stretch = frame_rate_Hz / 20;  // 50 ms: a syllable
constexpr double pause_below = 0.1;                  // of the mean power: 10 dB, as loudness meters

double power_of(std::span<const std::int16_t> samples) {
    double sum = 0.0;
    for (const std::int16_t sample : samples) {
        const double value = of_full_scale(sample);
        sum += value * value;
    }
    return sum / static_cast<double>(samples.size());
}

/// 0 for none.
double mean_above(const std::vector<double>& powers, double least) {
    double sum = 0.0;
    double count = 0.0;
    for (const double power : powers) {
        if (power <= least) continue;
        sum += power;
        ++count;
    }
    return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

double speech_level_dB(std::span<const std::int16_t> samples) {
    std::vector<double> powers;
    for (; !samples.empty(); samples = samples.subspan(std::min(stretch, samples.size())))
        powers.push_back(power_of(samples.first(std::min(stretch, samples.size()))));
    const double power = mean_above(powers, pause_below * mean_above(powers, 0.0));
    constexpr double of_full_sine = 0.5;
    return power > 0.0 ? 10.0 * std::log10(power / of_full_sine)
                       : -std::numeric_limits<double>::infinity();
}

VoiceRecording recording_of(std::vector<std::int16_t> samples) {
    const double gain_dB = std::min(-speech_below_full_dB - speech_level_dB(samples), most_gain_dB);
    return {std::move(samples), static_cast<float>(std::pow(10.0, gain_dB / 20.0))};
}

}  // namespace touchline
