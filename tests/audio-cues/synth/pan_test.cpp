#include "audio-cues/synth/voices.h"
#include "tests/audio-cues/spectrum.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

double difference_dB(const Ears& ears) {
    return dB_of_gain(double(ears.right_gain)) - dB_of_gain(double(ears.left_gain));
}

TEST(Pan, KeepsThePowerAndNeverGoesBeyondTwentyDecibels) {
    double last_dB = -100.0;
    for (int i = -150; i <= 150; ++i) {
        const Ears ears = ears_of(i / 100.0);
        const double left = double(ears.left_gain);
        const double right = double(ears.right_gain);
        EXPECT_NEAR(left * left + right * right, 1.0, 1e-6);
        const double now_dB = difference_dB(ears);
        EXPECT_LE(std::abs(now_dB), 20.0 + 1e-4);
        if (i > -100 && i <= 100) {
            EXPECT_GT(now_dB, last_dB) << "further right is louder there";
        }
        last_dB = now_dB;
    }
    EXPECT_NEAR(difference_dB(ears_of(1.0)), 20.0, 1e-4);
    EXPECT_NEAR(difference_dB(ears_of(-1.0)), -20.0, 1e-4);
}

TEST(Pan, TheFarEarHearsLaterByUpToSixTenthsOfAMillisecond) {
    EXPECT_FLOAT_EQ(ears_of(1.0).left_delay_frames, 28.8F);
    EXPECT_EQ(ears_of(1.0).right_delay_frames, 0.0F);
    EXPECT_FLOAT_EQ(ears_of(-0.5).right_delay_frames, 14.4F);
    EXPECT_EQ(ears_of(-0.5).left_delay_frames, 0.0F);
}

TEST(Pan, TheMiddleAndNoNumberAreTheSameForBothEars) {
    for (const double pan : {0.0, std::nan("")}) {
        const Ears ears = ears_of(pan);
        EXPECT_EQ(ears.left_gain, ears.right_gain);
        EXPECT_EQ(ears.left_delay_frames, 0.0F);
        EXPECT_EQ(ears.right_delay_frames, 0.0F);
    }
}

TEST(PannedSource, SamplesFollowTheLawAlsoAcrossBlocks) {
    PannedSource source;
    std::vector<StereoFrame> out(512);
    std::vector<float> mono(512);
    for (std::size_t i = 0; i < mono.size(); ++i) mono[i] = std::sin(0.06F * float(i));
    for (std::size_t i = 0; i < mono.size(); i += 128) {
        source.add(std::span(mono).subspan(i, 128), 1.0, std::span(out).subspan(i, 128));
    }
    const Ears ears = ears_of(1.0);
    for (std::size_t i = 64; i < mono.size(); ++i) {
        ASSERT_NEAR(out[i].right, ears.right_gain * mono[i], 1e-6F);
        const float then = std::sin(0.06F * (float(i) - 28.8F));
        ASSERT_NEAR(out[i].left, ears.left_gain * then, 2e-4F);
    }
}

TEST(PannedSource, MovingFromSideToSideInABlockDoesNotClick) {
    PannedSource source;
    std::vector<StereoFrame> out(16384);
    std::vector<float> mono(128);
    for (std::size_t i = 0; i < out.size(); i += 128) {
        for (std::size_t k = 0; k < 128; ++k) {
            mono[k] = static_cast<float>(
                0.5 * std::sin(2.0 * std::numbers::pi * 440.0 * double(i + k) / 48000.0));
        }
        // A hand at 0.5 m/s crosses the area in a quarter of a second.
        const double pan = std::sin(2.0 * std::numbers::pi * 2.0 * double(i) / 48000.0);
        source.add(mono, pan, std::span(out).subspan(i, 128));
    }
    const auto sound = left_of_stereo(out);
    EXPECT_LT(loudest_above_dB(std::span(sound).subspan(512), 8000.0), -60.0);
}

}  // namespace
}  // namespace touchline
