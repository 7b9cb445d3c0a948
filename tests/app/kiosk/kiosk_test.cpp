// Tests what the kiosk carries out for a visit, and what it tells the visit and the log, with all
// its parts.
#include "app/kiosk/watched.h"
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include <gtest/gtest.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

TEST(Kiosk, SP1_AKeyBeginsAVisitWithSpeechAtOnce) {
    KioskWorld world;
    world.run(5.0);
    const auto before = world.heard().things.size();
    const double pressed_s = world.now_s();
    world.press(KeyRole::select);
    world.run(0.3);
    ASSERT_GT(world.heard().things.size(), before);
    EXPECT_FALSE(world.heard().text_since(before).empty());
    EXPECT_LE(world.heard().things[before].at_s - pressed_s, 0.3);
    EXPECT_TRUE(is_visit_on(world.kiosk().visit()));
}

/// The question shakes the handle, and what shakes is nobody.
TEST(Kiosk, TheQuestionDoesNotAnswerItself) {
    for (const Mode mode : {Mode::wall, Mode::groove, Mode::ridge, Mode::stay}) {
        KioskWorld world;
        Settings settings;
        settings.mode = mode;
        settings.two_switches = SwitchUse::move_and_select;
        settings.first_language = "fr";
        world.kiosk().set(settings);
        for (int presses = 0; presses < 3; ++presses) {
            world.press(KeyRole::select);
            world.run(0.5);  // a second press at once is the same one
        }
        world.run(3.0);
        ASSERT_EQ(open_screen(world.kiosk().visit()), VisitScreen::practice);
        world.run(90.0);
        EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::question);
        world.run(32.0);
        EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::goodbye)
            << static_cast<int>(mode);
    }
}

