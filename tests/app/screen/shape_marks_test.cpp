// Tests how a shape in the hand is drawn.
#include "app/screen/marks.h"
#include "tests/app/screen/covered.h"

#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double unit_px = 2.0;

HandState with_bar() {
    HandState hand;
    hand.shape = HeldShape::bar;
    hand.is_shape_placed = true;
    hand.p_WH = {0.0, 0.0};
    hand.p_WP = {0.0, 0.006};
    return hand;
}

Strokes drawn(const HandState& hand) {
    Strokes strokes;
    add_shape(strokes, view, hand, unit_px, white_on_black);
    return strokes;
}

TEST(ShapeMarks, APointIsNoShape) {
    EXPECT_EQ(stroke_count(drawn({})), 0);
}

TEST(ShapeMarks, TheShapeIsBoldWhereLinesHoldItAndThinWhereTheHandWouldHaveIt) {
    const Strokes strokes = drawn(with_bar());
    EXPECT_TRUE(covers(strokes, view.to_px({0.008, 0.004}), white_on_black.proxy));
    EXPECT_TRUE(covers(strokes, view.to_px({0.008, -0.002}), white_on_black.handle));
    EXPECT_FALSE(covers(strokes, view.to_px({0.0, 0.006}), white_on_black.proxy));
}

TEST(ShapeMarks, ItTurns) {
    HandState hand = with_bar();
    hand.proxy_angle_rad = std::numbers::pi / 2.0;
    EXPECT_TRUE(covers(drawn(hand), view.to_px({0.002, 0.012}), white_on_black.proxy));
}

TEST(ShapeMarks, ItsTorqueIsAnArcOnTheSideToWhichItTurns) {
    HandState hand = with_bar();
    hand.torque_Nm = 0.011;  // a quarter turn to the left
    const PixelPoint left = view.to_px(hand.p_WH) + PixelPoint{-31.0, -31.0};
    const PixelPoint right = view.to_px(hand.p_WH) + PixelPoint{31.0, -31.0};
    EXPECT_TRUE(covers(drawn(hand), left, white_on_black.force));
    EXPECT_FALSE(covers(drawn(hand), right, white_on_black.force));
    hand.torque_Nm = -0.011;
    EXPECT_TRUE(covers(drawn(hand), right, white_on_black.force));
}

TEST(ShapeMarks, WhatIsNotInTheHandYetIsThin) {
    HandState hand = with_bar();
    hand.is_shape_placed = false;
    const Strokes strokes = drawn(hand);
    EXPECT_EQ(stroke_count(strokes), 4);
    EXPECT_TRUE(covers(strokes, view.to_px({0.008, -0.002}), white_on_black.handle));
}

TEST(ShapeMarks, TheHandShowsItInPlaceOfTheProxysDisc) {
    HandState hand = with_bar();
    Strokes strokes;
    add_hand(strokes, view, hand, 0.001, unit_px);
    EXPECT_TRUE(covers(strokes, view.to_px({0.008, 0.004}), white_on_black.proxy));
    EXPECT_FALSE(covers(strokes, view.to_px(hand.p_WP), white_on_black.proxy));
}

TEST(ShapeMarks, ADiscIsARing) {
    HandState hand = with_bar();
    hand.shape = HeldShape::disc;
    const Strokes strokes = drawn(hand);
    EXPECT_TRUE(
        covers(strokes, view.to_px(hand.p_WP + Position{0.004, 0.0}), white_on_black.proxy));
    EXPECT_FALSE(covers(strokes, view.to_px(hand.p_WP), white_on_black.proxy));
}

}  // namespace
}  // namespace touchline
