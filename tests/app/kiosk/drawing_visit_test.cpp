// Tests a lesson: a teacher draws a house line by line while the visitor's hand rests on it and
// moves over it, through the production servo (S15: a line that grows never pushes a resting hand).
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

// What a resting hand may be told by: of the force in a tick as in haptics/servo, and how far the
// handle may move.
constexpr double most_change_N = 0.021;
constexpr double most_shift_m = 1e-4;

constexpr Position floor_left{-0.03, -0.025};
constexpr Position floor_right{0.03, -0.025};
constexpr Position eaves_left{-0.03, 0.01};
constexpr Position eaves_right{0.03, 0.01};
constexpr Position ridge_top{0.0, 0.035};

void offer_drawing(KioskWorld& world) {
    Settings settings;
    settings.offers_drawing = true;
    world.kiosk().set(settings);
}

void to_drawing(KioskWorld& world, BlindVisitor& visitor) {
    offer_drawing(world);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Draw for me")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("You feel each line once it is finished.")) << visitor.heard();
    world.run(2.0);  // force is on
}

/// A pen that takes a second for the line, frame by frame, as the window tells of it.
void draw(KioskWorld& world, Position from, Position to) {
    constexpr int steps = 60;
    world.kiosk().change_pen({PenMotion::press, from});
    for (int i = 1; i <= steps; ++i) {
        world.kiosk().change_pen(
            {PenMotion::move, from + (static_cast<double>(i) / steps) * (to - from)});
        world.run(1.0 / steps);
    }
    world.kiosk().change_pen({PenMotion::lift, to});
}

/// The largest change of force from tick to tick, and how long there was none.
struct Felt {
    explicit Felt(KioskWorld& of) : world(of), last(of.kiosk().hand()) {
        world.servo().on_tick = [this](const HandState& hand) { see(hand); };
    }

    ~Felt() { world.servo().on_tick = {}; }

    Felt(const Felt&) = delete;
    Felt& operator=(const Felt&) = delete;

    void see(const HandState& hand) {
        most_N = std::max(most_N, norm(hand.force - last.force));
        silent_ticks += hand.force == Force{} ? 1 : 0;
        last = hand;
    }

    KioskWorld& world;
    HandState last;
    double most_N = 0.0;
    int silent_ticks = 0;
};

std::size_t lines_felt(KioskWorld& world) {
    return world.servo().picture().map->outlines.size();
}

/// The hand may be anywhere, on the new line too: it is not pushed while it rests.
TEST(DrawingVisit, NoLineOfAHousePushesTheHandThatRestsThere) {
    WallWorld world;
    BlindVisitor visitor(world);
    to_drawing(world, visitor);
    const std::vector<std::pair<Position, Position>> house{
        {floor_left, floor_right}, {floor_left, eaves_left},   {eaves_left, ridge_top},
        {ridge_top, eaves_right},  {eaves_right, floor_right}, {eaves_left, eaves_right}};
    int number = 0;
    for (const auto& [from, to] : house) {
        lead_hand(world, 0.5 * (from + to) + Position{0.0, 0.0007});
        world.run(0.5);
        const Position before = world.servo().handle_W();
        {
            const Felt felt(world);
            draw(world, from, to);
            world.run(1.5);
            EXPECT_LE(felt.most_N, most_change_N) << "line " << number + 1;
        }
        EXPECT_LE(norm(world.servo().handle_W() - before), most_shift_m) << "line " << number + 1;
        EXPECT_EQ(lines_felt(world), static_cast<std::size_t>(++number));
        EXPECT_NE(visitor.heard().find("Line " + std::to_string(number) + " is finished."),
                  std::string::npos)
            << visitor.heard();
        EXPECT_EQ(world.kiosk().force().state, ForceState::live);
    }
    EXPECT_EQ(world.kiosk().force().fault, Fault::none);
    EXPECT_LE(world.servo().most_force_N, 3.0);
}

