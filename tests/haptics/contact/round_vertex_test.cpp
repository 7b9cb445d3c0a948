#include "haptics/contact/contact_step.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double radius_m = 1e-3;

TEST(RoundVertex, AnglesRunTheWayTheyAreAskedAndRoundingIsNoFullTurn) {
    EXPECT_NEAR(angle_between({1, 0}, {0, 1}, 1.0), half_turn / 2, 1e-15);
    EXPECT_NEAR(angle_between({1, 0}, {0, 1}, -1.0), 1.5 * half_turn, 1e-15);
    EXPECT_EQ(angle_between({1, 0}, {std::cos(1e-9), -std::sin(1e-9)}, 1.0), 0.0);
    EXPECT_NEAR(norm(turned({0, 1}, half_turn / 2) - Direction{-1, 0}), 0.0, 1e-15);
}

TEST(RoundVertex, RestsWhereTheForceIsAlongTheNormal) {
    const ArcGoal goal = arc_goal({0, 1}, {0, 0.5 * radius_m}, radius_m, 1.0, 1.0, 0.0);
    EXPECT_EQ(goal.turn, 0.0);
    const ArcGoal off = arc_goal({0, 1}, {0.0003, 0.0004}, radius_m, 1.0, 1.0, 0.0);
    EXPECT_EQ(off.end, ArcGoal::End::rest);
    EXPECT_EQ(off.turn, -1.0);
    EXPECT_NEAR(off.angle_rad, std::atan2(3.0, 4.0), 1e-12);
}

TEST(RoundVertex, GoesToTheEdgeWhenTheHandleLiesBehindTheVertex) {
    const ArcGoal goal = arc_goal({0, 1}, {-1e-4, -radius_m}, radius_m, 0.6, 0.7, 0.0);
    EXPECT_EQ(goal.end, ArcGoal::End::edge);
    EXPECT_EQ(goal.turn, 1.0);
    EXPECT_EQ(goal.angle_rad, 0.6);
    // Straight behind: both ways are downhill, so the shorter one is taken.
    EXPECT_EQ(arc_goal({0, 1}, {0.0, -radius_m}, radius_m, 0.9, 0.7, 0.0).turn, -1.0);
}

TEST(RoundVertex, LeavesWhereTheForceBecomesZero) {
    const Position pull{2.0 * radius_m, 0.1 * radius_m};
    const ArcGoal goal = arc_goal({0, 1}, pull, radius_m, half_turn, half_turn, 0.0);
    EXPECT_EQ(goal.end, ArcGoal::End::free);
    const Direction n = turned({0, 1}, goal.turn * goal.angle_rad);
    EXPECT_NEAR(dot(n, pull), radius_m, 1e-15);
}

TEST(RoundVertex, FrictionStopsAtTheEdgeOfItsCone) {
    constexpr double friction = 0.2;
    const Position pull{0.0005, 0.0001};
    const ArcGoal goal = arc_goal({0, 1}, pull, radius_m, half_turn, half_turn, friction);
    const Direction n = turned({0, 1}, goal.turn * goal.angle_rad);
    EXPECT_NEAR(std::abs(cross(n, pull)), friction * (radius_m - dot(n, pull)), 1e-12);
    EXPECT_EQ(arc_goal({0, 1}, {1e-6, 0.5 * radius_m}, radius_m, 1.0, 1.0, friction).turn, 0.0);
}

}  // namespace
}  // namespace touchline
