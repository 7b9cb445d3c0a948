// Tests what the operator first hears: the state of the kiosk, the self-test and the counted days.
#include "app/operator/health.h"
#include "tests/app/operator/at_operator_menu.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

namespace touchline {
namespace {

class StatusTest : public AtOperatorMenu {};

KioskHealth sound_health() {
    KioskHealth health;
    health.handle = "device 2diy";
    health.has_motors = true;
    health.homed_ago_s = 7300.0;
    health.camera = CameraHealth::ready;
    health.version = "1.0.0";
    return health;
}

std::vector<std::string> names(const KioskHealth& health) {
    std::vector<std::string> found;
    for (const HealthLine& line : health_lines(health, Language())) found.push_back(line.name);
    return found;
}

TEST(Health, WhatDoesNotWorkComesFirstAndThenWhatIsWorthARemark) {
    KioskHealth health = sound_health();
    EXPECT_EQ(names(health), (std::vector<std::string>{"Handle", "Starting point found", "Sound",
                                                       "Camera", "USB stick", "Recognising photos",
                                                       "Faults today", "Started", "Version"}));
    health.can_keep = false;
    health.has_sound = false;
    health.faults_today = 2;
    health.homed_ago_s.reset();
    EXPECT_EQ(names(health),
              (std::vector<std::string>{"There is no sound. Check the cable of the speaker",
                                        "Nothing can be saved. Make room on the disk",
                                        "Starting point found", "Faults today", "Handle", "Camera",
                                        "USB stick", "Recognising photos", "Started", "Version"}));
}

TEST(Health, AHandleOfWhichNothingIsKnownStillHasAState) {
    KioskHealth health = sound_health();
    health.handle.clear();
    const auto lines = health_lines(health, Language());
    EXPECT_EQ(std::ranges::find(lines, "Handle", &HealthLine::name)->value, "working");
}

TEST(Health, ANetworkThatDoesNotShipIsOnlyRemarkedOn) {
    KioskHealth health = sound_health();
    health.networks = {1, false};
    const HealthLine line = health_lines(health, Language()).front();
    EXPECT_EQ(line.name + ", " + line.value, "Recognising photos, 1 file is missing");
    EXPECT_EQ(line.urgency, Urgency::remark);
}

TEST(Health, TimesAreSaidInTheirLargestUnit) {
    const auto started = [](double ago_s) {
        KioskHealth health = sound_health();
        health.started_ago_s = ago_s;
        const auto lines = health_lines(health, Language());
        return std::ranges::find(lines, "Started", &HealthLine::name)->value;
    };
    const auto times = std::to_array<std::pair<double, const char*>>({{0.0, "just now"},
                                                                      {59.9, "just now"},
                                                                      {60.0, "1 minute ago"},
                                                                      {3599.0, "59 minutes ago"},
                                                                      {3600.0, "1 hour ago"},
                                                                      {86'399.0, "23 hours ago"},
                                                                      {86'400.0, "1 day ago"},
                                                                      {1e9, "11574 days ago"}});
    for (const auto& [ago_s, said] : times) EXPECT_EQ(started(ago_s), said);
    EXPECT_EQ(started(std::numeric_limits<double>::quiet_NaN()), "just now");
}

TEST(Health, ThePrinterIsNamedOnceItIsKnown) {
    KioskHealth health = sound_health();
    EXPECT_EQ(std::ranges::count(names(health), "Printer"), 0);
    health.printer = PrintEnd::printed;
    EXPECT_EQ(std::ranges::count(names(health), "Printer"), 1);
    health.printer = PrintEnd::no_paper;
    EXPECT_EQ(names(health).front(), "The printer has no paper. Put some in");
}

/// Every line that needs somebody, in every language.
TEST(Health, TroublesAreSaidInEveryLanguage) {
    KioskHealth health = sound_health();
    health.has_sound = health.notices_sticks = health.can_keep = false;
    health.camera = CameraHealth::stopped;
    health.networks = {1, true};
    health.printer = PrintEnd::unknown;
    const auto english = health_lines(health, Language());
    ASSERT_EQ(std::ranges::count(english, Urgency::trouble, &HealthLine::urgency), 6);
    const std::vector<std::string> codes = languages_in(TOUCHLINE_CATALOGUES).value();
    for (const std::string& code : codes) {
        if (code == "en") continue;
        const auto lines = health_lines(health, Language::load(TOUCHLINE_CATALOGUES, code).value());
        for (std::size_t i = 0; i < 6; ++i) EXPECT_NE(lines[i].name, english[i].name) << code;
    }
}

TEST_F(StatusTest, IsWhatThePinOpensAndSaysTheWorstAtOnce) {
    rig.press(R::back);
    rig.health = sound_health();
    rig.enter();
    (void)rig.heard();
    rig.enter_pin("1234");
    EXPECT_TRUE(rig.heard().ends_with(
        "\nState of the kiosk. Everything works. Press Back for the menu. Handle, device 2diy, "
        "1 of 12\n"));
    rig.health.networks = {1, false};
    rig.press(R::help);
    EXPECT_TRUE(
        rig.heard().starts_with("State of the kiosk. Everything a visitor needs is working. "));
    rig.health.handle_trouble = "The handle is unplugged. Plug its cable in again.";
    rig.press(R::help);
    EXPECT_TRUE(rig.heard().starts_with(
        "State of the kiosk. Something does not work. Press Back for the menu. The handle is "
        "unplugged. Plug its cable in again, 1 of 12."));
    rig.press(R::select);
    EXPECT_EQ(rig.heard(), "The handle is unplugged. Plug its cable in again, 1 of 12\n");
    rig.press(R::back);
    EXPECT_EQ(rig.heard(), "Operator. State of the kiosk, 1 of 8\n");
}

TEST_F(StatusTest, ATestThatBeganThereLeadsBackThere) {
    ASSERT_TRUE(rig.open({"State of the kiosk", "Sound on the left"}));
    EXPECT_EQ(rig.count<RunTest>(), 0) << "not before it is confirmed";
    rig.press({R::select, R::select});
    EXPECT_EQ(rig.state.place, P::status);
    EXPECT_TRUE(rig.heard().ends_with("Sound on the left, passed, 8 of 10\n"));
    ASSERT_TRUE(rig.open({"Motors"}));
    rig.press(R::back);
    EXPECT_EQ(rig.state.place, P::status);
    EXPECT_EQ(rig.count<RunTest>(), 1);
}

/// All that is heard, key by key.
TEST_F(StatusTest, TheSelfTestIsWalkedByEar) {
    ASSERT_TRUE(rig.open({"Handle and tests", "Self-test"}));
    (void)rig.heard();
    const std::vector<std::pair<R, const char*>> walk{
        {R::select,
         "Circuit board of the handle. Checks whether the board of the handle answers.\n"
         "Circuit board of the handle passed. Motors. The motors push to both sides with at most 1 "
         "newton. "
         "Hold the handle lightly. Press Select to begin.\n"},
        {R::select, "Motors. Did the handle push to both sides? Yes, 1 of 2\n"},
        {R::select,
         "Motors passed. Camera. One photo is taken and not kept.\n"
         "Camera passed. Sound on the left. You will hear a sound from the left only. Press Select "
         "to begin.\n"},
        {R::select, "Sound on the left. Did you hear it on the left only? Yes, 1 of 2\n"},
        {R::down, "No, 2 of 2\n"},
        {R::select,
         "Sound on the left failed. Sound on the right. You will hear a sound from the right only. "
         "Press Select to begin.\n"},
        {R::down, "Skip, 2 of 2\n"},
        {R::select, "Keys. Press each of the six keys once. Press Back twice to stop.\n"},
        {R::up, "Up\n"},
        {R::down, "Down\n"},
        {R::back, "Back\n"},
        {R::repeat, "Repeat\n"},
        {R::select, "Select\n"},
        {R::help,
         "Keys passed. USB slot. Put in a USB stick within a minute. Press Select to begin.\n"},
        {R::select,
         "USB slot passed. Disk. A small file is written, read and removed.\n"
         "Disk passed. All steps are done. Self-test. Disk, passed, 9 of 9\n"}};
    for (const auto& [key, heard] : walk) {
        rig.press(key);
        EXPECT_EQ(rig.heard(), heard);
    }
    EXPECT_EQ(rig.state.place, P::self_test);
    using V = TestVerdict;
    EXPECT_EQ(rig.state.test.verdicts, (std::array{V::passed, V::passed, V::passed, V::failed,
                                                   V::untried, V::passed, V::passed, V::passed}));
}

TEST_F(StatusTest, ATestAloneThatPassesIsDoneAndHasTheFocus) {
    ASSERT_TRUE(rig.open({"Handle and tests", "Self-test"}));
    (void)rig.heard();
    ASSERT_TRUE(rig.open({"Camera"}));
    EXPECT_EQ(rig.state.place, P::self_test);
    EXPECT_EQ(rig.state.test.verdicts[2], TestVerdict::passed);
    EXPECT_TRUE(rig.heard().ends_with("Self-test. Camera, passed, 4 of 9\n"));
}

TEST_F(StatusTest, ATestWithoutAnAnswerFailsAndIsStopped) {
    rig.answers_tests = false;
    ASSERT_TRUE(rig.open({"Handle and tests", "Self-test", "Camera"}));
    rig.wait(61.0);
    EXPECT_EQ(rig.state.place, P::self_test);
    EXPECT_EQ(rig.count<StopTest>(), 1);
    EXPECT_NE(rig.heard().find("Camera failed. No answer came"), std::string::npos);
    rig.take(TestAnswered{TestStep::camera, true, ""});
    EXPECT_EQ(rig.state.test.verdicts[2], TestVerdict::failed) << "too late";
    ASSERT_TRUE(rig.open({"Keys"}));
    rig.press({R::up, R::down});
    rig.wait(61.0);
    EXPECT_NE(rig.heard().find("These were not pressed: Back, Repeat, Select, Help."),
              std::string::npos);
}

TEST_F(StatusTest, BackStopsATest) {
    rig.answers_tests = false;
    ASSERT_TRUE(rig.open({"Handle and tests", "Self-test", "Camera"}));
    rig.press(R::back);
    EXPECT_EQ(rig.state.place, P::self_test);
    EXPECT_EQ(rig.count<StopTest>(), 1);
    ASSERT_TRUE(rig.open({"Keys"}));
    rig.press({R::back, R::back});
    EXPECT_EQ(rig.state.place, P::self_test);
}

TEST_F(StatusTest, DaysAreListedFromTodayOnAndTheirSumIsBesideThem) {
    ASSERT_TRUE(rig.open({"Upkeep", "Visit counts", "Day by day"}));
    EXPECT_NE(rig.heard().find("Nothing was counted yet."), std::string::npos);
    for (int i = 40; i >= -1; --i)  // the clock was a day ahead once
        rig.days.push_back({rig.today - std::chrono::days(i), {1, 1, 2, 3, 1, 2}});
    const SpokenScreen shown = rig.screen();
    ASSERT_EQ(shown.items.size(), 31U);
    EXPECT_EQ(spoken_item(shown, 0, Language()),
              "today, 1 visit, 6 pictures, 1 minute, 2 faults, 1 of 31");
    EXPECT_EQ(shown.items[1].name, "yesterday");
    EXPECT_EQ(shown.items[2].name, "2 days ago");
    rig.press(R::back);
    EXPECT_EQ(rig.screen().items[1].name, "Visits");
    EXPECT_EQ(rig.screen().items[1].value, "42");
    ASSERT_TRUE(rig.open({"Copy the days as a table"}));
    EXPECT_EQ(rig.count<ExportCounters>(), 1);
}

}  // namespace
}  // namespace touchline
