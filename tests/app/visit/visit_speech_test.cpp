// Tests what is heard, at the level of the visit: SP, VO, LA and VI of the requirements.
#include "audio-cues/speech/speech_input.h"
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <algorithm>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::size_t words_in(const std::string& text) {
    std::istringstream stream(text);
    std::size_t count = 0;
    for (std::string word; stream >> word;) ++count;
    return count;
}

TEST(Visit, SP1_AnythingBeginsAVisitWithSpeech) {
    HandleSeen moved;
    moved.has_moved = true;
    const std::vector<VisitEvent> beginnings{
        KeyPressed{KeyRole::help},          KeyPressed{KeyRole::softer}, DeadKeyPressed{}, moved,
        SpeechKeyPressed{SpeechKey::pause}, HeadphonesChanged{true}};
    for (const VisitEvent& beginning : beginnings) {
        FakeHouse house;
        house.wait(5.0);
        EXPECT_TRUE(house.transcript.empty()) << "quiet while nobody is here";
        house.apply(beginning);
        EXPECT_FALSE(house.last<Utterance>().empty()) << beginning.index();
        EXPECT_EQ(house.open(), VisitScreen::language);
    }
}

TEST(Visit, SP1_AHandleThatIsOnlySeenBeginsNothing) {
    FakeHouse house;
    house.apply(HandleSeen{});
    EXPECT_EQ(house.open(), VisitScreen::attract);
}

TEST(Visit, SP2_TheFirstWordsTakeTwelveSecondsAtMost) {
    for (std::size_t language = 0; language < all_languages().size(); ++language) {
        VisitRules rules;
        rules.sound.language = language;
        FakeHouse house(rules);
        house.press(KeyRole::select);
        ASSERT_EQ(house.transcript.size(), 1U);
        const std::string text = house.transcript[0].text;
        const double seconds = 60.0 * static_cast<double>(words_in(text)) /
                               speech_rates_per_minute[default_speech_rate];
        EXPECT_LE(seconds, 12.0) << text;
        const Language& spoken = all_languages()[language];
        for (const char* said : {"Press Help to try the keys.", "Press any key to interrupt."}) {
            EXPECT_NE(text.find(spoken.text("visit", said)), std::string::npos) << text;
        }
        EXPECT_EQ(house.transcript[0].language, spoken.code());
    }
}

TEST(Visit, SP3_EverythingShownHasWordsInEveryLanguage) {
    FakeHouse house;
    std::set<VisitScreen> shown;
    for (const Visit& visit : scenes_of_all_screens()) {
        for (std::size_t language = 0; language < all_languages().size(); ++language) {
            Visit there = visit;
            there.visitor.sound.language = language;
            const SpokenScreen screen = screen_of(there, house.world());
            shown.insert(open_screen(there));
            EXPECT_FALSE(screen.title.empty());
            EXPECT_FALSE(spoken_screen(screen, all_languages()[language]).empty());
            for (const ScreenItem& item : screen.items) {
                EXPECT_FALSE(item.name.empty());
                EXPECT_FALSE(item.hint.empty()) << item.name;
                const bool has_value =
                    item.role == ItemRole::setting || item.role == ItemRole::toggle;
                EXPECT_TRUE(!has_value || !item.value.empty()) << item.name;
            }
        }
    }
    EXPECT_EQ(shown.size(), visit_screen_count);
}

TEST(Visit, SP5_RepeatRepeatsTheLastWordsThenTheWholeScreen) {
    FakeHouse house;
    house.press({KeyRole::select, KeyRole::select, KeyRole::down});
    const std::string last = house.last_said();
    house.press(KeyRole::repeat);
    EXPECT_EQ(house.last_said(), last);
    const std::string whole =
        spoken_screen(house.screen(), Language()) + ". The easiest come first.";
    house.press(KeyRole::repeat);
    EXPECT_EQ(house.last_said(), whole);
    house.press(KeyRole::repeat);
    EXPECT_EQ(house.last_said(), whole);
    house.press({KeyRole::down, KeyRole::repeat});
    EXPECT_TRUE(house.last_said().starts_with("Your USB stick")) << "the item alone";
}

