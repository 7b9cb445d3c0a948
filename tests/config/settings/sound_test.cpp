#include "config/settings/sound.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

std::string sound_error(const std::string& text) {
    const auto sound = parse_sound(text, "sound.toml");
    return sound ? "no error" : sound.error().line;
}

std::string installed_text() {
    std::ifstream in(TOUCHLINE_SOURCE_DIR "/config/defaults/sound.toml");
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(SoundSettings, TheInstalledFileSaysWhatTheProgramAssumes) {
    const auto sound = parse_sound(installed_text(), "sound.toml");
    ASSERT_TRUE(sound) << sound.error().line;
    EXPECT_EQ(*sound, SoundSettings{});
    EXPECT_EQ(parse_sound("", "sound.toml").value(), SoundSettings{});
}

TEST(SoundSettings, TheInstalledFileExplainsEverySetting) {
    const std::string text = installed_text();
    for (const LevelSetting& setting : level_settings()) {
        EXPECT_NE(text.find(std::string(setting.key) + " = "), std::string::npos) << setting.key;
        EXPECT_NE(text.find(std::string("# ") + std::string(setting.meaning)), std::string::npos)
            << setting.meaning;
    }
}

TEST(SoundSettings, VO3_HeadsetAndSpeakerAreSetApart) {
    const auto sound = parse_sound(
        "assumed_output = 'speaker'\n[headset]\ncap_dB = 90\nmono = true\n[speaker]\ncap_dB = 85.5",
        "f");
    ASSERT_TRUE(sound) << sound.error().line;
    EXPECT_EQ(sound->headset.cap_dB, 90.0);
    EXPECT_TRUE(sound->headset.is_mono);
    EXPECT_EQ(sound->speaker.cap_dB, 85.5);
    EXPECT_FALSE(sound->speaker.is_mono);
    EXPECT_EQ(sound->speaker.kind, OutputKind::speaker);
    EXPECT_EQ(sound->assumed, OutputKind::speaker);
}

TEST(SoundSettings, WhatIsWrittenIsReadBack) {
    SoundSettings sound;
    sound.assumed = OutputKind::speaker;
    sound.headset.full_scale_dB = 112.34567890123457;
    sound.headset.is_mono = true;
    sound.speaker.ambient_dB = 55.0;
    EXPECT_EQ(parse_sound(sound_text(sound), "f").value(), sound);
}

TEST(SoundSettings, WhateverIsWrongIsOneLineWithItsPlace) {
    EXPECT_EQ(sound_error("\nvolume = 3"), "sound.toml:2: 'volume' is not a setting here");
    EXPECT_EQ(sound_error("[headset]\nvolume = 3"), "sound.toml:2: 'volume' is not a setting here");
    EXPECT_EQ(sound_error("headset = 3"), "sound.toml:1: an output is a table, like [headset]");
    EXPECT_EQ(sound_error("[speaker]\nmono = 1"), "sound.toml:2: 'mono' must be true or false");
    for (const char* value : {"'tin can'", "1", "true", "[]"}) {
        EXPECT_EQ(sound_error(std::string("assumed_output = ") + value),
                  "sound.toml:1: 'assumed_output' must be \"headset\" or \"speaker\"")
            << value;
    }
    for (const char* value : {"106", "-1", "nan", "inf", "'loud'", "true", "[90]"}) {
        EXPECT_EQ(sound_error(std::string("[headset]\n\ncap_dB = ") + value),
                  "sound.toml:3: 'cap_dB' must be a number from 60 to 105, in dB")
            << value;
    }
    const std::string line = sound_error("[headset");
    EXPECT_TRUE(line.starts_with("sound.toml:1: ")) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
}

TEST(SoundSettings, VO4_ARoomTooLoudForTheVolumeIsOneLine) {
    EXPECT_EQ(sound_error("\n[headset]\nambient_dB = 61"),
              "sound.toml:2: In a room of more than 45 dB the volume reaches 20 dB above it.");
    EXPECT_EQ(sound_error("[headset]\nambient_dB = 60"), "no error");
    EXPECT_EQ(sound_error("[headset]\nambient_dB = 61\nloudest_dB = 85"), "no error");
}

TEST(SoundSettings, EveryLevelStaysFiniteAndInItsBounds) {
    for (const LevelSetting& setting : level_settings()) {
        const std::string key = "[speaker]\n" + std::string(setting.key) + " = ";
        for (const double wrong : {setting.least_dB - 0.5, setting.most_dB + 0.5}) {
            EXPECT_NE(sound_error(key + std::to_string(wrong)).find("must be a number from"),
                      std::string::npos)
                << setting.key << ' ' << wrong;
        }
        OutputProfile profile = default_output(OutputKind::speaker);
        profile.*setting.level_dB = std::numeric_limits<double>::quiet_NaN();
        EXPECT_FALSE(check(profile)) << setting.key;
    }
}

TEST(SoundSettings, AFileThatCannotBeUsedIsNamed) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("touchline-sound-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    EXPECT_EQ(read_sound(folder / "none").error().line,
              "cannot read " + (folder / "none").string());
    std::ofstream(folder / "large") << std::string((1 << 20) + 1, ' ');
    EXPECT_EQ(read_sound(folder / "large").error().line,
              (folder / "large").string() + " is larger than 1 MB");
    std::ofstream(folder / "good") << "[headset]\ncap_dB = 90";
    EXPECT_EQ(read_sound(folder / "good")->headset.cap_dB, 90.0);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace touchline
