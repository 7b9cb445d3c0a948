// Tests the pointer as a pen.
#include "app/kiosk/pen.h"

#include "app/documents/drawing/drawing.h"

#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Pen, AStrokeIsGivenWhenThePenIsLifted) {
    Pen pen;
    EXPECT_FALSE(pen.step({PenMotion::move, {0.01, 0.0}}, Area{}));
    EXPECT_FALSE(pen.is_down());
    EXPECT_FALSE(pen.step({PenMotion::press, {0.0, 0.0}}, Area{}));
    EXPECT_FALSE(pen.step({PenMotion::move, {0.01, 0.0}}, Area{}));
    EXPECT_FALSE(pen.step({PenMotion::move, {nan, 0.0}}, Area{}));
    EXPECT_EQ(pen.line().size(), 2U);
    const auto stroke = pen.step({PenMotion::lift, {0.02, 0.0}}, Area{});
    ASSERT_TRUE(stroke);
    EXPECT_EQ(stroke->points_W.size(), 2U);
    EXPECT_FALSE(stroke->is_eraser);
    EXPECT_FALSE(pen.is_down());
    EXPECT_FALSE(pen.step({PenMotion::lift, {}}, Area{}));
}

TEST(Pen, APressBesideTheAreaDrawsNothing) {
    Pen pen;
    for (const Position& place : {Position{0.07, 0.0}, {0.0, -0.05}, {nan, 0.0}}) {
        EXPECT_FALSE(pen.step({PenMotion::press, place}, Area{}));
        EXPECT_FALSE(pen.is_down());
        EXPECT_FALSE(pen.step({PenMotion::press, place, true}, Area{}));
    }
}

TEST(Pen, TheSecondButtonErasesAtOnceAndEndsNoStroke) {
    Pen pen;
    const auto erased = pen.step({PenMotion::press, {0.01, 0.02}, true}, Area{});
    ASSERT_TRUE(erased);
    EXPECT_TRUE(erased->is_eraser);
    EXPECT_EQ(erased->points_W.front(), (Position{0.01, 0.02}));
    (void)pen.step({PenMotion::press, {0.0, 0.0}}, Area{});
    EXPECT_FALSE(pen.step({PenMotion::lift, {0.0, 0.0}, true}, Area{}));
    EXPECT_TRUE(pen.is_down());
}

TEST(Pen, AStrokeWithoutEndStaysBounded) {
    Pen pen;
    (void)pen.step({PenMotion::press, {}}, Area{});
    for (std::size_t i = 0; i < 2 * most_stroke_points; ++i)
        (void)pen.step({PenMotion::move, {i % 2 == 0 ? 0.05 : -0.05, 0.0}}, Area{});
    EXPECT_LE(pen.line().size(), 23U) << "the screen shows it in each frame";
    const auto stroke = pen.step({PenMotion::lift, {}}, Area{});
    ASSERT_TRUE(stroke);
    EXPECT_EQ(Drawing(7).with_stroke(stroke->points_W).error(), DrawingRefusal::too_long);
    (void)pen.step({PenMotion::press, {}}, Area{});
    (void)pen.step({PenMotion::move, {0.05, 0.0}}, Area{});
    EXPECT_EQ(pen.line().size(), 2U) << "the next stroke has all its way before it";
}

TEST(Pen, ATrembleInOnePlaceIsNoWay) {
    Pen pen;
    (void)pen.step({PenMotion::press, {}}, Area{});
    for (int i = 0; i < 100'000; ++i)
        (void)pen.step({PenMotion::move, {i % 2 == 0 ? 5e-5 : -4e-5, 0.0}}, Area{});
    EXPECT_EQ(pen.line().size(), 1U);
}

}  // namespace
}  // namespace touchline
