// Tests how guiding, a visit and the kiosk end, and what is said then.
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <optional>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Any key would only stop the handle.
TEST(Visit, NoHintIsSaidWhileTheHandleGuides) {
    FakeHouse house;
    to_picture(house);
    house.lead_s = 20.0;
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    const std::size_t before = house.transcript.size();
    house.wait(21.0);
    EXPECT_EQ(house.transcript.size(), before) << house.last_said();
    house.wait(3.0);
    EXPECT_TRUE(house.has_said("That was the whole outline.", before));
}

TEST(Visit, WhyGuidingEndedIsSaid) {
    for (const auto& [why, told] :
         {std::pair{GuidanceEnd::arrived, "That was the whole outline."},
          std::pair{GuidanceEnd::let_go, "You let go of the handle. It has stopped guiding you."},
          std::pair{GuidanceEnd::no_force, "The force is off. The handle has stopped guiding you."},
          std::pair{GuidanceEnd::other, "The handle has stopped guiding you."}}) {
        FakeHouse house;
        to_picture(house);
        house.lead_s = 100.0;
        ASSERT_TRUE(house.choose("Guide me along the largest outline"));
        house.wait(3.0);
        house.apply(GuidanceEnded{why});
        const std::string all = told + std::string(" Guide me along the largest outline, 1 of ") +
                                std::to_string(house.screen().items.size());
        EXPECT_EQ(house.last_said(), all) << "and where the visitor is";
        house.press(KeyRole::repeat);
        EXPECT_EQ(house.last_said(), all);
    }
    for (const SwitchUse use : {SwitchUse::none, SwitchUse::move_and_select}) {
        FakeHouse house;
        house.settings.two_switches = use;
        to_picture(house);
        ASSERT_TRUE(house.choose("Guide me along the largest outline"));
        house.press(KeyRole::select);
        EXPECT_TRUE(house.last_said().starts_with(
            use == SwitchUse::none ? "You pressed a key." : "You pressed a switch."));
    }
}

TEST(Visit, WhoWasLedRoundThePracticeShapeHearsWhatCanBeDoneNext) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Practice shape"));
    house.wait(0.5);
    ASSERT_TRUE(house.choose("Guide me along the outline"));
    house.wait(5.0);
    EXPECT_EQ(
        house.last_said(),
        "That was the whole outline. Now feel it on your own, choose another shape, or go on. "
        "Guide me along the outline, 1 of 4");
}

TEST(Visit, APartThatIsNearIsReachedWithoutCuttingItsAnnouncement) {
    FakeHouse house;
    to_picture(house);
    house.lead_s = 0.1;
    ASSERT_TRUE(house.choose("Parts"));
    house.press(KeyRole::select);
    house.wait(2.5);
    EXPECT_EQ(house.transcript.back().text, "You are there.");
    EXPECT_EQ(house.transcript.back().priority, SpeechPriority::hint) << "after what is being said";
    house.press(KeyRole::repeat);
    EXPECT_EQ(house.last_said(), "You are there.");
}

/// Passes an hour in which the handle shakes, is led and rests on lines, and no hand moves it.
/// Returns how often the visit believed that somebody answered.
int answers_of_nobody(FakeHouse& house) {
    int answers = 0;
    for (int second = 0; second < 3600 && is_visit_on(house.visit); ++second) {
        HandleSeen shaking;
        shaking.place_W = {0.003 * (second % 3), -0.003 * (second % 2)};
        shaking.part = second % 4 == 0 ? std::optional<std::size_t>() : second % 2;
        shaking.speed_m_per_s = 0.1 * (second % 3);
        const bool was_asked = house.open() == VisitScreen::question;
        house.apply(shaking);
        house.now_s += 1.0;
        house.apply(Tick{house.now_s});
        const bool is_asked = house.open() == VisitScreen::question;
        if (was_asked && !is_asked && is_visit_on(house.visit)) ++answers;
    }
    return answers;
}

TEST(Visit, TI1_NobodyAnswersOnNoScreenAndInNoLanguage) {
    for (std::size_t language = 0; language < all_languages().size(); ++language) {
        std::set<VisitScreen> known;
        for (const Visit& scene : scenes_of_all_screens()) {
            if (!known.insert(open_screen(scene)).second) continue;
            for (const Mode mode : {Mode::wall, Mode::groove, Mode::ridge, Mode::stay}) {
                FakeHouse house;
                house.visit = scene;
                house.visit.visitor.sound.language = language;
                house.visit.visitor.feel.mode = mode;
                house.now_s = scene.site.now_s;
                EXPECT_EQ(answers_of_nobody(house), 0) << static_cast<int>(open_screen(scene));
                EXPECT_FALSE(is_visit_on(house.visit)) << "and the visit ends";
            }
        }
    }
}

TEST(Visit, TheQuestionsSecondsCountDown) {
    FakeHouse house;
    to_picture(house);
    while (house.open() != VisitScreen::question) house.wait(0.05);
    EXPECT_NE(house.screen().text.find("in 30 seconds"), std::string::npos);
    house.wait(10.0);
    EXPECT_NE(house.screen().text.find("in 20 seconds"), std::string::npos);
    house.wait(19.5);
    EXPECT_NE(house.screen().text.find("in 1 second."), std::string::npos) << house.screen().text;
}

