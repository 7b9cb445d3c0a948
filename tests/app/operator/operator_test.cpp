// Tests the operator's screens by six keys: settings, tests, upkeep.
#include "app/operator/backup.h"
#include "app/operator/operator_menu.h"
#include "haptics/pantograph/profile.h"
#include "tests/app/operator/at_operator_menu.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

class OperatorTest : public AtOperatorMenu {};

TEST_F(OperatorTest, ALockOutlastsLeavingAndTheRightPin) {
    rig.press(R::back);
    rig.enter();
    for (int i = 0; i < 5; ++i) rig.enter_pin("9999");
    (void)rig.heard();
    rig.enter_pin("1234");
    EXPECT_NE(rig.heard().find("Too many wrong PINs. Wait "), std::string::npos);
    rig.press(R::back);
    EXPECT_EQ(rig.state.place, P::closed);
    rig.enter();
    rig.enter_pin("1234");
    EXPECT_EQ(rig.state.place, P::pin);
    rig.now_s = rig.state.tries.locked_until_s - 1.2;
    rig.press(R::up);  // half a second later
    EXPECT_NE(rig.heard().find("Too many wrong PINs. Wait 1 second."), std::string::npos);
    rig.wait(61.0);
    rig.enter_pin("1234");
    EXPECT_EQ(rig.state.place, P::status);
    EXPECT_EQ(rig.state.tries.wrong, 0);
}

TEST_F(OperatorTest, AnAnswerThatNobodyAskedForOpensNothing) {
    rig.press(R::back);
    rig.take(PinChecked{true});
    EXPECT_EQ(rig.state.place, P::closed);
    rig.enter();
    rig.take(PinChecked{true});
    EXPECT_EQ(rig.state.place, P::pin);
}

TEST_F(OperatorTest, MoreFileSystemsAreWarnedOfAndAskedFor) {
    ASSERT_TRUE(rig.open({"Camera, keys and screen", "USB sticks"}));
    (void)rig.heard();
    ASSERT_TRUE(rig.find("Read USB sticks with ext4 and NTFS too"));
    EXPECT_FALSE(rig.world().settings.more_file_systems);
    rig.press(R::repeat);
    EXPECT_NE(rig.heard().find("may take the machine over"), std::string::npos);
    rig.press(R::select);
    EXPECT_EQ(rig.state.place, P::question);
    EXPECT_NE(rig.heard().find("may then take the machine over"), std::string::npos);
    EXPECT_FALSE(rig.world().settings.more_file_systems) << "not before the answer";
    rig.press(R::back);
    EXPECT_FALSE(rig.world().settings.more_file_systems);
    EXPECT_EQ(rig.state.place, P::sticks);
    ASSERT_TRUE(rig.open({"Read USB sticks with ext4 and NTFS too", "Yes"}));
    EXPECT_TRUE(rig.world().settings.more_file_systems);
    ASSERT_TRUE(rig.open({"Read USB sticks with ext4 and NTFS too"}));
    EXPECT_FALSE(rig.world().settings.more_file_systems) << "off without a question";
}

TEST_F(OperatorTest, ASettingIsHeldTurnedAndKept) {
    ASSERT_TRUE(rig.open({"How it feels", "Lines and force", "Firmness"}));
    EXPECT_NE(rig.heard().find("Press Up for more, Down for less"), std::string::npos);
    rig.press(R::down);
    EXPECT_EQ(rig.heard(), "450 newtons per metre\n");
    EXPECT_EQ(rig.felt.stiffness_N_per_m, 450.0) << "felt while it is turned";
    EXPECT_EQ(rig.world().settings.stiffness_N_per_m, 500.0) << "not yet on the disk";
    rig.press(R::select);
    EXPECT_EQ(rig.world().settings.stiffness_N_per_m, 450.0);
    rig.press(R::back);
    EXPECT_EQ(rig.state.place, P::touch) << "let go of, Back leaves";
    EXPECT_EQ(rig.screen().items[rig.state.focus].name, "Lines and force");
}