TEST(Visit, SP5_PauseNeitherStopsNorSpeaks) {
    FakeHouse house;
    house.press({KeyRole::select, KeyRole::select});
    house.apply(SpeechKeyPressed{SpeechKey::pause});
    EXPECT_EQ(house.last<HoldSpeech>().size(), 1U);
    EXPECT_TRUE(house.last<Hush>().empty());
    EXPECT_TRUE(house.last<Utterance>().empty());
    EXPECT_FALSE(house.last<GiveCue>().empty());
}

TEST(Visit, SP4_EveryOtherKeyStopsSpeech) {
    FakeHouse house;
    for (std::size_t role = 0; role < key_role_count; ++role) {
        house.press(static_cast<KeyRole>(role));
        ASSERT_FALSE(house.orders.empty());
        EXPECT_FALSE(house.last<Hush>().empty()) << role;
    }
    house.apply(DeadKeyPressed{});
    EXPECT_EQ(house.last<Hush>().size(), 1U);
}

TEST(Visit, SP6_SpeechRateIsSaidAndEndsAreToo) {
    FakeHouse house;
    house.press({KeyRole::select, KeyRole::select});
    for (std::size_t rate = default_speech_rate + 1; rate < 7; ++rate) {
        house.apply(SpeechKeyPressed{SpeechKey::faster});
        EXPECT_EQ(house.last_said(), "Speaking speed " + std::to_string(rate + 1) + " of 7");
        ASSERT_EQ(house.last<SoundWanted>().size(), 1U);
        EXPECT_EQ(house.last<SoundWanted>()[0].rate, rate);
    }
    house.apply(SpeechKeyPressed{SpeechKey::faster});
    EXPECT_EQ(house.last_said(), "This is the fastest.");
    EXPECT_TRUE(house.last<SoundWanted>().empty());
}

TEST(Visit, SP7_PlaceAndRoleAreSaidAndAHintAfterAPause) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Settings"));
    house.press(KeyRole::up);  // Back
    house.press(KeyRole::down);
    EXPECT_EQ(house.last_said(), "Volume, Step 4, setting, 1 of 12");
    const std::size_t before = house.transcript.size();
    house.wait(1.4);
    EXPECT_EQ(house.transcript.size(), before);
    house.wait(0.2);
    ASSERT_EQ(house.transcript.size(), before + 1);
    EXPECT_EQ(house.transcript.back().text, "Press Select to change it.");
    EXPECT_EQ(house.transcript.back().priority, SpeechPriority::hint);
    house.wait(20.0);
    EXPECT_EQ(house.transcript.size(), before + 1) << "once";
}

TEST(Visit, AHintThatWasJustSaidWaits) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Settings"));
    house.wait(2.0);
    house.press(KeyRole::down);
    const std::size_t before = house.transcript.size();
    house.wait(27.0);
    EXPECT_EQ(house.transcript.size(), before) << "it is the same as of the item before";
    house.wait(3.0);
    ASSERT_EQ(house.transcript.size(), before + 1);
    EXPECT_EQ(house.transcript.back().text, "Press Select to change it.");
}

TEST(Visit, AHintIsKnownAfterTwoTimes) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Settings"));
    const std::string hint = "Press Select to change it.";
    int times = 0;
    for (int i = 0; i < 4; ++i) {
        const std::size_t before = house.transcript.size();
        house.wait(40.0);
        if (house.has_said(hint, before)) ++times;
        house.press(KeyRole::down);
    }
    EXPECT_EQ(times, 2);
    house.press({KeyRole::repeat, KeyRole::repeat});
    EXPECT_TRUE(house.last_said().ends_with(hint)) << "to whoever asks for the whole screen";
    ASSERT_TRUE(house.choose("Start over"));
    ASSERT_TRUE(house.choose("Yes"));
    house.press(KeyRole::select);
    ASSERT_TRUE(house.choose("Settings"));
    const std::size_t before = house.transcript.size();
    house.wait(2.0);
    EXPECT_TRUE(house.has_said(hint, before)) << "another visitor has not heard it";
}

/// "Parts say their names" was said to whoever came back from there.
TEST(Visit, WhoHasChosenAnItemKnowsItsHint) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Explore freely"));
    house.press(KeyRole::back);
    ASSERT_TRUE(house.last_said().ends_with("Explore freely, 3 of 13")) << house.last_said();
    const std::size_t before = house.transcript.size();
    house.wait(40.0);
    EXPECT_EQ(house.transcript.size(), before) << house.last_said();
    house.press({KeyRole::repeat, KeyRole::repeat});
    EXPECT_TRUE(house.last_said().ends_with("Parts say their names."));
}

