#include "app/screen/marks.h"

#include "tests/app/screen/covered.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(Strokes, ALineCoversItsLengthAndItsRoundEnds) {
    Strokes strokes;
    strokes.add_line({100.0, 100.0}, {200.0, 100.0}, 10.0, {white_on_black.outline});
    EXPECT_EQ(stroke_count(strokes), 1);
    EXPECT_TRUE(covers(strokes, {150.0, 104.0}, white_on_black.outline));
    EXPECT_TRUE(covers(strokes, {96.0, 100.0}, white_on_black.outline));
    EXPECT_FALSE(covers(strokes, {96.0, 104.0}, white_on_black.outline));
    EXPECT_FALSE(covers(strokes, {150.0, 106.0}, white_on_black.outline));
}

TEST(Strokes, WhatIsNotFiniteDrawsNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Strokes strokes;
    strokes.add_line({nan, 0.0}, {1.0, 1.0}, 2.0, {white_on_black.outline});
    strokes.add(arrow({0.0, 0.0}, {nan, 1.0}, 2.0), 2.0, {white_on_black.outline});
    strokes.add_line({0.0, nan}, {0.0, nan}, 4.0, {white_on_black.outline});
    EXPECT_EQ(stroke_count(strokes), 0);
}

TEST(Strokes, AShortArrowIsNone) {
    Strokes strokes;
    strokes.add(arrow({0.0, 0.0}, {0.5, 0.0}, 2.0), 2.0, {white_on_black.force});
    EXPECT_EQ(stroke_count(strokes), 0);
}

TEST(Marks, OutlinesLieOnTheCurve) {
    Outline rectangle;
    rectangle.points = {{-0.03, -0.02}, {0.03, -0.02}, {0.03, 0.02}, {-0.03, 0.02}};
    rectangle.is_closed = true;
    TactileMap map;
    map.outlines = {rectangle};
    const auto curves = CurveSet::build(map, CurveOptions{});
    ASSERT_TRUE(curves.has_value());
    Strokes strokes;
    add_outlines(strokes, view, *curves, 0.0, 4.0);
    for (const Position p : {Position{0.0, -0.02}, {0.03, 0.0}, {-0.03, 0.013}, {0.03, 0.02}})
        EXPECT_TRUE(covers(strokes, view.to_px(p), white_on_black.outline));
    EXPECT_FALSE(covers(strokes, view.to_px({0.0, 0.0}), white_on_black.outline));
}

TEST(Marks, BoxesAreDrawnByTheirEdges) {
    ErrorBox box;
    box.corners = {Position{0.0, 0.0}, {0.01, 0.0}, {0.01, 0.005}, {0.0, 0.005}};
    Strokes strokes;
    add_boxes(strokes, view, std::vector{box}, 2.0);
    EXPECT_EQ(stroke_count(strokes), 4);
    EXPECT_TRUE(covers(strokes, view.to_px({0.005, 0.0}), white_on_black.box));
    EXPECT_FALSE(covers(strokes, view.to_px({0.005, 0.0025}), white_on_black.box));
}

TEST(Marks, TheHandIsRingDotAndArrow) {
    HandState hand;
    hand.p_WH = {0.0, 0.0};
    hand.p_WP = {0.0, 0.004};
    hand.force = {0.0, 2.0};
    Strokes strokes;
    add_hand(strokes, view, hand, 0.001, 2.0);
    EXPECT_TRUE(covers(strokes, view.to_px(hand.p_WP), white_on_black.proxy));
    EXPECT_TRUE(
        covers(strokes, view.to_px(hand.p_WH) + PixelPoint{10.0, 0.0}, white_on_black.handle));
    EXPECT_TRUE(
        covers(strokes, view.to_px(hand.p_WH) + PixelPoint{0.0, -100.0}, white_on_black.force));
}

TEST(Marks, AStrokeOfThePenIsThinAndOfItsOwnColour) {
    const std::vector<Position> stroke{{0.0, 0.0}, {1e-6, 0.0}, {0.01, 0.0}, {0.01, 0.01}};
    Strokes strokes;
    add_pen(strokes, view, stroke, 2.0);
    EXPECT_EQ(stroke_count(strokes), 2) << "what nobody can tell apart is left out";
    EXPECT_TRUE(covers(strokes, view.to_px({0.005, 0.0}), white_on_black.pen));
    EXPECT_FALSE(covers(strokes, view.to_px({0.005, 0.0}), white_on_black.outline));
    strokes.clear();
    add_pen(strokes, view, std::vector<Position>{{0.0, 0.0}}, 2.0);
    EXPECT_EQ(stroke_count(strokes), 1) << "a dot where the pen is put down";
    strokes.clear();
    add_pen(strokes, view, {}, 2.0);
    EXPECT_EQ(stroke_count(strokes), 0);
}

TEST(Marks, AHandThatIsNowhereDrawsNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    HandState hand;
    hand.p_WH = hand.p_WP = {nan, nan};
    Strokes strokes;
    add_hand(strokes, view, hand, 0.001, 2.0);
    EXPECT_EQ(stroke_count(strokes), 0);
}

}  // namespace
}  // namespace touchline