TEST_F(OperatorTest, WhatTheLoopDoesNotAllowIsSaidBesideWhatIsSet) {
    rig.bounds.stiffness = {1.0, 508.0};
    ASSERT_TRUE(rig.open({"How it feels", "Lines and force", "Firmness"}));
    (void)rig.heard();
    rig.press({R::up, R::up});
    EXPECT_NE(rig.heard().find("600 newtons per metre set, 510 possible on this loop"),
              std::string::npos);
    EXPECT_EQ(rig.felt.stiffness_N_per_m, 600.0);
    rig.press({R::down, R::down});
    EXPECT_NE(rig.heard().find("500 newtons per metre\n"), std::string::npos);
    rig.bounds.stiffness = {0.5, 960.0};  // without real-time priority
    rig.press({R::down});
    EXPECT_NE(rig.heard().find("450 newtons per metre set, 230 possible"), std::string::npos);
}

TEST_F(OperatorTest, LevelsThatAPictureDoesNotHaveAreSaidBesideThoseSet) {
    ASSERT_TRUE(rig.open({"How it feels", "Levels"}));
    const auto value = [this](std::size_t item) { return rig.screen().items[item].value; };
    EXPECT_EQ(value(3), "16") << "nothing is felt";
    LevelTerms terms;
    terms.radius = 1.0;
    terms.safe = 5.0;
    rig.bounds.levels = terms;
    EXPECT_EQ(value(1), "0 set, 1 possible in this picture");
    EXPECT_EQ(value(2), "0 set, 1 possible in this picture");
    EXPECT_EQ(value(3), "16 set, 5 possible in this picture");
    ASSERT_TRUE(rig.open({"Fixed level"}));
    rig.press({R::up, R::up});
    EXPECT_EQ(value(1), "2");
}

TEST_F(OperatorTest, BackKeepsWhatWasTurned) {
    ASSERT_TRUE(rig.open({"How it feels", "Lines and force", "Friction"}));
    rig.press({R::up, R::up, R::back});
    EXPECT_DOUBLE_EQ(rig.world().settings.friction, 0.2);
    EXPECT_FALSE(rig.state.is_held);
    EXPECT_EQ(rig.state.place, P::feel);
}

TEST_F(OperatorTest, WhoGoesAwayWhileTurningKeepsNothing) {
    ASSERT_TRUE(rig.open({"How it feels", "Lines and force", "Firmness"}));
    rig.press(R::up);
    EXPECT_EQ(rig.felt.stiffness_N_per_m, 550.0);
    rig.wait(301.0);
    EXPECT_EQ(rig.state.place, P::closed);
    EXPECT_EQ(rig.felt.stiffness_N_per_m, 500.0);
    EXPECT_EQ(rig.count<Leave>(), 1);
}

TEST_F(OperatorTest, ASwitchIsSwitchedAtOnce) {
    ASSERT_TRUE(rig.open({"How it feels", "Levels", "Level follows the hand"}));
    EXPECT_FALSE(rig.world().settings.is_level_automatic);
    EXPECT_NE(rig.heard().find("Level follows the hand, off, setting, 1 of 4"), std::string::npos);
}

/// The ceiling gets lower at once, higher only after a question, and never by leaving the screen.
TEST_F(OperatorTest, TheCeilingOfTheForceIsRaisedOnlyByASecondWord) {
    ASSERT_TRUE(rig.open({"How it feels", "Lines and force", "Greatest force"}));
    rig.press({R::down, R::down, R::select});
    EXPECT_DOUBLE_EQ(rig.world().settings.force_ceiling_N, 2.8);
    rig.press({R::select, R::up, R::up, R::select});
    EXPECT_EQ(rig.state.place, P::question);
    EXPECT_DOUBLE_EQ(rig.felt.force_ceiling_N, 2.8) << "not felt before the answer";
    rig.press(R::select);
    EXPECT_EQ(rig.state.place, P::feel) << "No is what has the focus";
    EXPECT_DOUBLE_EQ(rig.world().settings.force_ceiling_N, 2.8);
    ASSERT_TRUE(rig.open({"Greatest force"}));
    rig.press({R::up, R::back});
    EXPECT_EQ(rig.state.place, P::question) << "Back asks as well";
    rig.press({R::down, R::select});
    EXPECT_DOUBLE_EQ(rig.world().settings.force_ceiling_N, 2.9);
    for (int i = 0; i < 40; ++i) {
        ASSERT_TRUE(rig.open({"Greatest force"}));
        rig.press({R::up, R::up, R::select});
        if (rig.state.place == P::question) rig.press({R::down, R::select});
    }
    EXPECT_DOUBLE_EQ(rig.world().settings.force_ceiling_N, 3.0) << "the hard ceiling";
}

