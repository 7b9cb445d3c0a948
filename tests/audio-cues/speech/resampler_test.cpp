#include "audio-cues/speech/resampler.h"

#include "tests/audio-cues/spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::vector<float> sine(double frequency_Hz, std::size_t count, double rate_Hz = 22050.0) {
    std::vector<float> samples;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle =
            2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / rate_Hz;
        samples.push_back(static_cast<float>(0.5 * std::sin(angle)));
    }
    return samples;
}

TEST(Resampler, KeepsPitchAndLevelAndMakesNoImages) {
    for (const double frequency_Hz : {200.0, 1000.0, 4000.0, 9000.0, 9350.0}) {
        Resampler resampler(22050);
        std::vector<float> out;
        resampler.add(sine(frequency_Hz, 22050), out);
        const auto middle = std::span(out).subspan(4000, 32768);
        EXPECT_NEAR(strongest_Hz(middle), frequency_Hz, 0.1);
        EXPECT_NEAR(20.0 * std::log10(rms(middle) / (0.5 / std::sqrt(2.0))), 0.0, 0.1);
        auto powers = power_spectrum(middle);
        const auto bin = static_cast<std::size_t>(frequency_Hz * 32768.0 / 48000.0);
        for (std::size_t i = bin - 30; i <= bin + 30; ++i) powers[i] = 0.0;
        EXPECT_LT(10.0 * std::log10(*std::max_element(powers.begin(), powers.end())), -70.0);
    }
}

TEST(Resampler, FromAHigherRateWhatIsHeardStaysAndTheRestGoes) {
    const auto level_dB = [](double frequency_Hz) {
        const auto made = at_frame_rate(sine(frequency_Hz, 96000, 96000.0), 96000);
        return 20.0 *
               std::log10(rms(std::span(made).subspan(4000, 32768)) / (0.5 / std::sqrt(2.0)));
    };
    EXPECT_NEAR(level_dB(1000.0), 0.0, 0.1);
    EXPECT_NEAR(level_dB(16000.0), 0.0, 0.1);
    EXPECT_LT(level_dB(30000.0), -70.0);
}

TEST(Resampler, PiecesOfAnySizeGiveTheSameAndTheLengthIsRight) {
    const auto samples = sine(440.0, 14700);
    const auto expected = at_frame_rate(samples, 22050);
    EXPECT_NEAR(static_cast<double>(expected.size()), 32000.0, 1.0);
    Resampler parts(22050);
    std::vector<float> out;
    for (std::size_t i = 0; i < samples.size(); i += 441) {
        parts.add(std::span(samples).subspan(i, std::min<std::size_t>(441, samples.size() - i)),
                  out);
    }
    parts.finish(out);
    EXPECT_EQ(out, expected);
}

}  // namespace
}  // namespace touchline