/// Another part of a visitor's picture comes from the same file, even if another file now has its
/// place in the list.
TEST(Kiosk, ADetailOfAPictureOfAStickThatWasPulledIsOfThatPicture) {
    KioskWorld world;
    BlindVisitor visitor(world);
    world.put_stick({TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures/07-house.svg"});
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    ASSERT_TRUE(visitor.choose("Your USB stick"));
    ASSERT_TRUE(visitor.choose("07 house"));
    const int felt = world.servo().felt_count;
    world.pull_stick();
    ASSERT_TRUE(visitor.choose("Enlargement")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Twice as large")) << visitor.heard();
    world.run(2.0);
    EXPECT_GT(world.servo().felt_count, felt) << visitor.heard();
}

/// The window system repeats a held key thirty times a second.
TEST(Kiosk, AKeyThatIsHeldJumpsOnceASecond) {
    KioskWorld world;
    BlindVisitor visitor(world);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    const PhysicalKey key = keys_of(default_keys(), KeyRole::down).at(0);
    const auto hold = [&](double for_s, bool is_first) {
        const double end_s = world.now_s() + for_s;
        for (bool is_repeat = !is_first; world.now_s() < end_s; is_repeat = true) {
            world.kiosk().change_key({key, true, is_repeat, world.now_s()});
            world.run(1.0 / 30.0);
        }
    };
    hold(0.9, true);
    EXPECT_EQ(world.kiosk().screen().focus, 1U) << "one press";
    hold(0.5, false);
    const std::size_t last = world.kiosk().screen().items.size() - 1;
    EXPECT_EQ(world.kiosk().screen().focus, std::min(items_on_screen, last));
    hold(3.0, false);
    EXPECT_EQ(world.kiosk().screen().focus, last) << "never over the end";
}

TEST(Kiosk, APictureGivenAtTheStartStaysAndIsToldByItsNameWithoutItsPath) {
    KioskWorld world;
    const fs::path bad = world.folder() / "my_letter.png";
    std::ofstream(bad) << "not a picture";
    world.kiosk().give(
        {file_at(TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures/07-house.svg"),
         file_at(bad.string())});
    for (int visit = 0; visit < 2; ++visit) {
        BlindVisitor visitor(world);
        visitor.press(KeyRole::select);
        ASSERT_TRUE(visitor.choose("English"));
        ASSERT_TRUE(visitor.choose("Your USB stick, 2 pictures")) << visitor.heard();
        const auto before = world.heard().things.size();
        ASSERT_TRUE(visitor.choose("my letter")) << visitor.heard();
        ASSERT_TRUE(visitor.wait_for("my letter cannot be opened. This file is not a picture"))
            << visitor.heard();
        EXPECT_FALSE(world.heard().was_said("/", before)) << world.heard().text_since(before);
        world.run(400.0);
        ASSERT_FALSE(is_visit_on(world.kiosk().visit()));
    }
}

/// The log never names a visitor's picture.
TEST(Kiosk, AFileOfAStickIsNotNamedInTheLog) {
    KioskWorld world;
    BlindVisitor visitor(world);
    const fs::path bad = world.folder() / "secret.png";
    std::ofstream(bad) << "not a picture";
    world.put_stick({bad});
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    ASSERT_TRUE(visitor.choose("Your USB stick"));
    (void)world.kiosk().take_report();  // about missing parts
    ASSERT_TRUE(visitor.choose("secret")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("This file is not a picture that can be felt."))
        << visitor.heard();
    EXPECT_EQ(world.kiosk().take_report(), "a visitor's picture cannot be felt\n");
}

/// A camera's card: its pictures are found in their folder and named by date, in the list and when
/// felt.
TEST(Kiosk, APictureOfACameraIsNamedByItsDateInTheVisitorsLanguage) {
    KioskWorld world;
    BlindVisitor visitor(world);
    fs::create_directories(world.folder() / "DCIM" / "100CANON");
    fs::copy(TOUCHLINE_SOURCE_DIR "/tests/app/kiosk/triangle.png",
             world.folder() / "DCIM" / "100CANON" / "IMG_20230405_101500.PNG");
    world.put_stick({world.folder() / "DCIM"});
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("Deutsch"));
    ASSERT_TRUE(visitor.choose("Ihr USB-Stick")) << visitor.heard();
    const auto before = world.heard().things.size();
    ASSERT_TRUE(visitor.choose("Foto vom f\u00fcnften April 2023, 10:15")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("entlangf\u00fchren lassen")) << visitor.heard();
    EXPECT_NE(world.heard().text_since(before).find("Foto vom f\u00fcnften April 2023, 10:15."),
              std::string::npos)
        << world.heard().text_since(before);
}

TEST(Kiosk, AStickThatComesAtGoodbyeIsTheNextVisitors) {
    KioskWorld world;
    BlindVisitor visitor(world);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    ASSERT_TRUE(visitor.choose("Finish"));
    ASSERT_TRUE(visitor.choose("Yes"));
    world.put_stick({TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures/07-house.svg"});
    world.run(30.0);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    EXPECT_TRUE(visitor.choose("Your USB stick, 1 picture")) << visitor.heard();
}

TEST(Watched, IsToldOnceAtEachChange) {
    Watched watched;
    EXPECT_FALSE(watched.headphones(std::nullopt));
    EXPECT_TRUE(watched.headphones(false));
    EXPECT_FALSE(watched.headphones(false));
    EXPECT_TRUE(watched.listing(true));
    EXPECT_FALSE(watched.listing(true));
    EXPECT_FALSE(watched.listing(false)) << "what was found tells it";
    EXPECT_FALSE(watched.trouble(TroubleKind::sound, ""));
    const auto began = watched.trouble(TroubleKind::sound, "There is no sound.");
    EXPECT_TRUE(began && std::holds_alternative<TroubleBegan>(*began));
    EXPECT_FALSE(watched.trouble(TroubleKind::sound, "There is no sound."));
    const auto ended = watched.trouble(TroubleKind::sound, "");
    EXPECT_TRUE(ended && std::holds_alternative<TroubleEnded>(*ended));
}

TEST(SiteHours, AreLookedAtOnceASecond) {
    int minute = 8 * 60;
    SiteHours hours([&minute] { return minute; });
    Settings settings;
    settings.opening_hours = "09:00-17:00";
    settings.quiet_hours = "08:00-09:00";
    const auto early = hours.look(0.0, settings);
    ASSERT_TRUE(early && early->change);
    EXPECT_EQ(early->change->opening, SiteOpening::closed);
    EXPECT_TRUE(early->is_quiet);
    minute = 10 * 60;
    EXPECT_FALSE(hours.look(0.9, settings));
    const auto late = hours.look(1.0, settings);
    ASSERT_TRUE(late && late->change);
    EXPECT_EQ(late->change->opening, SiteOpening::open);
    EXPECT_FALSE(late->is_quiet);
    hours.look_again();
    const auto again = hours.look(1.1, settings);
    ASSERT_TRUE(again);
    EXPECT_FALSE(again->change);
}

TEST(SiteHours, WithoutAClockAreAlwaysOpenAndNeverQuiet) {
    SiteHours hours({});
    Settings settings;
    settings.opening_hours = "09:00-17:00";
    settings.quiet_hours = "00:00-24:00";
    const auto now = hours.look(0.0, settings);
    ASSERT_TRUE(now);
    EXPECT_FALSE(now->change);
    EXPECT_FALSE(now->is_quiet);
}

TEST(VisitLength, IsKnownWhenTheVisitEnds) {
    VisitLength length;
    EXPECT_FALSE(length.step(false, 10.0));
    EXPECT_FALSE(length.step(true, 20.0));
    EXPECT_FALSE(length.step(true, 50.0));
    EXPECT_EQ(length.step(false, 80.0), 60.0);
    EXPECT_FALSE(length.step(false, 90.0));
}

TEST(MissingParts, ArePatientlyWaitedForAndToldOnce) {
    MissingParts missing;
    EXPECT_EQ(missing.step(Part::sound, false, 100.0), "");
    EXPECT_EQ(missing.step(Part::sound, false, 104.9), "");
    EXPECT_NE(missing.step(Part::sound, false, 105.0).find("no sound"), std::string::npos);
    EXPECT_EQ(missing.step(Part::sound, false, 200.0), "");
}

TEST(MissingParts, AreToldAgainOnlyOnceTheyWereThere) {
    MissingParts missing;
    EXPECT_EQ(missing.step(Part::camera, false, 0.0), "");
    EXPECT_EQ(missing.step(Part::camera, true, 4.0), "");
    EXPECT_EQ(missing.step(Part::camera, false, 6.0), "");
    EXPECT_NE(missing.step(Part::camera, false, 11.0), "");
    EXPECT_EQ(missing.step(Part::camera, true, 12.0), "");
    EXPECT_EQ(missing.step(Part::camera, false, 13.0), "");
    EXPECT_NE(missing.step(Part::camera, false, 18.0), "");
}

TEST(MissingParts, EachHasALineOfItsOwn) {
    MissingParts missing;
    for (const Part part : {Part::sticks, Part::sound, Part::camera})
        EXPECT_EQ(missing.step(part, false, 0.0), "");
    EXPECT_NE(missing.step(Part::sticks, false, 9.0).find("USB sticks"), std::string::npos);
    EXPECT_NE(missing.step(Part::sound, false, 9.0).find("sound"), std::string::npos);
    EXPECT_NE(missing.step(Part::camera, false, 9.0).find("camera"), std::string::npos);
}

TEST(MissingParts, ASoundThatGoesIsOneLineOfTheLog) {
    KioskWorld world;
    world.run(6.0);
    const std::string before = world.kiosk().take_report();
    EXPECT_EQ(before.find("no sound"), std::string::npos) << before;
    world.heard().problem = "There is no sound. Please call the staff.";
    world.run(6.0);
    const std::string after = world.kiosk().take_report();
    EXPECT_NE(after.find("there is no sound: "), std::string::npos) << after;
    world.run(6.0);
    EXPECT_EQ(world.kiosk().take_report(), "");
}

/// A folder stands in place of the counters' file, so writing fails for any user.
TEST(MissingParts, ADiskThatTakesNothingIsOneLine) {
    KioskWorld world;
    OperatorFiles files = world.site_files();
    std::filesystem::create_directories(files.counters.parent_path() / "write-test");
    std::vector<std::string> problems;
    const OperatorSession desk(files, {Language()}, problems);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(problems.front().find("nothing can be kept in"), std::string::npos) << problems[0];
}

TEST(MissingParts, AFolderForTheSiteIsMadeAndNothingIsSaid) {
    KioskWorld world;
    OperatorFiles files = world.site_files();
    files.counters = world.folder() / "new" / "counters.csv";
    std::vector<std::string> problems;
    const OperatorSession desk(files, {Language()}, problems);
    EXPECT_TRUE(problems.empty()) << problems.front();
}

}  // namespace
}  // namespace touchline
