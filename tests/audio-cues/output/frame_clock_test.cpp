#include "audio-cues/output/sound_output.h"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::int64_t ms = 1'000'000;

TEST(FrameClock, IsNowBeforeAnythingWasTold) {
    EXPECT_EQ(FrameClock().frame_at(123456 * ms), 0);
}

TEST(FrameClock, KeepsTheTimesBetweenSoundsThoughTheDeviceAsksInBursts) {
    FrameClock clock;
    unsigned state = 1;
    FrameTime frame = 0;
    for (int block = 0; block < 4000; ++block) {
        state = state * 1664525U + 1013904223U;
        const std::int64_t jitter_ns = state % 4'000'000U;
        clock.told(frame, 5000 * ms + frame * 1'000'000'000 / 48000 + jitter_ns);
        frame += block_frames;
        if (block < 200) continue;
        const std::int64_t now_ns = 5000 * ms + frame * 1'000'000'000 / 48000;
        const auto late_frames = clock.frame_at(now_ns) - frame;
        // The lead, less the mean of the jitter (2 ms, 96 frames), give or take half a ms.
        EXPECT_NEAR(static_cast<double>(late_frames), FrameClock::lead_frames - 96.0, 24.0);
    }
}

TEST(FrameClock, FollowsADeviceWhoseSecondIsNotOurs) {
    FrameClock clock;
    for (FrameTime frame = 0; frame < FrameTime{48000} * 3600; frame += 48000 / 100) {
        // Faster by 200 parts in a million.
        clock.told(frame,
                   static_cast<std::int64_t>(static_cast<double>(frame) / 48000.0 * 1e9 / 1.0002));
    }
    const std::int64_t end_ns = static_cast<std::int64_t>(3600.0 * 1e9 / 1.0002);
    EXPECT_NEAR(static_cast<double>(clock.frame_at(end_ns)),
                3600.0 * 48000.0 + FrameClock::lead_frames, 48.0);
}

TEST(FrameClock, AfterAStandstillItBeginsAnew) {
    FrameClock clock;
    clock.told(0, 0);
    clock.told(480, 5010 * ms);
    EXPECT_EQ(clock.frame_at(5010 * ms), 480 + FrameClock::lead_frames);
}

TEST(FrameClock, IsExactAfterYears) {
    FrameClock clock;
    const FrameTime years = FrameTime{48000} * 86400 * 365 * 10;
    clock.told(years, 7 * ms);
    EXPECT_EQ(clock.frame_at(7 * ms), years + FrameClock::lead_frames);
}

}  // namespace
}  // namespace touchline
