// Tests what the kiosk carries out for a visit and what it tells the visit, with all its parts.
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <filesystem>
#include <fstream>

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

/// Another part of a visitor's picture comes from the same file, even if another file now has its
/// place in the list.
TEST(Kiosk, ADetailOfAPictureOfAStickThatWasPulledIsOfThatPicture) {
    KioskWorld world;
    BlindVisitor visitor(world);
    world.put_stick({TOUCHLINE_SOURCE_DIR "/app/gallery/pictures/07-house.svg"});
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
    ASSERT_TRUE(visitor.wait_for("This file is no picture that can be felt.")) << visitor.heard();
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
    world.put_stick({TOUCHLINE_SOURCE_DIR "/app/gallery/pictures/07-house.svg"});
    world.run(30.0);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English"));
    EXPECT_TRUE(visitor.choose("Your USB stick, 1 picture")) << visitor.heard();
}

}  // namespace
}  // namespace touchline
