#include "app/screen/hand_trail.h"

#include "tests/app/screen/covered.h"
#include "tests/app/screen/probes.h"

#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Strokes strokes_of(const HandTrail& trail) {
    Strokes strokes;
    trail.add_to(strokes, view, 3.0, white_on_black.proxy);
    return strokes;
}

/// Ten steps of a millimetre in a second; rests at the last place.
HandTrail short_trail() {
    HandTrail trail;
    for (int i = 0; i <= 10; ++i) trail.add({0.001 * i, 0.0}, i * one_second_ns / 10);
    return trail;
}

constexpr Position rest{0.01, 0.0};

TEST(HandTrail, ShowsWhereTheHandHasBeenAndFades) {
    HandTrail trail = short_trail();
    const Strokes young = strokes_of(trail);
    ASSERT_EQ(stroke_count(young), 10);
    EXPECT_TRUE(covers(young, view.to_px({0.0055, 0.0}), white_on_black.proxy));
    trail.add(rest, 4 * one_second_ns);
    EXPECT_LT(strokes_of(trail).vertices().back().rgba[3], young.vertices().back().rgba[3]);
    trail.add(rest, 8 * one_second_ns);
    EXPECT_EQ(stroke_count(strokes_of(trail)), 0);
}

/// Each change is a frame.
TEST(HandTrail, OfAHandThatRestsFadesTwiceInThreeSeconds) {
    HandTrail trail = short_trail();
    int changes = 0;
    Strokes before = strokes_of(trail);
    for (int frame = 1; frame <= 180; ++frame) {
        trail.add(rest, one_second_ns + frame * one_second_ns / 60);
        const Strokes now = strokes_of(trail);
        changes += now.vertices() == before.vertices() ? 0 : 1;
        before = now;
    }
    EXPECT_EQ(changes, 2);
}

TEST(HandTrail, AJumpIsNoLine) {
    HandTrail trail;
    trail.add({0.0, 0.0}, 0);
    trail.add({0.016, 0.0}, 1);
    EXPECT_EQ(stroke_count(strokes_of(trail)), 0);
    trail.add({0.017, 0.0}, 2);
    EXPECT_EQ(stroke_count(strokes_of(trail)), 1);
}

TEST(HandTrail, AHandThatRestsOrIsNowhereAddsNothing) {
    HandTrail trail;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < 100; ++i) trail.add({1e-6 * i, 0.0}, i);
    trail.add({nan, 0.0}, 100);
    EXPECT_EQ(stroke_count(strokes_of(trail)), 0);
}

TEST(HandTrail, IsBounded) {
    HandTrail trail;
    for (int i = 0; i < 10'000; ++i) trail.add({i % 2 == 0 ? 0.005 : -0.005, 0.0}, i);
    EXPECT_EQ(stroke_count(strokes_of(trail)), 599);
    trail.clear();
    EXPECT_EQ(stroke_count(strokes_of(trail)), 0);
}

}  // namespace
}  // namespace touchline
