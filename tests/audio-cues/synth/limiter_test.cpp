#include "audio-cues/synth/limiter.h"

#include "audio-cues/synth/gain.h"
#include "tests/audio-cues/spectrum.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Limiter, VO3_NoSampleIsEverAboveTheCap) {
    std::mt19937 random(7);
    for (const double cap : {0.0, 0.1, 0.5, 1.0}) {
        Limiter limiter;
        for (int block = 0; block < 2000; ++block) {
            std::array<StereoFrame, block_frames> frames;
            const float loud = std::exp2(float(random() % 12) - 6.0F);
            for (StereoFrame& frame : frames) {
                const auto sample = [&] {
                    return loud * (float(random() % 2001) / 1000.0F - 1.0F);
                };
                frame = {sample(), sample()};
                if (random() % 500 == 0) frame.left = std::numeric_limits<float>::infinity();
                if (random() % 500 == 0) frame.right = std::numeric_limits<float>::quiet_NaN();
            }
            limiter.process(frames, cap);
            for (const StereoFrame& frame : frames) {
                ASSERT_LE(std::abs(frame.left), static_cast<float>(cap));
                ASSERT_LE(std::abs(frame.right), static_cast<float>(cap));
            }
        }
    }
}

TEST(Limiter, ACapThatIsNoneIsSilence) {
    for (const double cap : {-1.0, 1.1, std::nan("")}) {
        std::array<StereoFrame, 256> frames;
        frames.fill({0.5F, 0.5F});
        Limiter().process(frames, cap);
        for (const StereoFrame& frame : frames) ASSERT_EQ(frame, StereoFrame{});
    }
}

TEST(Limiter, WhatIsBelowTheCapPassesUnchangedAndLater) {
    Limiter limiter;
    std::vector<StereoFrame> frames(1000);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i] = {0.4F * std::sin(0.05F * float(i)), 0.3F};
    }
    const auto before = frames;
    limiter.process(frames, 0.5);
    for (std::size_t i = 64; i < frames.size(); ++i) ASSERT_EQ(frames[i], before[i - 64]);
}

TEST(Limiter, AnOverloadStaysASineRatherThanAClippedOne) {
    Limiter limiter;
    std::vector<StereoFrame> frames(48000);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto sample = static_cast<float>(
            2.0 * std::sin(2.0 * std::numbers::pi * 1000.0 * double(i) / 48000.0));
        frames[i] = {sample, sample};
    }
    limiter.process(frames, 0.5);
    const auto sound = left_of_stereo(std::span(frames).subspan(24000));
    EXPECT_GT(peak(sound), 0.48F);
    EXPECT_LT(loudest_above_dB(sound, 2500.0), -50.0);  // hard clipping would give -16 dB
}

}  // namespace
}  // namespace touchline
