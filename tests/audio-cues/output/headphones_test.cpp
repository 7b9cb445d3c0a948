#include "audio-cues/output/outputs.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Headphones, TheSurestSourceThatKnowsDecides) {
    constexpr std::array<std::optional<bool>, 3> said{std::nullopt, false, true};
    for (const auto keypad : said) {
        for (const auto input : said) {
            for (const auto jack : said) {
                const auto expected = keypad ? keypad : input ? input : jack;
                EXPECT_EQ(are_headphones_in(HeadphoneReports{keypad, input, jack}), expected);
            }
        }
    }
}

TEST(Headphones, VO5_InIsTheHeadsetOutIsTheSpeakerAndUnknownIsWhatTheOperatorAssumes) {
    SoundSettings settings;
    for (const OutputKind assumed : {OutputKind::headset, OutputKind::speaker}) {
        settings.assumed = assumed;
        EXPECT_EQ(output_kind(true, settings), OutputKind::headset);
        EXPECT_EQ(output_kind(false, settings), OutputKind::speaker);
        EXPECT_EQ(output_kind(std::nullopt, settings), assumed);
    }
    EXPECT_EQ(&profile_of(OutputKind::headset, settings), &settings.headset);
    EXPECT_EQ(&profile_of(OutputKind::speaker, settings), &settings.speaker);
}

TEST(JackControl, KnowsTheNamesOfHeadphoneJacks) {
    for (const char* name : {"Headphone Jack", "Front Headphone Jack", "Headphone Mic Jack",
                             "Headset Jack", "HP/Headphone Jack"}) {
        EXPECT_TRUE(is_headphone_jack(name)) << name;
    }
    for (const char* name : {"", "Jack", "Headphone", "Headphone Playback Switch", "Mic Jack",
                             "Headset Mic Jack", "Headset Mic Phantom Jack", "Line Out Jack",
                             "Headphone Phantom Jack", "HDMI/DP,pcm=3 Jack", "Headphone Jack "}) {
        EXPECT_FALSE(is_headphone_jack(name)) << name;
    }
}

using Switches = std::vector<CardSwitch>;

TEST(JackControl, OneJackOfSeveralIsEnough) {
    EXPECT_EQ(are_headphones_in(Switches{}), std::nullopt);
    EXPECT_EQ(are_headphones_in(Switches{{"Mic Jack", true}}), std::nullopt);
    EXPECT_EQ(are_headphones_in(Switches{{"Headphone Jack", false}}), false);
    EXPECT_EQ(
        are_headphones_in(Switches{{"Front Headphone Jack", true}, {"Headphone Jack", false}}),
        true);
    EXPECT_EQ(are_headphones_in(Switches{{"Headphone Jack", false}, {"Mic Jack", true}}), false);
}

TEST(JackControl, AsksFourTimesASecondAndTellsWhatItHeardLast) {
    int asked = 0;
    std::vector<CardSwitch> switches;
    JackControl jack([&] {
        ++asked;
        return switches;
    });
    EXPECT_EQ(jack.are_in(0.0), std::nullopt);
    switches = {{"Headphone Jack", true}};
    for (int i = 1; i < 15; ++i) EXPECT_EQ(jack.are_in(i / 60.0), std::nullopt);
    EXPECT_EQ(jack.are_in(0.26), true);
    switches.clear();  // the USB headset was unplugged
    EXPECT_EQ(jack.are_in(0.52), std::nullopt);
    EXPECT_EQ(asked, 3);
}

/// This works with any cards this machine has, or none.
TEST(JackControl, TheCardsOfThisMachineCanBeAsked) {
    for (const CardSwitch& found : card_switches()) EXPECT_TRUE(is_headphone_jack(found.name));
    JackControl jack;
    EXPECT_EQ(jack.are_in(0.0), are_headphones_in(card_switches()));
}

}  // namespace
}  // namespace touchline