TEST_F(OperatorTest, WhatDoesNotGoTogetherIsRefused) {
    ASSERT_TRUE(rig.open({"How it feels", "Levels", "Coarsest level"}));
    for (int i = 0; i < 16; ++i) rig.press(R::down);
    rig.press(R::select);
    ASSERT_TRUE(rig.open({"Finest level"}));
    (void)rig.heard();
    rig.press(R::up);
    EXPECT_EQ(rig.heard(), "That does not go together with another setting.\n");
}

TEST_F(OperatorTest, WhatAProfileSetsIsNotTurnedBesideIt) {
    ASSERT_TRUE(rig.open({"How it feels", "Profiles", "child"}));
    EXPECT_EQ(rig.world().settings.profile, "child");
    rig.press(R::back);
    ASSERT_TRUE(rig.open({"Lines and force", "Firmness"}));
    EXPECT_NE(rig.heard().find("The profile in use sets this."), std::string::npos);
    EXPECT_FALSE(rig.state.is_held);
    ASSERT_TRUE(rig.open({"Friction"}));
    EXPECT_TRUE(rig.state.is_held) << "the profile says nothing of it";
}

TEST_F(OperatorTest, LanguagesAreSwitchedAndTheLastStays) {
    std::ofstream(rig.files.site) << "[language]\noffered = 'en de fr es'\n";
    ASSERT_TRUE(rig.open({"Sound, speech and languages", "Languages", "English"}));
    EXPECT_EQ(rig.world().settings.languages, "de fr es");
    EXPECT_EQ(rig.world().settings.first_language, "de");
    ASSERT_TRUE(rig.open({"Deutsch"}));
    ASSERT_TRUE(rig.open({"Français"}));
    ASSERT_TRUE(rig.open({"Español"}));
    EXPECT_EQ(rig.world().settings.languages, "es");
    ASSERT_TRUE(rig.open({"English", "First language"}));
    rig.press({R::up, R::select});
    EXPECT_EQ(rig.world().settings.first_language, "en");
}

TEST_F(OperatorTest, HoursAreTurnedByQuartersAndAreNeverNothing) {
    ASSERT_TRUE(rig.open({"Visits", "Hours", "Opening hours, from"}));
    for (int i = 0; i < 36; ++i) rig.press(R::up);
    rig.press(R::select);
    EXPECT_EQ(rig.world().settings.opening_hours, "09:00-24:00");
    ASSERT_TRUE(rig.open({"Opening hours, until"}));
    for (int i = 0; i < 60; ++i) rig.press(R::down);
    rig.press(R::select);
    EXPECT_EQ(rig.world().settings.opening_hours, "09:00-08:45") << "never the same as from";
    ASSERT_TRUE(rig.open({"Quiet hours"}));
    EXPECT_EQ(rig.world().settings.quiet_hours, "18:00-22:00");
}

/// A value that is said again sounds like one that has changed.
TEST_F(OperatorTest, TheEndOfAValueIsSaidAndTheValueIsNotRepeated) {
    ASSERT_TRUE(rig.open({"How it feels", "Lines and force", "Friction"}));
    for (int i = 0; i < 100; ++i) rig.press(R::down);
    (void)rig.heard();
    rig.press(R::down);
    EXPECT_EQ(rig.heard(), "It goes no further.\n");
    rig.press({R::select, R::back, R::back});
    ASSERT_TRUE(rig.open({"Sound, speech and languages", "Volume", "Headphones at the start"}));
    for (int i = 0; i < 100; ++i) rig.press(R::up);
    (void)rig.heard();
    rig.press(R::up);
    EXPECT_EQ(rig.heard(), "It goes no further.\n");
}

