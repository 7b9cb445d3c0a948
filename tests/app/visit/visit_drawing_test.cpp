// Tests a drawing that somebody makes for the visitor: what is felt, said and forgotten.
#include "tests/app/visit/visit_scenes.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

void to_drawing(FakeHouse& house) {
    to_choose(house);
    ASSERT_TRUE(house.choose("Draw for me"));
    ASSERT_EQ(house.open(), VisitScreen::picture);
    house.wait(0.1);
}

/// A straight line from left to right.
PenStroke stroke_at(double y_m) {
    return {{{-0.03, y_m}, {-0.01, y_m}, {0.01, y_m}, {0.03, y_m}}};
}

void draw(FakeHouse& house, double y_m) {
    house.apply(stroke_at(y_m));
    house.wait(0.1);
}

std::size_t line_count(const FakeHouse& house) {
    return house.visit.visitor.drawing ? house.visit.visitor.drawing->lines().size() : 0;
}

TEST(VisitDrawing, IsThereOnlyWhereTheHouseOffersIt) {
    EXPECT_FALSE(Settings{}.offers_drawing);
    FakeHouse house;
    house.settings.offers_drawing = false;
    to_choose(house);
    EXPECT_FALSE(has_item(house, VisitItem::draw_for_me));
    house.settings.offers_drawing = true;
    EXPECT_TRUE(has_item(house, VisitItem::draw_for_me));
}

TEST(VisitDrawing, BeginsEmptyWithForceAndTellsWhatItIs) {
    FakeHouse house;
    const std::size_t before = house.transcript.size();
    to_choose(house);
    ASSERT_TRUE(house.choose("Draw for me"));
    const auto felt = house.last<FeelDrawing>();
    ASSERT_EQ(felt.size(), 1U);
    EXPECT_NE(felt[0].map.drawing, 0U);
    EXPECT_TRUE(felt[0].map.outlines.empty());
    ASSERT_FALSE(house.last<Feel>().empty());
    EXPECT_TRUE(house.last<Feel>().back().is_force_wanted);
    EXPECT_TRUE(house.has_said("A drawing", before));
    EXPECT_TRUE(house.has_said("You feel each line once it is finished.", before));
    EXPECT_FALSE(has_item(house, VisitItem::zoom));
    EXPECT_FALSE(has_item(house, VisitItem::detail));
}

TEST(VisitDrawing, EachFinishedLineIsFeltAndSaidAfterWhatIsBeingSaid) {
    FakeHouse house;
    to_drawing(house);
    std::uint64_t drawing = 0;
    for (int number = 1; number <= 3; ++number) {
        house.apply(stroke_at(0.01 * number));
        const auto felt = house.last<FeelDrawing>();
        ASSERT_EQ(felt.size(), 1U);
        EXPECT_EQ(felt[0].map.outlines.size(), static_cast<std::size_t>(number));
        EXPECT_TRUE(drawing == 0 || felt[0].map.drawing == drawing);
        drawing = felt[0].map.drawing;
        EXPECT_EQ(house.last_said(), "Line " + std::to_string(number) + " is finished.");
        EXPECT_EQ(house.transcript.back().priority, SpeechPriority::hint);
        EXPECT_TRUE(house.last<Hush>().empty());
        EXPECT_TRUE(house.last<GivePattern>().empty()) << "it would push the hand";
        house.wait(0.1);
    }
    EXPECT_EQ(house.visit.visitor.felt->facts.parts.size(), 3U);
    house.press(KeyRole::repeat);
    EXPECT_EQ(house.last_said(), "Line 3 is finished.");
}

TEST(VisitDrawing, WhatTheDrawerDoesMovesNoFocusAndOpensNothing) {
    FakeHouse house;
    to_drawing(house);
    draw(house, 0.0);
    ASSERT_TRUE(house.find("Firmness"));
    house.press(KeyRole::select);
    ASSERT_EQ(house.open(), VisitScreen::values);
    EXPECT_EQ(house.screen().view, ScreenView::picture) << "who draws must see the drawing";
    const auto path = house.visit.visitor.path;
    draw(house, 0.01);
    EXPECT_EQ(line_count(house), 2U) << "a setting's values lie over the drawing, and end no line";
    EXPECT_EQ(house.open(), VisitScreen::values);
    house.press(KeyRole::back);
    const std::size_t focus = house.visit.visitor.path.back().focus;
    draw(house, 0.02);
    house.apply(DrawerKeyPressed{DrawerKey::undo});
    house.apply(DrawerKeyPressed{DrawerKey::redo});
    EXPECT_EQ(line_count(house), 3U);
    EXPECT_EQ(house.visit.visitor.path.back().focus, focus);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_EQ(path.size(), house.visit.visitor.path.size() + 1);
}

