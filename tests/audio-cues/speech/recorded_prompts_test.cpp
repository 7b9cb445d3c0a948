#include "audio-cues/speech/recorded_prompts.h"

#include "tests/audio-cues/wav_bytes.h"
#include "tests/config/scratch_folder.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Wav, ReadsMonoAndMixesStereoDown) {
    EXPECT_EQ(decode_wav(wav_bytes(48000, 1, {32767, -32767, 0})).value(),
              (std::vector<float>{1.0F, -1.0F, 0.0F}));
    EXPECT_EQ(decode_wav(wav_bytes(48000, 2, {32767, -32767, 32767, 32767})).value(),
              (std::vector<float>{0.0F, 1.0F}));
    EXPECT_NEAR(
        static_cast<double>(decode_wav(wav_bytes(22050, 1, std::vector<int>(2205, 100)))->size()),
        4800.0, 2.0);
}

TEST(Wav, WhatItDoesNotKnowOrIsCutShortIsOneLine) {
    const std::string good = wav_bytes(48000, 1, {1, 2, 3});
    for (std::size_t size = 0; size < good.size(); ++size) {
        EXPECT_FALSE(decode_wav(std::span(good).first(size))) << size;
    }
    EXPECT_FALSE(decode_wav(wav_bytes(44100, 1, {1})));
    EXPECT_FALSE(decode_wav(wav_bytes(48000, 3, {1, 2, 3})));
    EXPECT_FALSE(decode_wav(wav_bytes(22050, 1, std::vector<int>(61 * 22050, 0))));
}

TEST(RecordedPrompts, SP8_ReplaceATextOfTheirLanguageAndMissingOnesAreLeftToTheVoice) {
    const ScratchFolder scratch;
    const std::string folder = scratch.path();
    std::filesystem::create_directory(folder + "/de");
    std::ofstream(folder + "/de/welcome.wav") << wav_bytes(48000, 1, {32767, 0});
    std::ofstream(folder + "/de/broken.wav") << "RIFF";
    std::ofstream(folder + "/de/index.txt")
        << "welcome.wav\tGuten Tag.\nbroken.wav\tKaputt.\n"
           "missing.wav\tFehlt.\n../welcome.wav\tFremd.\nno tab\n";
    std::vector<std::string> problems;
    const RecordedPrompts prompts = RecordedPrompts::read(folder, problems);
    EXPECT_EQ(prompts.size(), 1U);
    EXPECT_EQ(problems.size(), 4U);
    const auto* samples = prompts.of({"de", "Guten Tag."});
    ASSERT_NE(samples, nullptr);
    EXPECT_EQ(*samples, (std::vector<float>{1.0F, 0.0F}));
    EXPECT_EQ(prompts.of({"fr", "Guten Tag."}), nullptr);
    EXPECT_EQ(prompts.of({"de", "Kaputt."}), nullptr);
    std::filesystem::remove_all(folder);
    EXPECT_EQ(RecordedPrompts::read(folder, problems).size(), 0U);
}

}  // namespace
}  // namespace touchline