TEST_F(OperatorTest, VolumeKeepsTheRulesOfTheOutput) {
    ASSERT_TRUE(rig.open({"Sound, speech and languages", "Volume", "Headphones at the start"}));
    rig.press({R::up, R::up, R::up, R::select});
    EXPECT_EQ(rig.sound.headset.default_dB, 70.0);
    EXPECT_NE(rig.heard().find("It goes no further."), std::string::npos);
    ASSERT_TRUE(rig.open({"Speaker at the start"}));
    rig.press({R::up, R::select});
    EXPECT_EQ(rig.sound.speaker.default_dB, 65.0) << "no louder on a speaker (VO-2)";
    EXPECT_TRUE(check(rig.sound.speaker));
}

TEST_F(OperatorTest, TheWizardLearnsKeysAndKeepsTheOthers) {
    ASSERT_TRUE(rig.open({"Camera, keys and screen", "Keys", "Assign the keys"}));
    for (std::uint32_t i = 0; i < key_role_count; ++i)
        for (int twice = 0; twice < 2; ++twice) rig.press_key({KeySource::scancode, 200 + i});
    EXPECT_EQ(rig.state.place, P::keys);
    EXPECT_EQ(role_of(rig.keys, {KeySource::scancode, 205}), R::help);
    EXPECT_EQ(role_of(rig.keys, *key_named("enter")), R::select) << "the keyboard still works";
    EXPECT_FALSE(role_without_key(rig.keys));
}

TEST_F(OperatorTest, AWizardThatNobodyAnswersChangesNothing) {
    const KeyTable before = rig.keys;
    ASSERT_TRUE(rig.open({"Camera, keys and screen", "Keys", "Assign the keys"}));
    rig.press(R::select);
    rig.wait(21.0);
    EXPECT_EQ(rig.state.place, P::keys);
    EXPECT_EQ(rig.keys, before);
    EXPECT_EQ(rig.count<WriteKeys>(), 0);
}

TEST_F(OperatorTest, WhileTheHandleIsCleanedNoKeyCounts) {
    ASSERT_TRUE(rig.open({"Handle and tests", "Clean the handle", "Begin"}));
    EXPECT_EQ(rig.state.place, P::cleaning_lock);
    for (int i = 0; i < 8; ++i) rig.press({R::back, R::select, R::up, R::help});
    EXPECT_EQ(rig.state.place, P::cleaning_lock);
    rig.wait(60.0);
    EXPECT_EQ(rig.state.place, P::device);
    EXPECT_EQ(rig.count<LockHandle>(), 2);
    EXPECT_FALSE(std::get<LockHandle>(*std::find_if(rig.orders.rbegin(), rig.orders.rend(),
                                                    [](const OperatorOrder& order) {
                                                        return std::holds_alternative<LockHandle>(
                                                            order);
                                                    }))
                     .is_on);
}

TEST_F(OperatorTest, WhatIsShownLiveEndsWithItsScreen) {
    ASSERT_TRUE(rig.open({"Handle and tests", "What the handle is doing now"}));
    EXPECT_EQ(rig.screen().view, ScreenView::picture);
    EXPECT_EQ(rig.screen().items.front().name, "Force 0.5 newtons");
    rig.press(R::back);
    EXPECT_EQ(rig.count<ShowLive>(), 2);
    ASSERT_TRUE(rig.open({"What the handle is doing now"}));
    rig.wait(301.0);
    EXPECT_EQ(rig.count<ShowLive>(), 4) << "also when nobody leaves it";
}

