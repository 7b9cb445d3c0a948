// Tests time-outs, the end of a visit, and troubles: TI and ER of the requirements.
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Visit, TI1_AfterSilenceAQuestionInThreeSenses) {
    FakeHouse house;
    to_picture(house);
    const double key_s = house.now_s;
    while (house.open() != VisitScreen::question) house.wait(0.05);
    EXPECT_NEAR(house.now_s - key_s, 90.0, 0.5);
    EXPECT_EQ(house.screen().title, "Are you still there?");
    EXPECT_TRUE(house.last_said().starts_with("Are you still there?"));
    ASSERT_FALSE(house.last<GivePattern>().empty());
    EXPECT_EQ(house.last<GivePattern>()[0].pattern, HandlePattern::time_out);
    EXPECT_EQ(house.last<GiveCue>()[0].event, ScreenEvent::time_out);
}

/// A kiosk restarts on a machine that has run for long.
TEST(Visit, TI1_AKeyBeforeTheClockIsToldWasNotLongAgo) {
    FakeHouse house;
    house.visit.site.now_s = 0.0;
    house.press(KeyRole::select);
    house.apply(Tick{5000.0});
    EXPECT_EQ(house.open(), VisitScreen::language);
    house.apply(Tick{5060.0});
    EXPECT_EQ(house.open(), VisitScreen::language);
}

TEST(Visit, TI1_AnyKeyGivesMoreTimeAsOftenAsOneLikes) {
    FakeHouse house;
    to_picture(house);
    for (int time = 0; time < 12; ++time) {
        house.wait(91.0);
        ASSERT_EQ(house.open(), VisitScreen::question);
        house.wait(28.0);
        ASSERT_EQ(house.open(), VisitScreen::question) << "30 s to answer";
        house.press(static_cast<KeyRole>(time % static_cast<int>(key_role_count)));
        ASSERT_EQ(house.open(), VisitScreen::picture);
        EXPECT_TRUE(house.last_said().starts_with("You have more time."));
    }
    EXPECT_TRUE(house.visit.visitor.felt);
}

TEST(Visit, TI1_MotionCountsButNotThatOfAHandleThatLeads) {
    FakeHouse house;
    to_picture(house);
    HandleSeen moved;
    moved.has_moved = true;
    for (int i = 0; i < 20; ++i) {
        house.wait(20.0);
        house.apply(moved);
    }
    EXPECT_EQ(house.open(), VisitScreen::picture);
    house.lead_s = 1e9;  // it waits for a hand that has let go
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    moved.is_led = true;
    for (int i = 0; i < 420 && house.open() == VisitScreen::picture; ++i) {
        house.wait(1.0);
        house.apply(moved);
    }
    EXPECT_EQ(house.open(), VisitScreen::question);
}

TEST(Visit, TI1_WhoReadsTheBrailleLineIsThere) {
    FakeHouse house;
    house.apply(LineRead{});
    EXPECT_EQ(house.open(), VisitScreen::attract) << "the invitation can be read to its end";
    to_picture(house);
    for (int i = 0; i < 20; ++i) {
        house.wait(20.0);
        house.apply(LineRead{});
    }
    EXPECT_EQ(house.open(), VisitScreen::picture);
    house.wait(90.5);
    ASSERT_EQ(house.open(), VisitScreen::question);
    house.apply(LineRead{});
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_TRUE(house.last_said().starts_with("You have more time."));
}

TEST(Visit, AnEndOfTheBrailleLineIsFeltAndAPageStopsNoHandle) {
    FakeHouse house;
    to_picture(house);
    house.lead_s = 100.0;
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    house.wait(5.0);
    ASSERT_TRUE(house.is_leading);
    house.apply(LineRead{});
    EXPECT_TRUE(house.orders.empty()) << "a page that is turned is felt by itself";
    EXPECT_TRUE(house.is_leading) << "whoever is led reads what the hand is on";
    house.apply(LineRead{true});
    ASSERT_EQ(house.last<GivePattern>().size(), 1U);
    EXPECT_EQ(house.last<GivePattern>().front().pattern, HandlePattern::edge);
    EXPECT_TRUE(house.is_leading);
}