/// The items of that screen are languages, and their hint is another one.
TEST(Visit, WhoHasChosenALanguageHasNotHeardHowToChoose) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.find("Call staff"));
    house.wait(2.0);
    EXPECT_EQ(house.last_said(), "Press Select to choose this, Up or Down to move.");
}

TEST(Visit, NobodyIsSentOnFromTheOnlyItem) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Your USB stick"));
    house.wait(2.0);
    EXPECT_EQ(house.last_said(), "Press Select to go back.");
}

TEST(Visit, WithTwoSwitchesNobodyIsToldOfKeysThatAreNotThere) {
    FakeHouse house;
    house.settings.two_switches = SwitchUse::move_and_select;
    house.press(KeyRole::select);
    EXPECT_TRUE(house.last_said().starts_with(
        "Pictures to feel. One switch moves on, the other is Select. After the last come"));
    house.wait(3.0);
    EXPECT_TRUE(house.has_said("weiterschalten", 0)) << "to each in its own language";
    house.press({KeyRole::select, KeyRole::help});
    EXPECT_TRUE(house.last_said().starts_with("Help. Move on to Repeat, Back or Help."));
    EXPECT_TRUE(house.last_said().ends_with(
        "Choose Back twice to leave. Choose Help again to call the staff."));
    house.press(KeyRole::repeat);
    EXPECT_TRUE(house.last_said().ends_with("Choose it twice for the whole screen."));
    house.press({KeyRole::back, KeyRole::back});
    EXPECT_EQ(house.open(), VisitScreen::choose);
    house.apply(TroubleBegan{TroubleKind::device, ""});
    EXPECT_TRUE(house.last_said().ends_with(
        "Move on to call staff. Or press Select to go on without force."));
}

TEST(Visit, WithOneSwitchNobodyIsToldToMoveOn) {
    FakeHouse house;
    house.settings.two_switches = SwitchUse::by_itself;
    house.press(KeyRole::select);
    EXPECT_TRUE(house.has_said("Choices are read out in turn; your switch is Select.", 0));
    const std::size_t before = house.transcript.size();
    house.wait(3.0);
    EXPECT_FALSE(house.has_said("Deutsch:", before)) << "the list itself comes to it";
    house.press(KeyRole::select);
    house.wait(3.0);
    house.press({KeyRole::up, KeyRole::up});
    ASSERT_TRUE(house.last_said().starts_with("Call staff"));
    house.wait(3.0);
    EXPECT_EQ(house.last_said(), "Press Select to choose this.");
    house.press(KeyRole::help);
    EXPECT_TRUE(house.has_said("Repeat, Back and Help come by themselves.", 0));
    house.press({KeyRole::back, KeyRole::back});
    house.apply(TroubleBegan{TroubleKind::device, ""});
    EXPECT_TRUE(house.last_said().ends_with(
        "Call staff comes next. Or press Select to go on without force."));
    EXPECT_FALSE(house.has_said("ove on ", 0));
}

TEST(Visit, WhoTurnsSpeechOffHearsHowItComesBack) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Settings"));
    ASSERT_TRUE(house.choose("Speech"));
    EXPECT_FALSE(house.visit.visitor.sound.is_speech_on);
    EXPECT_EQ(house.last_said(), "Speech is off. Press Help to turn it on again.");
    EXPECT_TRUE(std::holds_alternative<SoundWanted>(house.orders.back())) << "it is said before";
    EXPECT_EQ(house.last<SoundWanted>().size(), 1U);
    house.press(KeyRole::help);
    EXPECT_EQ(house.last_said(), "Speech is on. Settings. Speech, on, setting, 6 of 12");
}

/// The spoken words include the hint.
TEST(Visit, AnErrorSaysWhatToPressOnce) {
    FakeHouse house;
    to_choose(house);
    house.apply(TroubleBegan{TroubleKind::camera, ""});
    const std::size_t before = house.transcript.size();
    house.wait(30.0);
    EXPECT_EQ(house.transcript.size(), before);
}

