#include "haptics/device/simulated/simulated_pantograph.h"

#include <limits>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(WaypointPath, GoesStraightFromPointToPoint) {
    const WaypointPath path({{0.0, {0.0, 0.01}}, {0.2, {0.02, 0.01}}, {0.4, {0.02, -0.03}}});
    EXPECT_NEAR(path.at(0.05).position.x, 0.005, 1e-15);
    EXPECT_NEAR(path.at(0.05).velocity.x, 0.1, 1e-15);
    EXPECT_NEAR(path.at(0.3).position.y, -0.01, 1e-15);
    EXPECT_NEAR(path.at(0.3).velocity.y, -0.2, 1e-15);
    // At a way point the stretch that begins there counts.
    EXPECT_EQ(path.at(0.2).position, (Position{0.02, 0.01}));
    EXPECT_EQ(path.at(0.2).velocity.x, 0.0);
}

TEST(WaypointPath, IsStillBeforeAndAfter) {
    const WaypointPath path({{0.1, {0.0, 0.0}}, {0.2, {0.01, 0.0}}});
    EXPECT_EQ(path.at(0.0).position, Position{});
    EXPECT_EQ(path.at(0.0).velocity, Velocity{});
    EXPECT_EQ(path.at(5.0).position, (Position{0.01, 0.0}));
    EXPECT_EQ(path.at(5.0).velocity, Velocity{});
}

TEST(MouseHand, IsWhereItWasLastToldWithinTenNanometres) {
    MouseHand hand({0.0, 0.0});
    hand.move_to({-0.0571234567, 0.0419876543});
    EXPECT_NEAR(hand.at(1.0).position.x, -0.0571234567, 1e-8);
    EXPECT_NEAR(hand.at(1.0).position.y, 0.0419876543, 1e-8);
    EXPECT_EQ(hand.at(1.0).velocity, Velocity{});
}

TEST(MouseHand, IgnoresPositionsThatAreNotFinite) {
    MouseHand hand({0.01, 0.02});
    hand.move_to({std::numeric_limits<double>::quiet_NaN(), 0.0});
    hand.move_to({0.0, std::numeric_limits<double>::infinity()});
    EXPECT_NEAR(hand.at(0.0).position.x, 0.01, 1e-8);
}

TEST(MouseHand, BothCoordinatesMoveTogetherAcrossThreads) {
    MouseHand hand({0.0, 0.0});
    std::thread mover([&hand] {
        for (int i = 1; i <= 20000; ++i) hand.move_to({i * 1e-6, -i * 1e-6});
    });
    for (int i = 0; i < 20000; ++i) {
        const Position p = hand.at(0.0).position;
        EXPECT_EQ(p.x, -p.y);
    }
    mover.join();
    EXPECT_NEAR(hand.at(0.0).position.x, 0.02, 1e-8);
}

}  // namespace
}  // namespace touchline