TEST(Visit, TI1_AHandleThatWaitsForAHandIsNobody) {
    FakeHouse house;
    to_picture(house);
    house.lead_s = 1e9;
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    for (int i = 0; i < 89; ++i) {
        house.wait(1.0);
        house.apply(HandleSeen{});
    }
    EXPECT_EQ(house.open(), VisitScreen::picture);
    house.wait(2.0);
    EXPECT_EQ(house.open(), VisitScreen::question) << "not after the five minutes of being led";
}

TEST(Visit, TI1_NoAnswerEndsTheVisit) {
    FakeHouse house;
    to_picture(house);
    house.wait(90.5);
    ASSERT_EQ(house.open(), VisitScreen::question);
    house.wait(30.5);
    EXPECT_EQ(house.open(), VisitScreen::goodbye);
    house.wait(11.0);
    EXPECT_EQ(house.open(), VisitScreen::attract);
}

TEST(Visit, TI1_TimesAreTheOperatorsWithinBounds) {
    for (const auto& [inactivity_s, expected_s] :
         {std::pair{45.0, 45.0}, std::pair{1.0, 30.0}, std::pair{1e9, 1800.0}}) {
        VisitRules rules;
        rules.inactivity_s = inactivity_s;
        rules.answer_s = 1.0;
        FakeHouse house(rules);
        house.press(KeyRole::select);
        house.wait(expected_s - 0.5);
        EXPECT_EQ(house.open(), VisitScreen::language);
        house.wait(1.0);
        EXPECT_EQ(house.open(), VisitScreen::question);
        house.wait(28.0);
        EXPECT_EQ(house.open(), VisitScreen::question) << "never less than 30 s to answer";
    }
}

TEST(Visit, TI2_NothingOfAVisitorStays) {
    FakeHouse house;
    to_stick_picture(house);
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Settings"));
    ASSERT_TRUE(house.choose("Screen"));
    ASSERT_TRUE(house.choose("The same sound in both ears"));
    house.press(KeyRole::louder);
    house.press(KeyRole::back);
    finish(house);
    EXPECT_EQ(house.last<Wipe>().size(), 1U);
    EXPECT_EQ(house.last<GiveStickBack>().size(), 1U);
    ASSERT_EQ(house.last<Feel>().size(), 1U);
    EXPECT_FALSE(house.last<Feel>()[0].is_force_wanted) << "nothing is centred by force";
    ASSERT_FALSE(house.last<Guide>().empty());
    for (const Guide& guide : house.last<Guide>()) EXPECT_EQ(guide.kind, GuideKind::stop);
    house.wait(12.0);
    const Visitor& after = house.visit.visitor;
    const Visitor fresh = start_visit(house.world()).visit.visitor;
    EXPECT_EQ(after.path, fresh.path);
    EXPECT_FALSE(after.over);
    EXPECT_FALSE(after.felt);
    EXPECT_FALSE(after.loading);
    EXPECT_FALSE(after.has_stick);
    EXPECT_EQ(after.stick_list, nullptr);
    EXPECT_TRUE(after.caption.text.empty());
    EXPECT_TRUE(after.error.empty());
    EXPECT_EQ(after.sound, fresh.sound);
    EXPECT_EQ(after.look, fresh.look);
    EXPECT_EQ(after.feel, fresh.feel);
    EXPECT_EQ(after.detail, fresh.detail);
    EXPECT_FALSE(after.handle.part);
}

TEST(Visit, TI2_WhatIsBeingOpenedIsDroppedToo) {
    FakeHouse house;
    house.load_s = 1e6;
    to_choose(house);
    ASSERT_TRUE(house.choose("Gallery"));
    house.press({KeyRole::select, KeyRole::select});
    const auto request = house.last<LoadPicture>()[0].request;
    house.apply(OpeningChanged{SiteOpening::closed});
    ASSERT_EQ(house.last<CancelLoad>().size(), 1U);
    EXPECT_EQ(house.last<CancelLoad>()[0].request, request);
    house.apply(PictureReady{request, fake_facts({})});
    EXPECT_FALSE(house.visit.visitor.felt);
    EXPECT_EQ(house.open(), VisitScreen::closed);
}

