#include "app/screen/hand_trail.h"

#include "tests/app/screen/covered.h"
#include "tests/app/screen/probes.h"

#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

int strokes_at(const HandTrail& trail, std::int64_t now_ns) {
    Strokes strokes;
    trail.add_to(strokes, view, now_ns, 3.0, white_on_black.proxy);
    return stroke_count(strokes);
}

TEST(HandTrail, ShowsWhereTheHandHasBeenAndFades) {
    HandTrail trail;
    for (int i = 0; i <= 10; ++i) trail.add({0.001 * i, 0.0}, i * one_second_ns / 10);
    Strokes young;
    trail.add_to(young, view, one_second_ns, 3.0, white_on_black.proxy);
    ASSERT_EQ(stroke_count(young), 10);
    EXPECT_TRUE(covers(young, view.to_px({0.0055, 0.0}), white_on_black.proxy));
    Strokes old;
    trail.add_to(old, view, 4 * one_second_ns, 3.0, white_on_black.proxy);
    EXPECT_LT(old.vertices().back().rgba[3], young.vertices().back().rgba[3]);
    EXPECT_EQ(strokes_at(trail, 8 * one_second_ns), 0);
}

/// Each change is a frame.
TEST(HandTrail, FadesFourTimesASecond) {
    HandTrail trail;
    for (int i = 0; i <= 10; ++i) trail.add({0.001 * i, 0.0}, i * one_second_ns / 10);
    int changes = 0;
    Strokes before;
    for (int frame = 0; frame < 60; ++frame) {
        Strokes now;
        trail.add_to(now, view, 2 * one_second_ns + frame * one_second_ns / 60, 3.0,
                     white_on_black.proxy);
        changes += now.vertices() == before.vertices() ? 0 : 1;
        before = now;
    }
    EXPECT_EQ(changes, 4);
}

TEST(HandTrail, AHandThatRestsOrIsNowhereAddsNothing) {
    HandTrail trail;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < 100; ++i) trail.add({1e-6 * i, 0.0}, i);
    trail.add({nan, 0.0}, 100);
    EXPECT_EQ(strokes_at(trail, 100), 0);
}

TEST(HandTrail, IsBounded) {
    HandTrail trail;
    for (int i = 0; i < 10'000; ++i) trail.add({i % 2 == 0 ? 0.01 : -0.01, 0.0}, i);
    EXPECT_LE(strokes_at(trail, 10'000), 600);
    trail.clear();
    EXPECT_EQ(strokes_at(trail, 10'000), 0);
}

}  // namespace
}  // namespace touchline