TEST(Visit, SP9_EachKeyGivesASoundADeadOneAnotherAndTheThirdTimeWords) {
    FakeHouse house;
    to_choose(house);
    house.press(KeyRole::down);
    ASSERT_FALSE(house.last<GiveCue>().empty());
    EXPECT_EQ(house.last<GiveCue>()[0].event, ScreenEvent::key_taken);
    for (int press = 1; press <= 6; ++press) {
        house.apply(DeadKeyPressed{});
        ASSERT_EQ(house.last<GiveCue>().size(), 1U);
        EXPECT_EQ(house.last<GiveCue>()[0].event, ScreenEvent::key_refused);
        EXPECT_EQ(house.last<Utterance>().empty(), press % 3 != 0) << press;
    }
    EXPECT_EQ(house.last_said(), "This key has no use. Press Help to try the keys.");
}

TEST(Visit, SP10_WhatWasSaidCanBeAskedAgain) {
    FakeHouse house;
    to_picture(house);
    const std::string told = house.last_said();
    house.wait(60.0);
    house.press(KeyRole::repeat);
    EXPECT_EQ(house.last_said(), told);
    ASSERT_TRUE(house.choose("Tell me again"));
    EXPECT_NE(house.last_said().find("its head to the left"), std::string::npos);
}

TEST(Visit, VO1_VolumeKeysWorkEverywhereAndEndsAreSaid) {
    FakeHouse house;
    to_picture(house);
    for (std::size_t volume = house.visit.visitor.sound.volume + 1; volume < 7; ++volume) {
        house.press(KeyRole::louder);
        EXPECT_EQ(house.last_said(), "Volume " + std::to_string(volume + 1) + " of 7");
        EXPECT_TRUE(std::holds_alternative<SoundWanted>(house.orders.front()))
            << "the sample is heard at the new volume";
    }
    house.press(KeyRole::louder);
    EXPECT_EQ(house.last_said(), "This is the loudest.");
    for (int i = 0; i < 7; ++i) house.press(KeyRole::softer);
    EXPECT_EQ(house.last_said(), "This is the softest.");
    EXPECT_EQ(house.open(), VisitScreen::picture);
}

TEST(Visit, VO2_VolumeIsTheOperatorsAgainForTheNext) {
    FakeHouse house;
    to_choose(house);
    house.press({KeyRole::louder, KeyRole::louder});
    ASSERT_NE(house.visit.visitor.sound, house.rules.sound);
    finish(house);
    house.wait(12.0);
    EXPECT_EQ(house.visit.visitor.sound, house.rules.sound);
    const auto wanted = house.all_orders;
    const auto last = std::find_if(wanted.rbegin(), wanted.rend(), [](const VisitOrder& order) {
        return std::holds_alternative<SoundWanted>(order);
    });
    ASSERT_NE(last, wanted.rend());
    EXPECT_EQ(std::get<SoundWanted>(*last), house.rules.sound);
}

TEST(Visit, VO5_HeadphonesOutIsSilenceThenAQuestion) {
    FakeHouse house;
    to_picture(house);
    house.apply(HeadphonesChanged{true});
    EXPECT_TRUE(house.has_said("The headphones are in.", 0));
    house.wait(3.0);
    const std::size_t before = house.transcript.size();
    house.apply(HeadphonesChanged{false});
    EXPECT_EQ(house.last<Hush>().size(), 1U);
    EXPECT_EQ(house.last_said(), "The headphones are out.");
    house.wait(9.9);
    EXPECT_EQ(house.transcript.size(), before + 1) << "nothing private is said aloud";
    house.wait(0.2);
    EXPECT_EQ(house.open(), VisitScreen::question);
    house.press(KeyRole::down);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_TRUE(house.visit.visitor.felt);
}

TEST(Visit, HeadphonesOutAndInAreSaidOnEveryScreen) {
    FakeHouse house;
    std::set<VisitScreen> told;
    for (const Visit& scene : scenes_of_all_screens()) {
        if (!is_visit_on(scene) || !told.insert(open_screen(scene)).second) continue;
        Visit visit = scene;
        for (const bool are_in : {false, true}) {
            VisitStep next = step(visit, HeadphonesChanged{are_in}, house.world());
            visit = std::move(next.visit);
            const bool is_said = std::ranges::any_of(next.orders, [&](const VisitOrder& order) {
                const auto* const said = std::get_if<Utterance>(&order);
                return said != nullptr &&
                       said->text.starts_with(are_in ? "The headphones are in."
                                                     : "The headphones are out.");
            });
            EXPECT_TRUE(is_said) << static_cast<int>(open_screen(scene)) << ", " << are_in;
        }
    }
}