TEST_F(OperatorTest, HomingIsFollowedOnItsPage) {
    ASSERT_TRUE(rig.open({"Handle and tests", "Find the handle’s starting point", "Begin"}));
    EXPECT_EQ(rig.count<FindHome>(), 1);
    rig.device_words = "Lead the handle to the right stop.";
    rig.wait(3.0);
    const std::string heard = rig.heard();
    const std::size_t said = heard.find(rig.device_words);
    EXPECT_NE(said, std::string::npos);
    EXPECT_EQ(heard.find(rig.device_words, said + 1), std::string::npos) << "once";
    EXPECT_NE(rig.screen().text.find("Lead the handle"), std::string::npos) << "shown as well";
    rig.device_words.clear();
    rig.wait(3.0);
    EXPECT_EQ(rig.heard(), "The handle is ready.\n");
    rig.press(R::back);
    (void)rig.heard();
    rig.device_words = "Lead the handle to the right stop.";
    rig.wait(3.0);
    EXPECT_EQ(rig.heard(), "") << "on its own page only";
}

/// An ordinary start, with nobody on that page.
TEST_F(OperatorTest, WhatTheHandleWaitsForIsSaidWhereItsHomeIsFound) {
    rig.device_words = "There is no force. Turn its plug round.";
    rig.wait(3.0);
    ASSERT_TRUE(rig.open({"Handle and tests", "Find the handle’s starting point"}));
    EXPECT_NE(rig.heard().find(rig.device_words), std::string::npos);
}

/// Nobody has said which kind of handle it is, so the kind is asked before the first homing.
TEST_F(OperatorTest, AHandleThatIsNewIsAskedForItsKindFirst) {
    rig.kind = "";
    ASSERT_TRUE(rig.open({"Handle and tests", "Find the handle’s starting point", "Begin"}));
    EXPECT_EQ(rig.count<FindHome>(), 0);
    EXPECT_EQ(rig.state.place, OperatorPlace::kind);
    EXPECT_NE(rig.heard().find("Kind of handle"), std::string::npos);
    ASSERT_TRUE(rig.open({"2diy 3.1, elbows in line with the motors"}));
    EXPECT_EQ(rig.state.place, OperatorPlace::homing);
    ASSERT_EQ(rig.count<ChooseKind>(), 1);
    for (const OperatorOrder& order : rig.orders) {
        const auto* const chosen = std::get_if<ChooseKind>(&order);
        if (chosen == nullptr) continue;
        EXPECT_EQ(chosen->profile, "2diy-gen3.1-180");
    }
}

TEST_F(OperatorTest, HowToTellAKindIsHeardBySixKeysAndChoosesNothing) {
    ASSERT_TRUE(rig.open({"Handle and tests", "Kind of handle"}));
    EXPECT_NE(rig.heard().find("Press Repeat to hear how to know each one."), std::string::npos);
    for (const KindRow& row : kind_rows()) {
        rig.press(R::repeat);
        EXPECT_NE(rig.heard().find(row.hint), std::string::npos) << row.name;
        rig.press(R::down);
    }
    EXPECT_EQ(rig.state.place, OperatorPlace::kind);
    EXPECT_EQ(rig.count<ChooseKind>(), 0);
    rig.press(R::help);
    EXPECT_NE(rig.heard().find("Press Repeat for an explanation"), std::string::npos);
}

/// Otherwise the measurements of the handle would be lost.
TEST_F(OperatorTest, AnotherKindIsMeasuredOnlyAfterAYes) {
    ASSERT_TRUE(rig.open({"Handle and tests", "Kind of handle", "Haplet"}));
    EXPECT_EQ(rig.state.place, OperatorPlace::question);
    EXPECT_NE(rig.heard().find("What was measured before is lost."), std::string::npos);
    for (const auto& no : {std::vector{R::select},
                           {R::back},
                           {R::repeat, R::back},
                           {R::help, R::down, R::repeat, R::back}}) {
        for (const R role : no) rig.press(role);
        EXPECT_EQ(rig.state.place, OperatorPlace::kind);
        EXPECT_EQ(rig.count<ChooseKind>(), 0);
        ASSERT_TRUE(rig.open({"Haplet"}));
    }
    ASSERT_TRUE(rig.open({"Yes"}));
    EXPECT_EQ(rig.state.place, OperatorPlace::homing);
    ASSERT_EQ(rig.count<ChooseKind>(), 1);
    for (const OperatorOrder& order : rig.orders)
        if (const auto* const chosen = std::get_if<ChooseKind>(&order)) {
            EXPECT_EQ(chosen->profile, "haplet");
        }
}