TEST(Visit, TI3_StartOverAndResetAskOnce) {
    FakeHouse house;
    to_picture(house);
    house.press({KeyRole::louder, KeyRole::back});
    ASSERT_TRUE(house.choose("Settings"));
    ASSERT_TRUE(house.choose("Reset the settings"));
    EXPECT_EQ(house.open(), VisitScreen::confirm);
    EXPECT_NE(house.visit.visitor.sound, house.rules.sound);
    house.press(KeyRole::select);  // No has the focus
    EXPECT_NE(house.visit.visitor.sound, house.rules.sound);
    ASSERT_TRUE(house.choose("Reset the settings"));
    ASSERT_TRUE(house.choose("Yes"));
    EXPECT_EQ(house.visit.visitor.sound, house.rules.sound);
    EXPECT_TRUE(house.visit.visitor.felt) << "a reset keeps the picture";
    ASSERT_TRUE(house.choose("Start over"));
    EXPECT_TRUE(house.visit.visitor.felt);
    ASSERT_TRUE(house.choose("Yes"));
    EXPECT_EQ(house.last<Wipe>().size(), 1U);
    EXPECT_EQ(house.open(), VisitScreen::language);
    EXPECT_FALSE(house.visit.visitor.felt);
}

TEST(Visit, TI5_NothingIsTakenWithoutAKeyAndTheShutterIsHeard) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Camera"));
    ASSERT_EQ(house.last<CameraPreview>().size(), 1U);
    EXPECT_TRUE(house.last<CameraPreview>()[0].is_on);
    EXPECT_EQ(house.screen().view, ScreenView::camera);
    house.apply(CameraCaptured{});
    EXPECT_TRUE(house.last<LoadPicture>().empty()) << "nobody asked";
    house.wait(60.0);
    for (const VisitOrder& order : house.all_orders) {
        EXPECT_FALSE(std::holds_alternative<Capture>(order));
    }
    ASSERT_TRUE(house.choose("Take the photo"));
    EXPECT_EQ(house.last<Capture>().size(), 1U);
    EXPECT_FALSE(house.last<CameraPreview>()[0].is_on);
    const std::size_t before = house.transcript.size();
    house.apply(CameraCaptured{});
    ASSERT_FALSE(house.last<GiveCue>().empty());
    EXPECT_EQ(house.last<GiveCue>()[0].event, ScreenEvent::shutter);
    EXPECT_TRUE(house.has_said("The photo has been taken.", before));
    ASSERT_EQ(house.last<LoadPicture>().size(), 1U);
    EXPECT_EQ(house.last<LoadPicture>()[0].source, PictureSource::camera);
}

TEST(Visit, AnUnclearPhotographIsSaidToBeSo) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Camera"));
    ASSERT_TRUE(house.choose("Take the photo"));
    const std::size_t before = house.transcript.size();
    house.apply(CameraCaptured{true});
    EXPECT_TRUE(
        house.has_said("The photo has been taken. It is unclear; you can take it again.", before));
    EXPECT_EQ(house.last<LoadPicture>().size(), 1U) << "it can be felt all the same";
}

TEST(Visit, TI6_GoodbyeRemindsOfStickAndHeadphones) {
    FakeHouse house;
    house.press(KeyRole::select);
    house.press({KeyRole::down, KeyRole::select});  // Deutsch
    ASSERT_TRUE(house.choose(all_languages()[1].text("visit", "Finish")));
    ASSERT_TRUE(house.choose(all_languages()[1].text("visit", "Yes")));
    EXPECT_EQ(house.transcript.back().language, "de");
    const std::size_t last = house.transcript.size() - 1;
    EXPECT_TRUE(house.has_said("nehmen Sie ihn wieder mit.", last));
    EXPECT_FALSE(house.has_said("USB-Stick", last)) << "there is none";
}

TEST(Visit, GoodbyeRemindsOfAStickThatIsThere) {
    FakeHouse house;
    house.press({KeyRole::select, KeyRole::select});
    house.apply(StickCame{{"a.png"}, {}});
    ASSERT_TRUE(house.choose("Finish"));
    ASSERT_TRUE(house.choose("Yes"));
    EXPECT_TRUE(house.has_said("Take your USB stick with you.", house.transcript.size() - 1));
}

