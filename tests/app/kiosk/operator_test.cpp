// Tests the operator in the whole kiosk, by six keys and what is said, from a fresh install.
#include "config/settings/settings_text.h"
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(OperatorRun, FromAFreshInstallToPinStiffnessLevelsAndACopy) {
    KioskWorld world;
    BlindVisitor staff(world, 0.2);
    enter(staff);
    ASSERT_TRUE(world.kiosk().is_operator_in()) << staff.heard();
    enter_pin(staff);  // a new PIN, twice
    enter_pin(staff);
    staff.press(KeyRole::back);
    EXPECT_TRUE(fs::exists(world.site_files().pin));
    EXPECT_EQ(text_of(world.site_files().pin).find("1234"), std::string::npos);

    ASSERT_TRUE(staff.choose("How it feels")) << staff.heard();
    ASSERT_TRUE(staff.choose("Lines and force")) << staff.heard();
    ASSERT_TRUE(staff.choose("Firmness")) << staff.heard();
    staff.press(KeyRole::up);
    staff.press(KeyRole::select);
    const auto kept = apply_settings(Settings{}, text_of(world.site_files().settings.site), "site",
                                     SettingLayer::site);
    ASSERT_TRUE(kept.has_value()) << kept.error().line;
    EXPECT_GT(kept->stiffness_N_per_m, Settings{}.stiffness_N_per_m);

    staff.press(KeyRole::back);
    staff.press(KeyRole::back);
    ASSERT_TRUE(staff.choose("Upkeep")) << staff.heard();
    ASSERT_TRUE(staff.choose("Backup of the settings")) << staff.heard();
    ASSERT_TRUE(staff.choose("Copy the settings")) << staff.heard();
    EXPECT_TRUE(fs::exists(world.site_files().copies / "touchline-backup.txt")) << staff.heard();
    staff.press(KeyRole::back);
    staff.press(KeyRole::back);
    ASSERT_TRUE(staff.choose("Leave")) << staff.heard();
    EXPECT_FALSE(world.kiosk().is_operator_in());
    EXPECT_LE(staff.slowest_answer_s(), 0.3);
}

TEST(OperatorRun, SixKeysClearAnEmergencyStop) {
    KioskWorld world;
    world.kiosk().change_key({{KeySource::key, 'E'}, true, false, world.now_s()});
    ASSERT_TRUE(world.servo().commands().is_emergency_stop);
    const std::uint32_t cleared = world.servo().commands().faults_cleared;
    BlindVisitor staff(world, 0.2);
    open_menu(staff);
    ASSERT_TRUE(staff.choose("Handle and tests")) << staff.heard();
    EXPECT_TRUE(world.servo().commands().is_emergency_stop) << "not before it is chosen";
    ASSERT_TRUE(staff.choose("Reset the force fault")) << staff.heard();
    EXPECT_FALSE(world.servo().commands().is_emergency_stop);
    EXPECT_EQ(world.servo().commands().faults_cleared, cleared + 1);
}

TEST(OperatorRun, TheSelfTestUsesHandleSoundAndDisk) {
    KioskWorld world;
    const std::uint32_t patterns = world.servo().commands().pattern.serial;
    BlindVisitor staff(world, 0.2);
    open_menu(staff);
    ASSERT_TRUE(staff.choose("Handle and tests")) << staff.heard();
    ASSERT_TRUE(staff.choose("Self-test")) << staff.heard();
    ASSERT_TRUE(staff.choose("All steps")) << staff.heard();
    for (int i = 0; i < 30; ++i) {
        staff.press(KeyRole::select);
        world.run(1.0);
    }
    EXPECT_GT(world.servo().commands().pattern.serial, patterns) << "the motors were felt";
    EXPECT_GT(world.servo().most_force_N, 0.1);
    EXPECT_FALSE(world.servo().commands().is_force_wanted) << "afterwards";
    EXPECT_TRUE(world.heard().was_said("left"));
    EXPECT_TRUE(world.heard().was_said("right"));
    EXPECT_LE(world.servo().most_force_N, 1.2);
}

