#include "app/sound/sound_choice.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

const SoundSettings settings;

Languages all_languages() {
    Languages languages{Language()};
    for (const char* code : {"de", "es", "fr"})
        languages.push_back(Language::load(TOUCHLINE_CATALOGUES, code).value());
    return languages;
}

SoundStep press(const SoundChoice& choice, Action action) {
    static const Languages languages = all_languages();
    return press_sound_key(choice, action, settings, languages);
}

TEST(SoundChoice, VO2_EverySessionBeginsWithTheOperatorsVolume) {
    for (const OutputKind kind : {OutputKind::headset, OutputKind::speaker}) {
        const SoundChoice choice = first_choice(kind, settings);
        const OutputProfile& profile = profile_of(kind, settings);
        EXPECT_EQ(level_dB_of(profile, choice.volume), profile.default_dB);
        EXPECT_LE(level_dB_of(profile, choice.volume), 65.0);
        EXPECT_EQ(choice.rate, default_speech_rate);
        EXPECT_EQ(choice.amount, CueAmount::cues);
    }
}

TEST(SoundChoice, VO1_EveryStepOfVolumeIsSaidAndSoAreItsEnds) {
    SoundChoice choice = first_choice(OutputKind::headset, settings);
    const auto steps = volume_steps(settings.headset);
    std::vector<std::string> said;
    for (std::size_t i = 0; i < steps; ++i) {
        const SoundStep step = press(choice, Action::louder_sound);
        choice = step.choice;
        said.push_back(step.said);
    }
    EXPECT_EQ(said.front(), "Volume 5 of 7");
    EXPECT_EQ(said.back(), "This is the loudest.");
    EXPECT_EQ(choice.volume, steps - 1);
    for (std::size_t i = 0; i < steps; ++i) choice = press(choice, Action::softer_sound).choice;
    EXPECT_EQ(choice.volume, 0U);
    EXPECT_EQ(press(choice, Action::softer_sound).said, "This is the softest.");
}

TEST(SoundChoice, SP6_EveryRateIsSaidAndSoAreItsEnds) {
    SoundChoice choice = first_choice(OutputKind::headset, settings);
    const SoundStep faster = press(choice, Action::faster_speech);
    EXPECT_EQ(faster.said, "Speech rate 5 of 7");
    EXPECT_EQ(faster.choice.rate, choice.rate + 1);
    for (int i = 0; i < 9; ++i) choice = press(choice, Action::faster_speech).choice;
    EXPECT_EQ(choice.rate, 6U);
    EXPECT_EQ(press(choice, Action::faster_speech).said, "This is the fastest.");
    for (int i = 0; i < 9; ++i) choice = press(choice, Action::slower_speech).choice;
    EXPECT_EQ(choice.rate, 0U);
    EXPECT_EQ(press(choice, Action::slower_speech).said, "This is the slowest.");
}

TEST(SoundChoice, OneKeyGoesRoundNoneCuesAndFull) {
    SoundChoice choice = first_choice(OutputKind::headset, settings);
    std::vector<std::string> said;
    for (int i = 0; i < 3; ++i) {
        const SoundStep step = press(choice, Action::next_sounds);
        choice = step.choice;
        said.push_back(step.said);
    }
    EXPECT_EQ(said,
              (std::vector<std::string>{"Sounds: all", "Sounds: none", "Sounds: short ones"}));
}

TEST(SoundChoice, ALanguageNamesItselfAndAllElseIsSaidInIt) {
    SoundChoice choice = first_choice(OutputKind::headset, settings);
    std::vector<std::string> names;
    for (int i = 0; i < 4; ++i) {
        const SoundStep step = press(choice, Action::next_language);
        choice = step.choice;
        names.push_back(step.said);
        if (i == 0) {
            EXPECT_EQ(press(choice, Action::louder_sound).said, "Lautstärke 5 von 7");
        }
    }
    EXPECT_EQ(names, (std::vector<std::string>{"Deutsch", "Español", "Français", "English"}));
}

TEST(SoundChoice, SpeechKeysAreActsAndChangeNothing) {
    const SoundChoice choice = first_choice(OutputKind::speaker, settings);
    for (const auto& [action, act] : {std::pair(Action::repeat_speech, SpeechAct::repeat),
                                      std::pair(Action::stop_speech, SpeechAct::stop),
                                      std::pair(Action::pause_speech, SpeechAct::pause),
                                      std::pair(Action::next_picture, SpeechAct::none)}) {
        const SoundStep step = press(choice, action);
        EXPECT_EQ(step.act, act);
        EXPECT_EQ(step.choice, choice);
        EXPECT_EQ(step.said, "");
    }
}

TEST(SoundChoice, VO5_AnotherOutputStopsSpeechAndBeginsWithItsOwnVolume) {
    static const Languages languages = all_languages();
    SoundChoice choice = first_choice(OutputKind::headset, settings);
    choice.volume = 6;
    const SoundStep out = change_output(choice, OutputKind::speaker, settings, languages);
    EXPECT_EQ(out.act, SpeechAct::stop);
    EXPECT_EQ(out.said, "The headphones are out.");
    EXPECT_EQ(level_dB_of(settings.speaker, out.choice.volume), settings.speaker.default_dB);
    const SoundStep in = change_output(out.choice, OutputKind::headset, settings, languages);
    EXPECT_EQ(in.said, "The headphones are in.");
    EXPECT_EQ(level_dB_of(settings.headset, in.choice.volume), settings.headset.default_dB);
    const SoundStep same = change_output(in.choice, OutputKind::headset, settings, languages);
    EXPECT_EQ(same.act, SpeechAct::none);
    EXPECT_EQ(same.choice, in.choice);
}

RC_GTEST_PROP(SoundChoice, AnyKeysInAnyOrderKeepEveryStepInItsBounds, ()) {
    const auto keys = *rc::gen::container<std::vector<int>>(
        rc::gen::inRange(0, static_cast<int>(Action::quit) + 1));
    SoundChoice choice = first_choice(OutputKind::speaker, settings);
    for (const int key : keys) choice = press(choice, static_cast<Action>(key)).choice;
    RC_ASSERT(choice.volume < volume_steps(settings.speaker));
    RC_ASSERT(choice.rate < speech_rates_per_minute.size());
    RC_ASSERT(choice.language < 4U);
}

}  // namespace
}  // namespace touchline
