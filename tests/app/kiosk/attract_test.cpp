#include "app/kiosk/attract.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TactileMap circle_of(double radius_m) {
    TactileMap map;
    Outline& circle = map.outlines.emplace_back();
    circle.is_closed = true;
    for (int i = 0; i < 360; ++i) {
        const double angle_rad = std::numbers::pi * i / 180.0;
        circle.points.push_back({radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)});
    }
    return map;
}

TEST(Attract, AHandFollowsTheLineRoundAndRound) {
    const auto picture = attract_picture(circle_of(0.03));
    ASSERT_TRUE(picture.has_value());
    Position last = attract_hand(*picture, 0.0).p_WP;
    double way_m = 0.0;
    for (int frame = 1; frame <= 60 * 20; ++frame) {
        const HandState hand = attract_hand(*picture, frame / 60.0);
        EXPECT_NEAR(norm(hand.p_WP), 0.03, 1e-4);
        EXPECT_NEAR(norm(hand.p_WH - hand.p_WP), 0.001, 1e-6);
        EXPECT_LT(norm(hand.p_WP - last), 0.0201);  // a step, and no more
        way_m += norm(hand.p_WP - last);
        last = hand.p_WP;
    }
    EXPECT_GT(way_m, 2.0 * std::numbers::pi * 0.03);
}

/// Each step is a frame.
TEST(Attract, AHandMovesOnceASecond) {
    const auto picture = attract_picture(circle_of(0.03));
    ASSERT_TRUE(picture.has_value());
    int steps = 0;
    for (int frame = 1; frame <= 60; ++frame) {
        const Position before = attract_hand(*picture, (frame - 1) / 60.0).p_WP;
        steps += attract_hand(*picture, frame / 60.0).p_WP == before ? 0 : 1;
    }
    EXPECT_EQ(steps, 1);
}

TEST(Attract, WithoutALineTheHandRests) {
    const auto picture = attract_picture({});
    ASSERT_TRUE(picture.has_value()) << picture.error().line;
    EXPECT_EQ(attract_hand(*picture, 1.0).p_WP, Position{});
}

}  // namespace
}  // namespace touchline