TEST(OperatorRun, AKindThatIsChosenReachesTheServoAndItsWordsTheOperator) {
    KioskWorld world;
    world.servo().own_kind = "mk2";
    BlindVisitor staff(world, 0.2);
    open_menu(staff);
    ASSERT_TRUE(staff.choose("Handle and tests")) << staff.heard();
    ASSERT_TRUE(staff.choose("Kind of handle")) << staff.heard();
    ASSERT_TRUE(staff.choose("Haplet")) << staff.heard();
    EXPECT_TRUE(world.servo().kinds_chosen.empty());
    ASSERT_TRUE(staff.choose("Yes")) << staff.heard();
    EXPECT_EQ(world.servo().kinds_chosen, std::vector<std::string>{"haplet"});
    EXPECT_EQ(world.servo().homings, 0);
    world.servo().words = "Now move the handle to the left, by a hand’s width.";
    world.run(0.2);
    EXPECT_TRUE(world.heard().was_said(world.servo().words));
    ASSERT_TRUE(staff.choose("Begin")) << staff.heard();
    EXPECT_EQ(world.servo().homings, 1);
    EXPECT_EQ(world.servo().kinds_chosen.size(), 1U);
}

/// Homing began with the kiosk; nobody pressed Begin.
TEST(OperatorRun, AWrongPlugIsToldOnThePagesOfTheHandle) {
    KioskWorld world;
    world.servo().words = "There is no force. Turn its plug round.";
    world.run(0.2);
    BlindVisitor staff(world, 0.2);
    open_menu(staff);
    ASSERT_TRUE(staff.choose("Handle and tests")) << staff.heard();
    ASSERT_TRUE(staff.choose("Find the handle’s starting point")) << staff.heard();
    EXPECT_NE(staff.heard().find(world.servo().words), std::string::npos) << staff.heard();
    staff.press(KeyRole::back);
    ASSERT_TRUE(staff.choose("What the handle is doing now")) << staff.heard();
    EXPECT_NE(staff.heard().find(world.servo().words), std::string::npos) << staff.heard();
}

/// A visitor would be told to call the staff.
TEST(OperatorRun, TheStaffAreToldWhatToDoAboutADeadHandle) {
    KioskWorld world;
    world.servo().words = "homing ended: the board was unplugged or gave up; plug it in";
    world.run(0.2);
    BlindVisitor staff(world, 0.2);
    open_menu(staff);
    const std::string told = "The handle is unplugged. Plug its cable in again.";
    ASSERT_TRUE(staff.choose("Handle and tests")) << staff.heard();
    ASSERT_TRUE(staff.choose("Find the handle’s starting point")) << staff.heard();
    EXPECT_NE(staff.heard().find(told), std::string::npos) << staff.heard();
    staff.press(KeyRole::back);
    ASSERT_TRUE(staff.choose("What the handle is doing now")) << staff.heard();
    EXPECT_NE(staff.heard().find(told), std::string::npos) << staff.heard();
    EXPECT_EQ(world.kiosk().live_facts().message, told);
}

/// Worst first: by the first words the operator knows what to do.
TEST(OperatorRun, TheFirstScreenIsTheStateOfTheKiosk) {
    KioskWorld world;
    fs::create_directories(world.folder() / "stick");  // else sticks come unnoticed
    world.servo().own_kind = "mk2";
    world.servo().words = "Lead the handle to the right stop.";
    world.run(3.0);
    BlindVisitor staff(world, 0.2);
    open_status(staff);
    EXPECT_NE(staff.heard().find("State of the kiosk. Something does not work. Press Back for the "
                                 "menu. Lead the handle to the right stop"),
              std::string::npos)
        << staff.heard();
    world.servo().words.clear();
    world.run(121.0);
    staff.press(KeyRole::help);
    EXPECT_NE(staff.heard().find("State of the kiosk. Everything a visitor needs is working."),
              std::string::npos)
        << "the network that does not ship is missing: " << staff.heard();
    EXPECT_TRUE(staff.find("Starting point found, 2 minutes ago")) << staff.heard();
    EXPECT_TRUE(staff.find("Faults today, 0")) << staff.heard();
    world.heard().problem = "There is no sound. Please call the staff.";
    world.run(0.2);
    staff.press(KeyRole::help);
    EXPECT_NE(staff.heard().find("Something does not work."), std::string::npos);
    EXPECT_EQ(world.kiosk().screen().items.front().name,
              "There is no sound. Check the cable of the speaker");
}