TEST(Visit, WhoIsToCallTheStaffCanDoItThere) {
    FakeHouse house;
    house.press({KeyRole::select, KeyRole::select});
    house.apply(TroubleBegan{TroubleKind::device, ""});
    EXPECT_TRUE(house.last_said().starts_with("The handle. "));
    EXPECT_TRUE(
        house.last_said().ends_with("Press Down to call staff, or Select to go on without force."));
    house.press({KeyRole::down, KeyRole::select});
    EXPECT_TRUE(house.last_said().starts_with(
        "The staff have been called. You can carry on meanwhile. What to feel."));
    EXPECT_EQ(house.open(), VisitScreen::choose);
    EXPECT_TRUE(house.visit.site.is_staff_called);
    house.apply(TroubleBegan{TroubleKind::device, "Another one. Wait."});
    EXPECT_EQ(house.screen().items.size(), 1U) << "they know already";
    EXPECT_TRUE(house.last_said().ends_with("Or press Select to go on without force."));
    VisitRules rules;
    rules.offers_staff = false;
    FakeHouse alone(rules);
    alone.press({KeyRole::select, KeyRole::select});
    alone.apply(TroubleBegan{TroubleKind::device, ""});
    EXPECT_EQ(alone.screen().items.size(), 1U);
}

TEST(Visit, ER1_EveryErrorSaysWhatWhyAndWhatToDoAndOneKeyGoesOn) {
    for (std::size_t language = 0; language < all_languages().size(); ++language) {
        for (std::size_t kind = 0; kind < trouble_count; ++kind) {
            VisitRules rules;
            rules.sound.language = language;
            FakeHouse house(rules);
            house.press({KeyRole::select, KeyRole::select});
            house.apply(TroubleBegan{static_cast<TroubleKind>(kind), ""});
            EXPECT_EQ(house.open(), VisitScreen::trouble);
            const SpokenScreen screen = house.screen();
            EXPECT_EQ(screen.items.front().id, static_cast<int>(VisitItem::go_on));
            // At least two sentences: what is wrong, and what to do about it.
            const auto stop = screen.text.find(". ");
            EXPECT_NE(stop, std::string::npos) << screen.text;
            EXPECT_NE(house.last_said().find(screen.text), std::string::npos);
            EXPECT_NE(house.last_said().find(screen.items[0].hint), std::string::npos);
            house.press(KeyRole::select);
            EXPECT_EQ(house.open(), VisitScreen::choose);
        }
    }
}

TEST(Visit, ER1_AFileThatCannotBeOpenedKeepsWhatIsFelt) {
    FakeHouse house;
    to_picture(house);
    const std::string title = house.visit.visitor.felt->facts.title;
    ASSERT_TRUE(house.choose("Another picture"));
    house.loads_fail = true;
    house.press({KeyRole::down, KeyRole::select});
    house.wait(0.5);
    EXPECT_EQ(house.open(), VisitScreen::trouble);
    EXPECT_TRUE(house.has_said("cannot be opened", 0));
    house.press(KeyRole::select);
    EXPECT_EQ(house.open(), VisitScreen::gallery);
    EXPECT_EQ(house.visit.visitor.felt->facts.title, title);
}

TEST(Visit, ER1_HelpDoesNotMakeATroubleForgotten) {
    FakeHouse house;
    to_choose(house);
    house.apply(TroubleBegan{TroubleKind::camera, "The camera is gone. Plug it in."});
    house.press({KeyRole::help, KeyRole::back, KeyRole::back});
    EXPECT_EQ(house.open(), VisitScreen::trouble);
    EXPECT_NE(house.last_said().find("The camera is gone."), std::string::npos);
    house.wait(120.0);
    EXPECT_EQ(house.open(), VisitScreen::question);
    house.press(KeyRole::up);
    EXPECT_EQ(house.open(), VisitScreen::trouble) << "nor does the question";
    EXPECT_TRUE(house.last_said().starts_with("You have more time. Something is wrong."));
    house.press(KeyRole::select);
    EXPECT_EQ(house.open(), VisitScreen::choose);
}