/// Two presses of the same key must not erase.
TEST(VisitDrawing, WhoBringsBackStandsOnUndoThen) {
    FakeHouse house;
    to_drawing(house);
    const auto focused = [&house] {
        const SpokenScreen screen = house.screen();
        return screen.items[*screen.focus].name;
    };
    draw(house, 0.0);
    draw(house, 0.02);
    house.apply(DrawerKeyPressed{DrawerKey::undo});
    ASSERT_TRUE(house.choose("Bring back what was undone"));
    EXPECT_EQ(focused(), "Undo in the drawing");
    ASSERT_TRUE(house.choose("Undo in the drawing"));
    EXPECT_EQ(focused(), "Undo in the drawing");
    house.press(KeyRole::select);  // takes the first line away, and the list of parts with it
    EXPECT_EQ(line_count(house), 0U);
    EXPECT_EQ(focused(), "Bring back what was undone");
    house.press(KeyRole::select);
    house.apply(HandleSeen{{0.0, 0.0005}, std::nullopt, true});
    ASSERT_TRUE(house.choose("Erase the line under my hand"));
    EXPECT_EQ(focused(), "Undo in the drawing") << "no line is left to erase";
}

/// With the first line come items that stand before the one that was heard.
TEST(VisitDrawing, ItemsThatComeAndGoMoveNoFocus) {
    FakeHouse house;
    to_drawing(house);
    const auto focused = [&house] {
        const SpokenScreen screen = house.screen();
        return screen.items[*screen.focus].name;
    };
    ASSERT_EQ(focused(), "Explore freely");
    draw(house, 0.0);
    EXPECT_EQ(focused(), "Explore freely");
    ASSERT_TRUE(has_item(house, VisitItem::parts));
    house.press(KeyRole::select);  // the screen that explores lies over it
    house.apply(DrawerKeyPressed{DrawerKey::undo});
    house.wait(0.1);
    house.press(KeyRole::back);
    EXPECT_FALSE(has_item(house, VisitItem::parts));
    EXPECT_EQ(focused(), "Explore freely");
}

TEST(VisitDrawing, TheEraserTakesTheNearestLineAndDeleteMakesThePenOneOnce) {
    FakeHouse house;
    to_drawing(house);
    for (const double y_m : {-0.02, 0.0, 0.02}) draw(house, y_m);
    house.apply(PenStroke{{{0.0, 0.001}}, true});
    EXPECT_EQ(house.last_said(), "Line 2 is gone.");
    EXPECT_EQ(line_count(house), 2U);
    house.apply(DrawerKeyPressed{DrawerKey::erase});
    EXPECT_EQ(house.last_said(), "With the pen, touch the line to erase.");
    house.apply(PenStroke{{{0.0, 0.019}}});
    EXPECT_EQ(house.last_said(), "Line 3 is gone.");
    draw(house, 0.03);
    EXPECT_EQ(house.last_said(), "Line 4 is finished.") << "Line 3 is gone, as was said";
    house.apply(PenStroke{{{0.0, -0.035}}, true});
    EXPECT_EQ(house.last_said(), "No line is near enough. Go closer to one.");
    EXPECT_EQ(line_count(house), 2U);
}

TEST(VisitDrawing, UndoAndRedoByKeysAndByTheVisitor) {
    FakeHouse house;
    to_drawing(house);
    EXPECT_FALSE(has_item(house, VisitItem::undo_line));
    draw(house, 0.0);
    draw(house, 0.02);
    house.apply(DrawerKeyPressed{DrawerKey::undo});
    EXPECT_EQ(house.last_said(), "Line 2 is gone.");
    house.apply(DrawerKeyPressed{DrawerKey::redo});
    EXPECT_EQ(house.last_said(), "Line 2 is back.");
    house.apply(DrawerKeyPressed{DrawerKey::redo});
    EXPECT_EQ(house.last_said(), "There is nothing to bring back.");
    ASSERT_TRUE(house.choose("Undo in the drawing"));
    EXPECT_TRUE(house.last_said().starts_with("Line 2 is gone.")) << house.last_said();
    ASSERT_TRUE(house.choose("Bring back what was undone"));
    EXPECT_TRUE(house.last_said().starts_with("Line 2 is back.")) << house.last_said();
    house.apply(HandleSeen{{0.0, 0.0005}, std::nullopt, true});
    ASSERT_TRUE(house.choose("Erase the line under my hand"));
    EXPECT_TRUE(house.last_said().starts_with("Line 1 is gone.")) << house.last_said();
}

TEST(VisitDrawing, WhatCannotBeDrawnIsToldAndChangesNothing) {
    FakeHouse house;
    to_drawing(house);
    house.apply(PenStroke{{{0.0, 0.0}, {0.001, 0.0}}});
    EXPECT_EQ(house.last_said(), "That line is too short to be felt.");
    EXPECT_TRUE(house.last<FeelDrawing>().empty());
    PenStroke scribble;
    for (int i = 0; i < 1000; ++i) scribble.points_W.push_back({i % 2 == 0 ? 0.05 : -0.05, 0.0});
    house.apply(scribble);
    EXPECT_EQ(house.last_said(), "That line was too long and was not taken. Draw it in parts.");
    house.apply(PenStroke{});
    EXPECT_EQ(line_count(house), 0U);
}