TEST(Visit, LA1_EachLanguageIsNamedInItselfAndSwitchesSpeechAndText) {
    FakeHouse house;
    house.press(KeyRole::select);
    for (std::size_t i = 1; i < all_languages().size(); ++i) {
        house.press(KeyRole::down);
        ASSERT_EQ(house.last<Utterance>().size(), 1U);
        EXPECT_EQ(house.last<Utterance>()[0].language, all_languages()[i].code());
        EXPECT_TRUE(house.last<Utterance>()[0].text.starts_with(all_languages()[i].name()));
    }
    const Language& last = all_languages().back();
    house.press(KeyRole::select);
    EXPECT_EQ(house.last<Utterance>()[0].language, last.code());
    EXPECT_EQ(house.screen().title, last.text("visit", "What to feel"));
    EXPECT_EQ(house.last<SoundWanted>()[0].language, all_languages().size() - 1);
}

TEST(Visit, LA1_APauseNamesAllLanguagesInThemselves) {
    FakeHouse house;
    house.press(KeyRole::select);
    const std::size_t before = house.transcript.size();
    house.wait(2.0);
    ASSERT_EQ(house.transcript.size(), before + all_languages().size() - 1);
    for (std::size_t i = 1; i < all_languages().size(); ++i) {
        const auto& said = house.transcript[before + i - 1];
        EXPECT_TRUE(said.text.starts_with(all_languages()[i].name())) << said.text;
        const std::string down = all_languages()[i].text("keys", "Down");
        EXPECT_NE(said.text.find(down), std::string::npos) << said.text;
        EXPECT_EQ(said.language, all_languages()[i].code());
    }
}

TEST(Visit, LA1_AnotherLanguageNamesThePartsAnew) {
    FakeHouse house;
    to_picture(house);
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Settings"));
    ASSERT_TRUE(house.choose("Language"));
    ASSERT_TRUE(house.choose("Deutsch"));
    EXPECT_EQ(house.open(), VisitScreen::settings);
    house.wait(1.0);
    EXPECT_EQ(house.visit.visitor.felt->facts.parts[0].name, "Body de");
    EXPECT_EQ(house.screen().title, "Einstellungen");
}

TEST(Visit, VI5_WhatIsSaidIsTheCaptionAndSoundsHaveASign) {
    FakeHouse house;
    house.press({KeyRole::select, KeyRole::select, KeyRole::down});
    EXPECT_EQ(house.visit.visitor.caption.text, house.last_said());
    EXPECT_EQ(house.visit.visitor.caption.language, "en");
    EXPECT_EQ(house.visit.visitor.caption.sign, ScreenEvent::key_taken);
    house.apply(DeadKeyPressed{});
    EXPECT_EQ(house.visit.visitor.caption.sign, ScreenEvent::key_refused);
}

TEST(Visit, VI7_TheScreenCanBeDarkAndThatIsSaid) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Settings"));
    ASSERT_TRUE(house.choose("Screen"));
    EXPECT_EQ(house.last_said(), "Screen, off, setting, 9 of 12");
    ASSERT_EQ(house.last<LookWanted>().size(), 1U);
    EXPECT_TRUE(house.last<LookWanted>()[0].is_off);
    house.press(KeyRole::select);
    EXPECT_FALSE(house.last<LookWanted>()[0].is_off);
}

TEST(Visit, SpeechThatWasTurnedOffComesBackWithHelp) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Settings"));
    ASSERT_TRUE(house.choose("Speech"));
    EXPECT_FALSE(house.visit.visitor.sound.is_speech_on);
    house.press(KeyRole::help);
    EXPECT_TRUE(house.visit.visitor.sound.is_speech_on);
    EXPECT_TRUE(house.last_said().starts_with("Speech is on."));
}

}  // namespace
}  // namespace touchline
