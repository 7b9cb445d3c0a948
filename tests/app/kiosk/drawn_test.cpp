// What the kiosk gives to the screen to draw.
#include "tests/app/kiosk/kiosk_world.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double key_s = 0.2;  // a second press at once is the same one

/// Goes down to the item of this name and takes it.
void take_item(KioskWorld& world, const std::string& name) {
    for (std::size_t i = 0; i < 20; ++i) {
        const SpokenScreen screen = world.kiosk().screen();
        if (screen.focus && screen.items[*screen.focus].name == name) break;
        world.press(KeyRole::down);
        world.run(key_s);
    }
    world.press(KeyRole::select);
    world.run(key_s);
}

TEST(Drawn, AHandFeelsAPictureWhileNobodyIsHereAndNoLonger) {
    KioskWorld world;
    world.run(0.1);
    const DrawnPicture before = world.kiosk().drawn();
    ASSERT_NE(before.shown.scene, nullptr);
    world.run(1.0);
    EXPECT_GT(norm(world.kiosk().drawn().hand.p_WP - before.hand.p_WP), 0.005);
    world.press(KeyRole::select);
    EXPECT_EQ(world.kiosk().drawn().shown.scene, nullptr);
}

TEST(Drawn, TheServoMayRestWhileNobodyIsHereAndNoLonger) {
    KioskWorld world;
    world.run(0.1);
    EXPECT_TRUE(world.servo().commands().may_rest);
    EXPECT_FALSE(world.servo().commands().is_force_wanted);
    world.press(KeyRole::select);
    EXPECT_FALSE(world.servo().commands().may_rest);
}

TEST(Drawn, EachPictureOfTheGalleryHasItsLines) {
    KioskWorld world;
    world.run(0.1);
    world.press(KeyRole::select);
    world.run(key_s);
    EXPECT_TRUE(world.kiosk().pictures_of(world.kiosk().screen()).empty());
    take_item(world, "English");
    take_item(world, "Gallery");
    take_item(world, "very easy");
    const auto pictures = world.kiosk().pictures_of(world.kiosk().screen());
    EXPECT_GE(std::ranges::count_if(pictures, [](const auto& lines) { return lines != nullptr; }),
              5);
    ASSERT_FALSE(pictures.empty());
    EXPECT_EQ(pictures.back(), nullptr);  // the way back
}

/// How many items of the open screen have lines.
std::ptrdiff_t drawn_items(KioskWorld& world) {
    const auto pictures = world.kiosk().pictures_of(world.kiosk().screen());
    return std::ranges::count_if(pictures, [](const auto& lines) { return lines != nullptr; });
}

void enter_stick(KioskWorld& world) {
    world.press(KeyRole::select);
    world.run(key_s);
    take_item(world, "English");
    take_item(world, "Your USB stick");
}

TEST(Drawn, APictureOfAStickHasItsLinesOnceItWasFeltAndNotForTheNextVisitor) {
    const std::string gallery = TOUCHLINE_SOURCE_DIR "/app/documents/gallery/pictures/";
    KioskWorld world;
    world.run(0.1);
    world.put_stick({gallery + "06-fish.svg", gallery + "07-house.svg"});
    enter_stick(world);
    world.run(1.0);
    EXPECT_EQ(drawn_items(world), 0);
    world.press(KeyRole::select);
    world.run(3.0);
    ASSERT_TRUE(world.kiosk().visit().visitor.felt);
    take_item(world, "Another picture");
    ASSERT_EQ(open_screen(world.kiosk().visit()), VisitScreen::stick);
    const auto pictures = world.kiosk().pictures_of(world.kiosk().screen());
    ASSERT_EQ(pictures.size(), 3U);
    EXPECT_NE(pictures[0], nullptr);
    EXPECT_EQ(drawn_items(world), 1) << "the other one was not opened";
    for (int i = 0; i < 2; ++i) {
        world.press(KeyRole::back);
        world.run(key_s);
    }
    take_item(world, "Yes");
    enter_stick(world);
    world.run(1.0);
    ASSERT_EQ(open_screen(world.kiosk().visit()), VisitScreen::stick);
    EXPECT_EQ(drawn_items(world), 0);
}

TEST(Drawn, TheLiveViewTellsTheTitleOfWhatIsFelt) {
    KioskWorld world;
    world.run(0.1);
    world.press(KeyRole::select);
    world.run(key_s);
    take_item(world, "English");
    take_item(world, "Practice shape");
    world.run(3.0);
    ASSERT_TRUE(world.kiosk().visit().visitor.felt);
    EXPECT_EQ(world.kiosk().live_facts().title, world.kiosk().visit().visitor.felt->facts.title);
    EXPECT_FALSE(world.kiosk().live_facts().title.empty());
}

}  // namespace
}  // namespace touchline