TEST(Visit, NewWordsOfATroubleLeaveTheFocusWhereItIs) {
    FakeHouse house;
    to_choose(house);
    house.apply(TroubleBegan{TroubleKind::device, "It is gone. Wait."});
    house.press(KeyRole::down);
    house.apply(TroubleBegan{TroubleKind::device, "It is still gone. Wait."});
    house.press(KeyRole::select);
    EXPECT_TRUE(house.visit.site.is_staff_called);
}

TEST(Visit, ER2_AVisitSurvivesEveryLoss) {
    FakeHouse house;
    to_stick_picture(house);
    const std::size_t before = house.transcript.size();
    house.apply(StickGone{});
    EXPECT_TRUE(house.has_said("The USB stick is out. Your picture stays open.", before));
    EXPECT_TRUE(house.visit.visitor.felt);
    for (std::size_t kind = 0; kind < trouble_count; ++kind) {
        house.apply(TroubleBegan{static_cast<TroubleKind>(kind), ""});
        EXPECT_EQ(house.open(), VisitScreen::trouble);
        house.press(KeyRole::back);
        EXPECT_EQ(house.open(), VisitScreen::picture);
        EXPECT_TRUE(house.visit.visitor.felt);
    }
    house.apply(CameraChanged{false});
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    EXPECT_TRUE(house.has_said("The handle has no force now.", before));
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Your USB stick"));
    EXPECT_NE(house.screen().text.find("There is no USB stick."), std::string::npos);
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Camera"));
    EXPECT_NE(house.screen().text.find("does not answer"), std::string::npos);
    EXPECT_FALSE(house.find("Take the photo")) << "a dead camera takes none";
    EXPECT_NE(house.screen().text.find("tell the staff"), std::string::npos);
    house.apply(TroubleEnded{TroubleKind::device});
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Back to the picture"));
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    house.wait(3.0);
    EXPECT_TRUE(house.is_leading);
}

TEST(Visit, ForceThatIsBackIsSaidOnceAndRepeatNoLongerSaysThatThereIsNone) {
    FakeHouse house;
    to_picture(house);
    house.apply(TroubleBegan{TroubleKind::device, ""});
    house.press(KeyRole::select);
    ASSERT_TRUE(house.choose("Guide me along the largest outline"));
    ASSERT_TRUE(house.last_said().starts_with("The handle has no force now."));
    const std::size_t before = house.transcript.size();
    house.apply(TroubleEnded{TroubleKind::device});
    house.apply(TroubleEnded{TroubleKind::device});
    EXPECT_EQ(house.transcript.size(), before + 1);
    for (int presses = 0; presses < 2; ++presses) {
        house.press(KeyRole::repeat);
        EXPECT_EQ(house.last_said().find("no force"), std::string::npos) << house.last_said();
    }
    EXPECT_EQ(house.transcript[before + 1].text, "The force is back.");
}

TEST(Visit, ER2_WhoComesLaterIsToldOfWhatLasts) {
    FakeHouse house;
    house.apply(TroubleBegan{TroubleKind::device, ""});
    EXPECT_TRUE(house.transcript.empty()) << "nobody is here";
    house.press({KeyRole::select, KeyRole::down});
    house.press(KeyRole::select);
    EXPECT_TRUE(house.has_said("Der Griff hat keine Kraft.", 0)) << "in the language chosen since";
}

TEST(Visit, ER2_TheCameraLostWhileItWorksIsAnError) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Camera"));
    ASSERT_TRUE(house.choose("Take the photo"));
    house.apply(CameraChanged{false});
    EXPECT_EQ(house.open(), VisitScreen::trouble);
    house.press(KeyRole::select);
    EXPECT_EQ(house.open(), VisitScreen::camera);
}

