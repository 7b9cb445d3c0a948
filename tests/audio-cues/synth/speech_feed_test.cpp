#include "audio-cues/synth/mixer.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::vector<float> ones(std::size_t count) {
    return std::vector<float>(count, 1.0F);
}

std::vector<float> read(SpeechFeed& feed, std::size_t count, bool is_paused = false) {
    std::vector<float> out(count);
    (void)feed.read(out, is_paused);
    return out;
}

TEST(SpeechFeed, GivesBackWhatWasWrittenAndThenSilence) {
    SpeechFeed feed(100);
    const std::vector<float> samples{0.1F, 0.2F, 0.3F};
    EXPECT_EQ(feed.write(samples), 3U);
    EXPECT_EQ(feed.waiting(), 3U);
    const std::vector<float> heard = read(feed, 5);
    EXPECT_EQ(heard, (std::vector<float>{0.1F, 0.2F, 0.3F, 0.0F, 0.0F}));
    EXPECT_EQ(feed.waiting(), 0U);
}

TEST(SpeechFeed, TakesOnlyWhatThereIsRoomFor) {
    SpeechFeed feed(100);
    EXPECT_EQ(feed.write(ones(70)), 70U);
    EXPECT_EQ(feed.write(ones(70)), 30U);
    (void)read(feed, 50);
    EXPECT_EQ(feed.write(ones(70)), 50U);
}

TEST(SpeechFeed, ACutFadesWithinTheRampAndWhatComesAfterIsHeardFromItsStart) {
    SpeechFeed feed;
    (void)feed.write(ones(4000));
    (void)read(feed, 1000);
    feed.cut();
    (void)feed.write(ones(1000));
    const auto heard = read(feed, 2000);
    std::size_t silent = 0;
    while (silent < heard.size() && heard[silent] != 0.0F) ++silent;
    EXPECT_GT(silent, 200U);
    EXPECT_LE(silent, 240U);  // 5 ms
    for (std::size_t i = 1; i < silent; ++i) ASSERT_LE(heard[i], heard[i - 1]);
    float all = 0.0F;
    for (std::size_t i = silent; i < heard.size(); ++i) all += heard[i];
    EXPECT_NEAR(all, 1000.0F - 120.0F, 2.0F) << "the new 1000, but for their swelling";
    EXPECT_EQ(feed.waiting(), 0U);
}

TEST(SpeechFeed, APauseUsesUpNothingButItsFade) {
    SpeechFeed feed;
    (void)feed.write(ones(4000));
    (void)read(feed, 1000);
    const auto fading = read(feed, 10000, true);
    EXPECT_EQ(fading.back(), 0.0F);
    EXPECT_LE(4000U - 1000U - feed.waiting(), 241U);
    const std::size_t left = feed.waiting();
    const auto resumed = read(feed, left);
    EXPECT_LT(resumed.front(), 0.01F);
    EXPECT_EQ(resumed.back(), 1.0F);
    EXPECT_EQ(feed.waiting(), 0U);
}

TEST(SpeechFeed, NothingSoundsInAPauseThatBeganWhileTheVoiceWasLate) {
    SpeechFeed feed;
    (void)feed.write(ones(1000));
    (void)read(feed, 1000);
    (void)read(feed, 1000, true);  // the whole fade passes without anything to fade
    (void)feed.write(ones(1000));
    EXPECT_EQ(read(feed, 1000, true), std::vector<float>(1000, 0.0F));
    EXPECT_EQ(feed.waiting(), 1000U);
}

TEST(SpeechFeed, WhatIsCutWhilePausedIsNeverHeard) {
    SpeechFeed feed;
    (void)feed.write(ones(4000));
    (void)read(feed, 1000, true);
    feed.cut();
    (void)read(feed, 1000, true);
    EXPECT_EQ(feed.waiting(), 0U);
    for (const float sample : read(feed, 1000)) ASSERT_EQ(sample, 0.0F);
}

}  // namespace
}  // namespace touchline