/// The motors move for an operator who chose to, and only while nothing else holds the force back.
TEST(OperatorRun, TheMotorsAreTestedFromTheFirstScreenWhileTheHandleIsLive) {
    KioskWorld world;
    world.servo().own_kind = "mk2";
    BlindVisitor staff(world, 0.2);
    open_status(staff);
    const std::uint32_t patterns = world.servo().commands().pattern.serial;
    world.servo().words = "There is no force. Turn its plug round.";
    world.run(0.2);
    ASSERT_TRUE(staff.choose("Motors")) << staff.heard();
    staff.press(KeyRole::select);
    EXPECT_NE(staff.heard().find("Motors failed. There is no force. Turn its plug round."),
              std::string::npos)
        << staff.heard();
    world.run(3.0);
    EXPECT_EQ(world.servo().commands().pattern.serial, patterns);
    EXPECT_EQ(world.servo().most_force_N, 0.0);
    world.servo().words.clear();
    world.run(0.2);
    ASSERT_TRUE(staff.choose("Motors, failed")) << staff.heard();
    world.run(3.0);
    EXPECT_EQ(world.servo().commands().pattern.serial, patterns) << "not before it is confirmed";
    staff.press(KeyRole::select);
    world.run(3.0);
    EXPECT_GT(world.servo().commands().pattern.serial, patterns);
    EXPECT_GT(world.servo().most_force_N, 0.1);
    EXPECT_LE(world.servo().most_force_N, 1.2);
    staff.press(KeyRole::select);
    EXPECT_NE(staff.heard().find("State of the kiosk."), std::string::npos) << staff.heard();
    ASSERT_TRUE(staff.choose("Sound on the left")) << staff.heard();
    staff.press(KeyRole::select);
    EXPECT_TRUE(world.heard().was_said("left\n"));
}

/// The emergency stop acts whoever uses the kiosk.
TEST(OperatorRun, TheEmergencyStopActsWhileTheOperatorIsIn) {
    KioskWorld world;
    BlindVisitor staff(world, 0.2);
    enter(staff);
    ASSERT_TRUE(world.kiosk().is_operator_in());
    world.kiosk().change_key({{KeySource::key, 'E'}, true, false, world.now_s()});
    EXPECT_TRUE(world.servo().commands().is_emergency_stop);
}

void strike(KioskWorld& world, char key) {
    const PhysicalKey struck{KeySource::key, static_cast<std::uint32_t>(key)};
    world.kiosk().change_key({struck, true, false, world.now_s()});
    world.kiosk().change_key({struck, false, false, world.now_s()});
    world.run(1.0);
}

void strike_r(KioskWorld& world) {
    strike(world, 'R');
}

/// The operator has chosen a PIN and left.
void choose_pin(KioskWorld& world) {
    BlindVisitor staff(world, 0.2);
    open_menu(staff);
    ASSERT_TRUE(staff.choose("Leave")) << staff.heard();
    ASSERT_FALSE(world.kiosk().is_operator_in());
}

/// Q asks first.
void confirm_quitting(KioskWorld& world) {
    EXPECT_FALSE(world.kiosk().window_wishes().is_quitting);
    for (const KeyRole role : {KeyRole::down, KeyRole::select}) world.kiosk().press(role);
}

/// What the operator's keys have ordered.
struct Ordered {
    bool is_stopped = false;
    std::uint32_t cleared = 0;
    int homings = 0;
    int held = 0;
    bool is_quitting = false;

    bool operator==(const Ordered&) const = default;
};

Ordered ordered(KioskWorld& world) {
    const ServoCommands& commands = world.servo().commands();
    return {commands.is_emergency_stop, commands.faults_cleared, world.servo().homings,
            world.servo().recordings_held, world.kiosk().window_wishes().is_quitting};
}