TEST(Visit, GoodbyeCountsThePicturesThatWereFelt) {
    FakeHouse house;
    HandleSeen moved;
    moved.part = 0;
    moved.has_moved = true;
    to_stick_picture(house);
    house.apply(moved);
    for (const std::string title : {"file 2", "file 1", "file 3"}) {
        ASSERT_TRUE(house.choose("Another picture"));
        ASSERT_TRUE(house.choose(title));
        house.wait(0.5);
        if (title != "file 3") house.apply(moved);
    }
    while (house.open() != VisitScreen::choose) house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Practice shape"));
    house.wait(0.5);
    house.apply(moved);
    finish(house);
    EXPECT_TRUE(house.has_said("You felt 2 pictures.", house.transcript.size() - 1))
        << "neither practice nor one that was only open, and none twice: " << house.last_said();
    house.wait(12.0);
    house.press({KeyRole::select, KeyRole::select});
    finish(house);
    EXPECT_FALSE(house.has_said("You felt", house.transcript.size() - 1));
}

TEST(Visit, APictureThatAHandWasLedRoundWasFelt) {
    for (const bool is_led_to_the_end : {true, false}) {
        FakeHouse house;
        to_picture(house);
        ASSERT_TRUE(house.choose("Guide me along the largest outline"));
        house.wait(3.0);
        if (!is_led_to_the_end) house.press(KeyRole::down);
        house.wait(3.0);
        finish(house);
        EXPECT_EQ(house.has_said("You felt 1 picture.", house.transcript.size() - 1),
                  is_led_to_the_end);
    }
}

/// Many pictures of a stick have no named parts, so no part is ever under the hand.
TEST(Visit, APictureWithoutNamedPartsIsFeltTooByAHandThatMoves) {
    for (const bool is_moved : {true, false}) {
        FakeHouse house;
        to_stick_picture(house);
        house.visit.visitor.felt->facts.parts.clear();
        HandleSeen seen;
        seen.has_moved = is_moved;
        house.apply(seen);
        finish(house);
        EXPECT_EQ(house.has_said("You felt 1 picture.", house.transcript.size() - 1), is_moved);
    }
}

TEST(Visit, GoodbyeRemindsOfThePictureOnTheTray) {
    for (const bool takes_photo : {true, false}) {
        FakeHouse house;
        to_choose(house);
        ASSERT_TRUE(house.choose("Camera"));
        house.press(takes_photo ? KeyRole::select : KeyRole::back);
        house.wait(2.0);
        while (house.open() != VisitScreen::choose) house.press(KeyRole::back);
        finish(house);
        const std::size_t last = house.transcript.size() - 1;
        EXPECT_EQ(house.has_said("Take your picture from the tray.", last), takes_photo);
        house.press({KeyRole::select, KeyRole::select});
        finish(house);
        EXPECT_FALSE(house.has_said("from the tray", house.transcript.size() - 1))
            << "it was another visitor's";
    }
}

TEST(Visit, AResetKeepsLanguageAndPictureAndSaysWhatItDid) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Firmness"));
    ASSERT_TRUE(house.choose("very soft"));
    house.press({KeyRole::softer, KeyRole::back});
    ASSERT_TRUE(house.choose("Settings"));
    for (const char* setting : {"Language", "Size of letters", "Speaking speed"}) {
        ASSERT_TRUE(house.choose(setting));
        house.press({KeyRole::down, KeyRole::select});
        house.visit.visitor.sound.language = 0;
    }
    ASSERT_TRUE(house.choose("Screen"));
    ASSERT_TRUE(house.choose("Reset the settings"));
    EXPECT_EQ(house.last_said(),
              "Reset the settings? Sound, speech, letters and lines will be as at the start. "
              "No, 1 of 2");
    const std::size_t language = house.visit.visitor.sound.language = 2;
    house.press({KeyRole::down, KeyRole::select});
    const Visitor& visitor = house.visit.visitor;
    SoundWanted sound = house.rules.sound;
    sound.language = language;
    EXPECT_EQ(visitor.sound, sound) << "else the visitor would understand nothing more";
    EXPECT_EQ(visitor.look, house.rules.look);
    EXPECT_EQ(visitor.feel.stiffness, operators_stiffness);
    EXPECT_TRUE(visitor.felt);
    EXPECT_EQ(house.open(), VisitScreen::settings);
    EXPECT_TRUE(house.last_said().starts_with(house.languages[language].text(
        "visit", "Sound, speech, letters and lines are as at the start.")));
}

TEST(Visit, NobodyQuitsTheKioskWithoutAQuestion) {
    for (const bool is_somebody_here : {false, true}) {
        FakeHouse house;
        if (is_somebody_here) to_picture(house);
        const VisitScreen open = house.open();
        for (const KeyRole no : {KeyRole::select, KeyRole::back}) {
            house.apply(QuitAsked{});
            EXPECT_TRUE(house.last_said().starts_with("Shut the kiosk down?"));
            house.press(no);
            EXPECT_TRUE(house.last<Quit>().empty());
            EXPECT_EQ(house.open(), open);
        }
        house.apply(QuitAsked{});
        house.press({KeyRole::down, KeyRole::select});
        EXPECT_EQ(house.last<Quit>().size(), 1U);
    }
}

TEST(Visit, AQuestionOfTheOperatorThatNobodyAnswersIsForgotten) {
    for (const bool is_somebody_here : {false, true}) {
        FakeHouse house;
        if (is_somebody_here) to_picture(house);
        const VisitScreen open = house.open();
        house.apply(QuitAsked{});
        house.wait(29.0);
        EXPECT_EQ(house.open(), VisitScreen::confirm);
        house.wait(1.5);
        EXPECT_EQ(house.open(), open) << "no visitor can answer it";
        EXPECT_EQ(house.visit.visitor.felt.has_value(), is_somebody_here);
    }
}

}  // namespace
}  // namespace touchline
