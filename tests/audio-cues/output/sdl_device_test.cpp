#include "audio-cues/output/sound_output.h"
#include "audio-cues/synth/mixer.h"
#include "tests/audio-cues/spectrum.h"
#include "tests/config/scratch_folder.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <poll.h>

namespace touchline {
namespace {

/// Waits until the device asked for `count` frames; if it never asks, the test times out.
void wait_for(const std::atomic<std::size_t>& asked, std::size_t count) {
    while (asked < count) (void)poll(nullptr, 0, 1);
}

TEST(SdlDevice, TheDummyDriverAsksForBlocksUntilItIsClosed) {
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    SdlDevice device;
    std::atomic<std::size_t> asked{0};
    std::atomic<std::size_t> largest{0};
    const auto opened = device.open(
        [&](std::span<StereoFrame> frames) {
            asked += frames.size();
            largest = std::max<std::size_t>(largest.load(), frames.size());
        },
        block_frames);
    ASSERT_TRUE(opened) << opened.error().line;
    wait_for(asked, 1000);
    EXPECT_FALSE(device.is_gone());
    device.close();
    const std::size_t at_close = asked;
    (void)poll(nullptr, 0, 20);
    EXPECT_EQ(asked, at_close);
    EXPECT_EQ(largest, static_cast<std::size_t>(block_frames));
    device.close();
    const auto long_blocks = device.open(
        [&](std::span<StereoFrame> frames) {
            asked += frames.size();
            largest = std::max<std::size_t>(largest.load(), frames.size());
        },
        resting_block_frames);
    ASSERT_TRUE(long_blocks);
    wait_for(asked, at_close + 1000);
    device.close();
    EXPECT_EQ(largest, static_cast<std::size_t>(resting_block_frames));
}

TEST(SdlDevice, TheDiskDriverHoldsTheMixersSamplesBitForBit) {
    const ScratchFolder scratch;
    const std::string folder = scratch.path();
    const std::string path = folder + "/out.raw";
    setenv("SDL_AUDIODRIVER", "disk", 1);
    setenv("SDL_DISKAUDIOFILE", path.c_str(), 1);
    setenv("SDL_DISKAUDIODELAY", "0", 1);
    const auto tone = SetContinuous{{.frequency_Hz = 440.0, .level = 0.5, .pan = 0.7}};
    Mixer mixer;
    mixer.send({1000, tone});
    std::atomic<std::size_t> asked{0};
    {
        SdlDevice device;
        const auto opened = device.open(
            [&](std::span<StereoFrame> frames) {
                mixer.render(frames);
                asked += frames.size();
            },
            block_frames);
        ASSERT_TRUE(opened) << opened.error().line;
        wait_for(asked, 20000);
    }
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::vector<StereoFrame> played(bytes.size() / sizeof(StereoFrame));
    std::memcpy(played.data(), bytes.data(), played.size() * sizeof(StereoFrame));
    Mixer other;
    other.send({1000, tone});
    const auto expected = rendered(other, 16000);
    // The driver may write silence first.
    const auto sound = first_sound(right_of_stereo(played));
    const auto begin = first_sound(right_of_stereo(expected));
    ASSERT_GE(sound, begin);
    ASSERT_GE(played.size(), sound - begin + expected.size());
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(),
                           played.begin() + static_cast<std::ptrdiff_t>(sound - begin)));
}

TEST(SdlDevice, WithoutAnyDriverItIsOneClearLine) {
    setenv("SDL_AUDIODRIVER", "none-of-them", 1);
    SdlDevice device;
    const auto opened = device.open([](std::span<StereoFrame>) {}, block_frames);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().line.find('\n'), std::string::npos);
    EXPECT_FALSE(device.is_gone());
}

}  // namespace
}  // namespace touchline