TEST(OperatorRun, AVisitorsKeyboardCanStopAndNeverStart) {
    KioskWorld world;
    choose_pin(world);
    strike(world, 'E');
    const Ordered stopped = ordered(world);
    ASSERT_TRUE(stopped.is_stopped);
    for (const char key : {'C', 'O', 'R', 'Q'}) {
        BlindVisitor visitor(world, 0.2);
        strike(world, key);
        EXPECT_EQ(ordered(world), stopped) << key;
        EXPECT_TRUE(world.heard().was_said("This key is the operator’s. Enter the PIN first."));
    }
}

TEST(OperatorRun, TheOperatorsOwnKeyboardNeedsNoPinForThem) {
    KioskWorld world;
    choose_pin(world);
    strike(world, 'E');
    const Ordered stopped = ordered(world);
    for (const char key : {'C', 'O', 'R', 'Q'})
        world.kiosk().strike_operator_key({KeySource::key, static_cast<std::uint32_t>(key)});
    confirm_quitting(world);
    EXPECT_EQ(ordered(world),
              (Ordered{false, stopped.cleared + 1, stopped.homings + 1, stopped.held + 1, true}));
}

TEST(OperatorRun, WhoGaveThePinUsesTheStaffsKeysAtAnyKeyboard) {
    KioskWorld world;
    choose_pin(world);
    strike(world, 'E');
    const Ordered stopped = ordered(world);
    BlindVisitor staff(world, 0.2);
    enter(staff);
    strike(world, 'C');  // the PIN is asked for
    EXPECT_EQ(ordered(world), stopped);
    enter_pin(staff);
    for (const char key : {'C', 'O', 'Q'}) strike(world, key);
    EXPECT_EQ(ordered(world),
              (Ordered{false, stopped.cleared + 1, stopped.homings + 1, stopped.held, true}));
}

/// On that screen any key can be assigned, and Q must not end the kiosk.
TEST(OperatorRun, AKeyThatIsLearnedIsNoOrder) {
    KioskWorld world;
    choose_pin(world);
    BlindVisitor staff(world, 0.2);
    enter(staff);
    enter_pin(staff);
    staff.press(KeyRole::back);
    ASSERT_TRUE(staff.choose("Camera, keys and screen")) << staff.heard();
    ASSERT_TRUE(staff.choose("Keys")) << staff.heard();
    ASSERT_TRUE(staff.choose("Assign the keys")) << staff.heard();
    strike(world, 'Q');
    EXPECT_FALSE(world.kiosk().window_wishes().is_quitting);
}

/// The keys are free as long as no PIN is set, and in a desktop window.
TEST(OperatorRun, WithoutAPinAndInAWindowTheKeysAreAnybodys) {
    for (const bool is_in_window : {false, true}) {
        KioskWorld world(is_in_window);
        if (is_in_window) choose_pin(world);
        strike(world, 'E');
        const Ordered stopped = ordered(world);
        for (const char key : {'C', 'O', 'R', 'Q'}) strike(world, key);
        EXPECT_TRUE(world.heard().was_said("The last minute of the handle is held in memory."));
        confirm_quitting(world);
        EXPECT_EQ(ordered(world), (Ordered{false, stopped.cleared + 1, stopped.homings + 1,
                                           stopped.held + 1, true}));
    }
}

/// Anybody at a keyboard may hold the last minute in memory; only the PIN lets one write a file.
TEST(OperatorRun, OnlyWhoGaveThePinSavesARecording) {
    KioskWorld world;
    strike_r(world);
    EXPECT_EQ(world.servo().recordings_held, 1);
    BlindVisitor staff(world, 0.2);
    enter(staff);
    strike_r(world);  // the PIN is asked for
    enter_pin(staff);
    strike_r(world);
    EXPECT_EQ(world.servo().recordings_kept, 0);
    enter_pin(staff);
    strike_r(world);
    EXPECT_EQ(world.servo().recordings_kept, 1);
    staff.press(KeyRole::back);
    ASSERT_TRUE(staff.choose("Upkeep")) << staff.heard();
    ASSERT_TRUE(staff.choose("Log and recording")) << staff.heard();
    ASSERT_TRUE(staff.choose("Save what was felt in the last minute")) << staff.heard();
    EXPECT_EQ(world.servo().recordings_kept, 2);
    world.servo().notice = "a recording was kept: /a/folder/recording-1.touchline";
    EXPECT_NE(world.kiosk().take_report().find("/a/folder/recording-1.touchline"),
              std::string::npos);
    EXPECT_TRUE(world.heard().was_said("The recording is saved."));
}