/// The hand goes along the floor while the rest is drawn. Each tick changes the force by no more
/// than it does for a hand that goes there when nobody draws, and the floor never fades.
TEST(DrawingVisit, AHandThatMovesFeelsNoJumpAndThenTheNewLine) {
    WallWorld world;
    BlindVisitor visitor(world);
    to_drawing(world, visitor);
    lead_hand(world, {0.0, 0.0});
    draw(world, floor_left, floor_right);
    world.run(0.5);
    const auto go_along_the_floor = [&](bool is_drawing) {
        lead_hand(world, floor_right - Position{0.005, 0.001});
        const Felt felt(world);
        for (int turn = 0; turn < 2; ++turn) {
            lead_hand(world, floor_left + Position{0.005, 0.001});
            if (is_drawing) world.kiosk().change_pen({PenMotion::press, eaves_left});
            lead_hand(world, 0.5 * (floor_left + floor_right));
            if (is_drawing) world.kiosk().change_pen({PenMotion::move, ridge_top});
            if (is_drawing) world.kiosk().change_pen({PenMotion::lift, ridge_top});
            lead_hand(world, floor_right - Position{0.005, 0.001});
        }
        return std::pair{felt.most_N, felt.silent_ticks};
    };
    const auto alone = go_along_the_floor(false);
    const auto beside_a_pen = go_along_the_floor(true);
    EXPECT_LE(beside_a_pen.first, alone.first + most_change_N);
    EXPECT_EQ(beside_a_pen.second, 0) << "ticks without force";
    EXPECT_EQ(world.kiosk().force().state, ForceState::live);
    // And the roof is there now: its groove pulls a hand beside it.
    const Position beside = 0.5 * (eaves_left + ridge_top) + Position{0.0, 0.0025};
    lead_hand(world, {0.0, 0.0});
    lead_hand(world, beside);
    world.run(0.5);
    EXPECT_EQ(world.kiosk().hand().map_version, world.servo().picture().map->version);
    EXPECT_GT(norm(world.kiosk().hand().force), 0.1);
}

TEST(DrawingVisit, KeysAndTheSecondButtonEraseAndUndo) {
    WallWorld world;
    BlindVisitor visitor(world);
    to_drawing(world, visitor);
    draw(world, floor_left, floor_right);
    draw(world, floor_left, eaves_left);
    const auto strike = [&world](Key key) {
        const PhysicalKey struck{KeySource::key, static_cast<std::uint32_t>(key)};
        world.kiosk().change_key({struck, true, false, world.now_s()});
        world.kiosk().change_key({struck, false, false, world.now_s()});
        world.run(0.5);
    };
    strike(Key{'U'});
    EXPECT_EQ(lines_felt(world), 1U);
    strike(Key{'Y'});
    EXPECT_EQ(lines_felt(world), 2U);
    strike(Key::remove);
    world.kiosk().change_pen({PenMotion::press, {0.0, -0.024}});
    world.kiosk().change_pen({PenMotion::lift, {0.0, -0.024}});
    EXPECT_EQ(lines_felt(world), 1U);
    world.kiosk().change_pen({PenMotion::press, 0.5 * (floor_left + eaves_left), true});
    EXPECT_EQ(lines_felt(world), 0U);
    EXPECT_EQ(open_screen(world.kiosk().visit()), VisitScreen::picture);
    EXPECT_EQ(world.kiosk().force().fault, Fault::none);
}

TEST(DrawingVisit, ALineUnderTheHandSaysItsNumber) {
    WallWorld world;
    BlindVisitor visitor(world);
    to_drawing(world, visitor);
    draw(world, floor_left, floor_right);
    draw(world, eaves_left, eaves_right);
    ASSERT_TRUE(visitor.choose("Explore freely")) << visitor.heard();
    draw(world, eaves_left, ridge_top);
    EXPECT_EQ(lines_felt(world), 3U) << "the picture is on the screen there too";
    lead_hand(world, {0.01, 0.0});
    visitor.press(KeyRole::repeat);
    lead_hand(world, {0.01, 0.0097});
    EXPECT_TRUE(visitor.wait_for("Line 2", 3.0)) << visitor.heard();
}

TEST(DrawingVisit, ThePenDrawsOnlyOnADrawingThatIsOnTheScreen) {
    WallWorld world;
    BlindVisitor visitor(world);
    draw(world, floor_left, floor_right);
    EXPECT_FALSE(world.kiosk().pen().is_down());
    to_drawing(world, visitor);
    world.kiosk().change_pen({PenMotion::press, floor_left});
    world.kiosk().change_pen({PenMotion::move, floor_right});
    EXPECT_TRUE(world.kiosk().pen().is_down());
    visitor.press(KeyRole::back);  // the visitor leaves while the pen is down
    EXPECT_FALSE(world.kiosk().takes_pen());
    EXPECT_FALSE(world.kiosk().pen().is_down());
    EXPECT_TRUE(visitor.wait_for("That line was not taken, for the drawing left the screen."))
        << visitor.heard();
    world.kiosk().change_pen({PenMotion::lift, floor_right});
    EXPECT_EQ(lines_felt(world), 0U);
    // A pen that was up has lost nothing.
    ASSERT_TRUE(visitor.choose("Back to the picture")) << visitor.heard();
    draw(world, floor_left, floor_right);
    const std::size_t before = world.heard().things.size();
    visitor.press(KeyRole::back);
    world.run(3.0);
    EXPECT_FALSE(world.heard().was_said("That line was not taken", before)) << visitor.heard();
    EXPECT_EQ(lines_felt(world), 1U);
}