TEST(Visit, ER3_LongWorkIsHeardThenSaidAndCanBeCancelled) {
    FakeHouse house;
    house.load_s = 60.0;
    to_choose(house);
    ASSERT_TRUE(house.choose("Gallery"));
    house.press({KeyRole::select, KeyRole::select});
    const auto request = house.last<LoadPicture>()[0].request;
    const double begin_s = house.now_s;
    house.all_orders.clear();
    house.wait(0.25);
    EXPECT_TRUE(house.all_orders.empty());
    house.wait(0.1);
    ASSERT_EQ(house.all_orders.size(), 1U);
    EXPECT_EQ(std::get<GiveCue>(house.all_orders[0]).event, ScreenEvent::progress);
    const std::size_t before = house.transcript.size();
    while (!house.has_said("The picture is being opened.", before)) {
        house.wait(0.05);
        ASSERT_LT(house.now_s - begin_s, 2.2);
    }
    EXPECT_GE(house.now_s - begin_s, 2.0);
    for (int i = 0; i < 200; ++i) {
        house.wait(0.1);
        ASSERT_LE(house.now_s - house.sounded_s, 5.0);
    }
    house.press(KeyRole::back);
    ASSERT_EQ(house.last<CancelLoad>().size(), 1U);
    EXPECT_EQ(house.last<CancelLoad>()[0].request, request);
    EXPECT_EQ(house.open(), VisitScreen::gallery);
    house.apply(PictureReady{request, fake_facts({})});
    EXPECT_EQ(house.open(), VisitScreen::gallery) << "what was cancelled does not come";
    EXPECT_FALSE(house.visit.visitor.felt);
}

TEST(Visit, ER3_AStickThatIsBeingReadIsHeardToo) {
    FakeHouse house;
    to_choose(house);
    house.apply(StickArriving{});
    ASSERT_TRUE(house.choose("Your USB stick"));
    EXPECT_NE(house.last_said().find("Your USB stick is being read."), std::string::npos);
    const std::size_t before = house.transcript.size();
    house.wait(9.5);
    EXPECT_FALSE(house.has_said("Your USB stick is being read.", before)) << "not so soon";
    house.wait(1.5);
    EXPECT_TRUE(house.has_said("Your USB stick is being read.", before));
    house.apply(StickCame{{"boat"}, {}});
    EXPECT_TRUE(house.last_said().find("boat") != std::string::npos);
    house.all_orders.clear();
    house.wait(1.2);
    for (const VisitOrder& order : house.all_orders)
        EXPECT_FALSE(std::holds_alternative<GiveCue>(order)) << "done is quiet";
}

TEST(Visit, ER4_WithoutSoundTheScreenAsksForStaffAndTheHandleForAttention) {
    FakeHouse house;
    to_picture(house);
    house.apply(TroubleBegan{TroubleKind::sound, ""});
    EXPECT_NE(house.screen().text.find("Please call the staff."), std::string::npos);
    EXPECT_EQ(house.last<GivePattern>()[0].pattern, HandlePattern::error);
    house.all_orders.clear();
    house.wait(16.0);
    int shakes = 0;
    for (const VisitOrder& order : house.all_orders) {
        const auto* given = std::get_if<GivePattern>(&order);
        if (given != nullptr && given->pattern == HandlePattern::error) ++shakes;
    }
    EXPECT_EQ(shakes, 3);
    house.apply(TroubleEnded{TroubleKind::sound});
    EXPECT_EQ(house.open(), VisitScreen::picture);
}

TEST(Visit, StaffAreCalledAndCalledOff) {
    FakeHouse house;
    to_choose(house);
    ASSERT_TRUE(house.choose("Call staff"));
    EXPECT_TRUE(house.last<CallStaff>()[0].is_wanted);
    EXPECT_EQ(house.screen().items[*house.screen().focus].value, "called");
    house.apply(StaffCalledOff{});
    EXPECT_FALSE(house.last<CallStaff>()[0].is_wanted);
    EXPECT_EQ(house.last_said(), "The staff know of your call.");
}

TEST(Visit, AClosedHouseSaysSoAndOpensAgain) {
    FakeHouse house;
    to_picture(house);
    house.apply(OpeningChanged{SiteOpening::maintenance});
    EXPECT_EQ(house.last<Wipe>().size(), 1U);
    EXPECT_EQ(house.open(), VisitScreen::closed);
    house.rules.notice = "We are back at two.";
    house.press(KeyRole::select);
    EXPECT_NE(house.last_said().find("We are back at two."), std::string::npos);
    EXPECT_EQ(house.open(), VisitScreen::closed);
    house.apply(OpeningChanged{SiteOpening::open});
    house.press(KeyRole::select);
    EXPECT_EQ(house.open(), VisitScreen::language);
}

}  // namespace
}  // namespace touchline