TEST(OperatorRun, AKeyboardThatIsNotTheOperatorsSavesNoRecording) {
    KioskWorld world;
    Settings settings;
    settings.operator_device = "/dev/input/by-id/the-operators";
    world.kiosk().set(settings);
    BlindVisitor staff(world, 0.2);
    const auto strike = [&](KeyRole role, int times) {
        for (int i = 0; i < times; ++i)
            world.kiosk().strike_operator_key(keys_of(default_keys(), role).at(0));
    };
    for (const KeyRole role :
         {KeyRole::help, KeyRole::up, KeyRole::up, KeyRole::down, KeyRole::down, KeyRole::select})
        strike(role, 1);
    for (int i = 0; i < 2; ++i) {
        for (int digit = 0; digit < 4; ++digit) {
            strike(KeyRole::up, 1);
            strike(KeyRole::select, 1);
        }
        strike(KeyRole::select, 1);
    }
    ASSERT_TRUE(world.kiosk().is_operator_in());
    strike_r(world);
    EXPECT_EQ(world.servo().recordings_kept, 0);
    world.kiosk().strike_operator_key({KeySource::key, 'R'});
    EXPECT_EQ(world.servo().recordings_kept, 1);
}

/// Nothing tells whether the headset is a headset, so only headphones that were noticed count.
TEST(OperatorRun, APinIsShownAndSpokenOnlyInHeadphonesThatWereNoticed) {
    for (const std::optional<bool> headphones :
         {std::optional<bool>(), std::optional(false), std::optional(true)}) {
        KioskWorld world;
        world.heard().headphones = headphones;
        world.run(0.2);
        BlindVisitor staff(world, 0.2);
        enter(staff);
        staff.press(KeyRole::up);
        EXPECT_EQ(staff.heard(), headphones == true ? "1\n" : "");
        EXPECT_EQ(world.kiosk().caption(), "1");
        staff.press(KeyRole::select);
        EXPECT_EQ(world.kiosk().caption(), "• ");
    }
}

/// The running visit neither asks nor shakes, and the operator's hand starts none.
TEST(OperatorRun, LeavesAVisitAsItWas) {
    KioskWorld world;
    BlindVisitor visitor(world);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    enter(visitor);
    ASSERT_TRUE(world.kiosk().is_operator_in());
    const std::uint32_t patterns = world.servo().commands().pattern.serial;
    for (int i = 0; i < 40; ++i) {
        world.servo().hand().move_to({i % 2 == 0 ? 0.01 : -0.01, 0.0});
        world.run(5.0);
    }
    EXPECT_TRUE(is_visit_on(world.kiosk().visit()));
    EXPECT_EQ(world.servo().commands().pattern.serial, patterns);
}

TEST(House, ClosesAndOpensByTheClock) {
    KioskWorld world;
    Settings settings;
    settings.opening_hours = "09:00-17:00";
    world.kiosk().set(settings);
    world.run(2.0);
    EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::attract);
    world.minute_of_day = 17 * 60;
    world.run(2.0);
    EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::closed);
    world.minute_of_day = 9 * 60;
    world.run(2.0);
    EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::attract);
}

TEST(House, IsSofterInQuietHours) {
    KioskWorld world;
    Settings settings;
    settings.quiet_hours = "20:00-08:00";
    settings.quiet_lower_dB = 9.0;
    world.kiosk().set(settings);
    world.run(2.0);
    EXPECT_EQ(world.heard().lower_dB, 0.0);
    world.minute_of_day = 23 * 60;
    world.run(2.0);
    EXPECT_EQ(world.heard().lower_dB, 9.0);
}

TEST(House, IsMaintainedUntilItIsNot) {
    KioskWorld world;
    Settings settings;
    settings.is_maintained = true;
    world.kiosk().set(settings);
    world.run(2.0);
    EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::closed);
    world.press(KeyRole::select);
    EXPECT_FALSE(is_visit_on(world.kiosk().visit()));
}