/// The visitor went back to the main menu while the pen was down.
TEST(VisitDrawing, AStrokeThatIsLostIsToldAndNeverFelt) {
    FakeHouse house;
    to_drawing(house);
    draw(house, 0.0);
    house.press(KeyRole::back);
    house.apply(StrokeLost{});
    EXPECT_EQ(house.last<GiveCue>()[0].event, ScreenEvent::key_refused);
    EXPECT_EQ(house.last_said(),
              "That line was not taken, for the drawing left the screen. Draw it again later.");
    EXPECT_EQ(house.transcript.back().priority, SpeechPriority::hint) << "the menu is said first";
    EXPECT_TRUE(house.last<FeelDrawing>().empty());
    EXPECT_EQ(house.open(), VisitScreen::choose);
    EXPECT_EQ(line_count(house), 1U);
    finish(house);
    const std::size_t before = house.transcript.size();
    house.apply(StrokeLost{});
    EXPECT_EQ(house.transcript.size(), before) << "nothing of it is told to the next visitor";
}

TEST(VisitDrawing, ThePenDoesNothingWithoutADrawing) {
    FakeHouse house;
    to_picture(house);
    const std::size_t before = house.transcript.size();
    draw(house, 0.0);
    EXPECT_EQ(house.transcript.size(), before);
    EXPECT_FALSE(house.visit.visitor.drawing);
    house.apply(DrawerKeyPressed{DrawerKey::undo});
    EXPECT_EQ(house.last<GiveCue>()[0].event, ScreenEvent::key_refused) << "a dead key";
}

TEST(VisitDrawing, BackKeepsItUntilAnotherPictureIsFelt) {
    FakeHouse house;
    to_drawing(house);
    draw(house, 0.0);
    house.press(KeyRole::back);
    ASSERT_EQ(house.open(), VisitScreen::choose);
    ASSERT_TRUE(house.choose("Back to the picture"));
    EXPECT_EQ(line_count(house), 1U);
    draw(house, 0.02);
    EXPECT_EQ(line_count(house), 2U);
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Practice shape"));
    house.wait(house.load_s + 0.1);
    EXPECT_FALSE(house.visit.visitor.drawing);
}

TEST(VisitDrawing, ASecondDrawingIsAnotherOne) {
    FakeHouse house;
    to_drawing(house);
    draw(house, 0.0);
    const std::uint64_t first = house.visit.visitor.drawing->id();
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Draw for me"));
    EXPECT_NE(house.visit.visitor.drawing->id(), first);
    EXPECT_EQ(line_count(house), 0U);
}

TEST(VisitDrawing, NothingOfItStaysAfterTheVisit) {
    FakeHouse house;
    to_drawing(house);
    draw(house, 0.0);
    finish(house);
    EXPECT_FALSE(house.visit.visitor.drawing);
    EXPECT_FALSE(house.visit.visitor.felt);
    EXPECT_EQ(house.visit.visitor.farewell.felt_count, 0);
}

/// A teacher who draws for longer than the kiosk waits, while the hand rests.
TEST(VisitDrawing, WhoDrawsIsThereAndAnswersTheQuestion) {
    FakeHouse house;
    to_drawing(house);
    for (int i = 0; i < 4; ++i) {
        house.wait(0.7 * house.rules.inactivity_s);
        draw(house, 0.01 * i);
        ASSERT_EQ(house.open(), VisitScreen::picture);
    }
    house.wait(house.rules.inactivity_s + 1.0);
    ASSERT_EQ(house.open(), VisitScreen::question);
    draw(house, -0.02);
    EXPECT_EQ(house.open(), VisitScreen::picture);
    EXPECT_EQ(line_count(house), 5U);
}

TEST(VisitDrawing, AnotherLanguageNamesTheLinesAnew) {
    FakeHouse house;
    to_drawing(house);
    draw(house, 0.0);
    house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Settings"));
    ASSERT_TRUE(house.choose("Language"));
    ASSERT_TRUE(house.choose("Deutsch"));
    house.wait(0.1);
    EXPECT_EQ(house.visit.visitor.felt->facts.title, "Eine Zeichnung");
    EXPECT_EQ(house.visit.visitor.felt->facts.parts[0].name, "Linie 1");
    EXPECT_EQ(line_count(house), 1U);
}

TEST(VisitDrawing, AHeldShapeIsPutDownFirst) {
    FakeHouse house;
    to_picture(house);
    ASSERT_TRUE(house.choose("Shape in the hand"));
    ASSERT_TRUE(house.choose("a bar"));
    ASSERT_EQ(house.visit.visitor.feel.shape, HeldShape::bar);
    while (house.open() != VisitScreen::choose) house.press(KeyRole::back);
    ASSERT_TRUE(house.choose("Draw for me"));
    EXPECT_EQ(house.visit.visitor.feel.shape, HeldShape::none);
    EXPECT_FALSE(has_item(house, VisitItem::held_shape));
}

}  // namespace
}  // namespace touchline