TEST(DrawingVisit, AVisitorWhoSetsTheFirmnessEndsNoStroke) {
    WallWorld world;
    BlindVisitor visitor(world);
    to_drawing(world, visitor);
    world.kiosk().change_pen({PenMotion::press, floor_left});
    world.kiosk().change_pen({PenMotion::move, floor_right});
    ASSERT_TRUE(visitor.choose("Firmness")) << visitor.heard();
    ASSERT_EQ(open_screen(world.kiosk().visit()), VisitScreen::values);
    EXPECT_TRUE(world.kiosk().pen().is_down());
    world.kiosk().change_pen({PenMotion::lift, floor_right});
    EXPECT_EQ(lines_felt(world), 1U);
    EXPECT_TRUE(visitor.wait_for("Line 1 is finished.")) << visitor.heard();
}

/// The operator keeps it; a technician brings it back on a stick, and it is felt as it was drawn.
TEST(DrawingVisit, WhatTheOperatorKeepsIsAPictureThatTheKioskOpensAgain) {
    WallWorld world;
    BlindVisitor visitor(world);
    to_drawing(world, visitor);
    const auto copies = [&world] { return world.site_files().copies; };
    BlindVisitor staff(world, 0.2);
    open_menu(staff);
    ASSERT_TRUE(staff.choose("Upkeep")) << staff.heard();
    ASSERT_TRUE(staff.choose("Keep the drawing")) << staff.heard();
    EXPECT_TRUE(world.heard().was_said("There is no drawing to keep.")) << "no line is drawn yet";
    EXPECT_FALSE(std::filesystem::exists(copies() / "touchline-drawing-1.svg"));
    staff.press(KeyRole::back);
    staff.press(KeyRole::back);
    ASSERT_FALSE(world.kiosk().is_operator_in());
    while (open_screen(world.kiosk().visit()) != VisitScreen::picture) visitor.press(KeyRole::back);
    draw(world, floor_left, floor_right);
    draw(world, eaves_left, ridge_top);
    const TactileMap drawn = *world.servo().picture().map;
    enter(staff);
    enter_pin(staff);
    staff.press(KeyRole::back);
    ASSERT_TRUE(staff.choose("Upkeep")) << staff.heard();
    for (const int number : {1, 2}) {
        ASSERT_TRUE(staff.choose("Keep the drawing")) << staff.heard();
        EXPECT_TRUE(world.heard().was_said("The drawing is in copies."));
        EXPECT_TRUE(std::filesystem::exists(
            copies() / ("touchline-drawing-" + std::to_string(number) + ".svg")));
    }
    staff.press(KeyRole::back);
    staff.press(KeyRole::back);

    world.put_stick({copies() / "touchline-drawing-1.svg"});
    while (open_screen(world.kiosk().visit()) != VisitScreen::choose) visitor.press(KeyRole::back);
    ASSERT_TRUE(visitor.choose("Your USB stick")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("touchline drawing 1")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("2 outlines")) << visitor.heard();
    const TactileMap& opened = *world.servo().picture().map;
    EXPECT_EQ(opened.drawing, 0U) << "it grows no more";
    ASSERT_EQ(opened.outlines.size(), drawn.outlines.size());
    for (std::size_t i = 0; i < drawn.outlines.size(); ++i) {
        EXPECT_EQ(opened.outlines[i].points, drawn.outlines[i].points);
        EXPECT_EQ(opened.outlines[i].label, drawn.outlines[i].label);
    }
}

TEST(DrawingVisit, NothingOfItStaysForTheNextVisitor) {
    WallWorld world;
    BlindVisitor visitor(world);
    to_drawing(world, visitor);
    draw(world, floor_left, floor_right);
    world.kiosk().change_pen({PenMotion::press, eaves_left});
    world.run(400.0);  // nobody answers
    EXPECT_FALSE(is_visit_on(world.kiosk().visit()));
    EXPECT_FALSE(world.kiosk().visit().visitor.drawing);
    EXPECT_FALSE(world.kiosk().pen().is_down());
    EXPECT_EQ(lines_felt(world), 0U);
    EXPECT_EQ(world.servo().picture().map->drawing, 0U);
    EXPECT_EQ(world.servo().recordings_forgotten, 1);
    EXPECT_FALSE(world.heard().was_said("That line was not taken"));
}

}  // namespace
}  // namespace touchline