TEST_F(OperatorTest, TheKindInUseCanBeChosenAndChangesNothing) {
    rig.kind = "haplet";
    ASSERT_TRUE(rig.open({"Handle and tests", "Kind of handle", "Haplet"}));
    EXPECT_EQ(rig.state.place, OperatorPlace::kind);
    EXPECT_NE(rig.heard().find("It is of this kind already."), std::string::npos);
    EXPECT_EQ(rig.count<ChooseKind>(), 0);
}

TEST_F(OperatorTest, WhatAnActionMeansIsHeardBeforeItIsDone) {
    ASSERT_TRUE(rig.open({"Upkeep", "Log and recording"}));
    ASSERT_TRUE(rig.find("Save what was felt in the last minute"));
    (void)rig.heard();
    rig.press(R::repeat);
    EXPECT_NE(rig.heard().find("Ask the visitor first."), std::string::npos);
    EXPECT_EQ(rig.count<SaveRecording>(), 0);
}

TEST_F(OperatorTest, TheKindCanBeSaidAnewAndASimulatedHandleHasNone) {
    ASSERT_TRUE(rig.open({"Handle and tests", "Kind of handle"}));
    EXPECT_EQ(rig.screen().items.size(), kind_rows().size());
    EXPECT_EQ(rig.screen().items.front().value, "in use");
    rig.kind.reset();
    ASSERT_EQ(rig.screen().items.size(), 1U);
    EXPECT_EQ(rig.screen().items.front().name, "No handle with motors is plugged in.");
}

TEST(Kinds, EveryProfileCanBeChosen) {
    ASSERT_EQ(kind_rows().size(), device_profiles().size());
    for (const KindRow& row : kind_rows())
        EXPECT_TRUE(find_profile(row.profile).has_value()) << row.profile;
}

TEST_F(OperatorTest, UpkeepAsksBeforeItLosesAnything) {
    ASSERT_TRUE(rig.open({"Upkeep", "Visit counts", "Begin again from zero"}));
    EXPECT_EQ(rig.count<ZeroCounters>(), 0);
    rig.press(R::back);
    EXPECT_EQ(rig.state.place, P::counters) << "Back is No";
    ASSERT_TRUE(rig.open({"Begin again from zero", "Yes"}));
    EXPECT_EQ(rig.count<ZeroCounters>(), 1);
    rig.press(R::back);
    ASSERT_TRUE(rig.open({"Copy from a USB stick", "Letters"}));
    EXPECT_EQ(rig.count<ImportFromStick>(), 1);
    rig.press(R::back);
    ASSERT_TRUE(rig.open({"Shut the kiosk down", "Shut down", "No"}));
    EXPECT_EQ(rig.count<CloseKiosk>(), 0);
    ASSERT_TRUE(rig.open({"Shut down", "Yes"}));
    EXPECT_EQ(rig.count<CloseKiosk>(), 1);
}

TEST_F(OperatorTest, ABadBackupChangesNothingAndSaysWhy) {
    ASSERT_TRUE(rig.open({"How it feels", "Lines and force", "Friction"}));
    rig.press({R::up, R::select, R::back, R::back});
    ASSERT_TRUE(
        rig.open({"Upkeep", "Backup of the settings", "Bring the settings back from the copy"}));
    ASSERT_TRUE(rig.open({"Yes"}));
    EXPECT_NE(rig.heard().find(std::string(backup_name)), std::string::npos);
    EXPECT_DOUBLE_EQ(rig.world().settings.friction, 0.1);
    ASSERT_TRUE(rig.open({"Copy the settings", "Factory settings", "Yes"}));
    EXPECT_EQ(rig.world().settings, Settings{});
    ASSERT_TRUE(rig.open({"Bring the settings back from the copy", "Yes"}));
    EXPECT_DOUBLE_EQ(rig.world().settings.friction, 0.1);
}

}  // namespace
}  // namespace touchline