/// Somebody edits the site's file while the kiosk runs.
TEST(House, AFileOfSettingsThatChangesHoldsAtOnceAndABadOneDoesNot) {
    KioskWorld world;
    const fs::path site = world.site_files().settings.site;
    std::ofstream(site) << "[feel]\nforce_ceiling_N = 2\n";
    world.run(2.0);
    EXPECT_EQ(world.servo().commands().force_ceiling_N, 2.0);
    std::ofstream(site) << "[feel]\nforce_ceiling_N = 200000\n";
    world.run(2.0);
    EXPECT_EQ(world.servo().commands().force_ceiling_N, 2.0);
    const std::string report = world.kiosk().take_report();
    EXPECT_NE(report.find("force_ceiling_N"), std::string::npos) << report;
}

TEST(House, CountsVisitsAndPicturesButNobody) {
    KioskWorld world;
    BlindVisitor visitor(world);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    ASSERT_TRUE(visitor.choose("Gallery"));
    ASSERT_TRUE(visitor.choose_picture("A heart"));
    world.run(400.0);
    EXPECT_FALSE(is_visit_on(world.kiosk().visit()));
    const auto days = read_counters(world.site_files().counters);
    ASSERT_TRUE(days.has_value());
    ASSERT_EQ(days->size(), 1U);
    const auto& [day, counts] = days->front();
    EXPECT_EQ(day, world.today);
    EXPECT_EQ(counts.visits, 1U);
    EXPECT_EQ(counts.gallery_pictures, 1U);
    EXPECT_EQ(counts.stick_pictures, 0U);
    EXPECT_EQ(counts.faults, 0U);
    world.today += std::chrono::days(1);
    visitor.press(KeyRole::select);
    world.run(400.0);
    EXPECT_EQ(read_counters(world.site_files().counters).value().size(), 2U);
}

/// Who presses the emergency stop has a reason; the machine has none.
TEST(House, CountsFaultsAndNoEmergencyStop) {
    KioskWorld world;
    const auto faults = [&world] {
        return total_of(read_counters(world.site_files().counters).value()).faults;
    };
    strike(world, 'E');
    world.run(61.0);
    strike(world, 'C');
    EXPECT_EQ(faults(), 0U);
    world.heard().problem = "There is no sound.";
    world.run(61.0);
    EXPECT_EQ(faults(), 1U) << "however long it lasts";
    for (int i = 0; i < 3; ++i) {
        world.heard().problem = "";
        world.run(0.2);
        world.heard().problem = "There is no sound.";
        world.run(0.2);
    }
    world.run(1.0);
    EXPECT_EQ(faults(), 4U) << "kept where a crash cannot take them";
    BlindVisitor staff(world, 0.2);
    open_status(staff);
    EXPECT_TRUE(staff.find("Faults today, 4")) << staff.heard();
}

/// By ear, and as a table for a spreadsheet.
TEST(House, ItsDaysAreHeardAndCopied) {
    KioskWorld world;
    BlindVisitor visitor(world);
    for (int day = 0; day < 2; ++day) {
        world.today += std::chrono::days(3);
        visitor.press(KeyRole::select);
        world.run(400.0);
        ASSERT_FALSE(is_visit_on(world.kiosk().visit()));
    }
    BlindVisitor staff(world, 0.2);
    open_menu(staff);
    ASSERT_TRUE(staff.choose("Upkeep")) << staff.heard();
    ASSERT_TRUE(staff.choose("Visit counts")) << staff.heard();
    ASSERT_TRUE(staff.choose("Day by day")) << staff.heard();
    EXPECT_NE(staff.heard().find("today, 1 visit, 0 pictures, "), std::string::npos)
        << staff.heard();
    staff.press(KeyRole::down);
    EXPECT_EQ(staff.heard().find("3 days ago, 1 visit, 0 pictures, "), 0U) << staff.heard();
    staff.press(KeyRole::back);
    ASSERT_TRUE(staff.choose("Copy the days as a table")) << staff.heard();
    EXPECT_NE(staff.heard().find("The table is in copies."), std::string::npos) << staff.heard();
    EXPECT_EQ(text_of(world.site_files().copies / "touchline-days.csv"),
              text_of(world.site_files().counters));
}

}  // namespace
}  // namespace touchline
