// Boards whose counts or limits differ from their profile's.
#include "tests/machines/sim/board/board_rig.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr JointTorques gentle_push{0.02, -0.015};

BoardTruth unhalved() {
    BoardTruth truth;
    truth.firmware.has_all_counts = true;
    return truth;
}

TEST(UnitCounts, ABoardThatDoesNotHalveIsFoundOutByItsFirstOddCount) {
    BoardRig rig(unhalved());
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.3, gentle_push);
    const auto angles = rig.tick({});
    ASSERT_TRUE(angles.has_value());
    EXPECT_TRUE(rig.driver->frame().calibration().has_all_counts);
    EXPECT_EQ(rig.driver->report().wrong_packets, 0U);
    EXPECT_EQ(rig.driver->report().resyncs, 1U);  // to open
    const JointAngles off = *angles - rig.board.true_angles();
    EXPECT_LT(std::max(std::abs(off.x), std::abs(off.y)), 0.02);  // a tick of motion
    const JointAngles quantum = encoder_quantum(rig.driver->frame().calibrated_profile());
    EXPECT_NEAR(quantum.x, 2.0 * 3.14159265358979 / 4880.0, 1e-12);
}

TEST(UnitCounts, WhatWasFoundOutOutlivesANewCalibration) {
    BoardRig rig(unhalved());
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.3, gentle_push);
    rig.driver->set_calibration({});
    EXPECT_TRUE(rig.driver->frame().calibration().has_all_counts);
}

TEST(UnitCounts, ABoardThatHalvesIsNeverTakenForOneThatDoesNot) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(2.0, gentle_push);
    rig.tick_for(2.0, -gentle_push);
    EXPECT_FALSE(rig.driver->frame().calibration().has_all_counts);
}

TEST(UnitCounts, AStoredUnitHasItsCountsFromTheFirstMomentOn) {
    Calibration stored;
    stored.has_all_counts = true;
    BoardRig rig(unhalved(), {}, stored);
    ASSERT_TRUE(rig.driver->open().has_value());
    const JointAngles home = rig.tick({}).value();
    EXPECT_NEAR(norm(home - default_profile().home), 0.0, 2e-3);
}

// A cycle counts 1, 2, 3, 2: a slow motion one way must read as one.
TEST(UnitCounts, ACounterThatStepsBackReadsAsAMotionOneWay) {
    BoardTruth truth;
    truth.do_counts_step_back = true;
    const auto path = std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{
        {0.0, {0.0, 0.0}}, {0.2, {0.0, 0.0}}, {4.0, {0.0, 0.03}}});
    BoardRig rig(truth, {}, {}, path);
    ASSERT_TRUE(rig.driver->open().has_value());
    double farthest_rad = -1e9, longest_way_back_rad = 0.0;
    for (int k = 0; k < 3800; ++k) {
        const auto angles = rig.tick({});
        ASSERT_TRUE(angles.has_value()) << k;
        longest_way_back_rad = std::max(longest_way_back_rad, farthest_rad - angles->x);
        farthest_rad = std::max(farthest_rad, angles->x);
    }
    EXPECT_GT(farthest_rad - default_profile().home.x, 0.2);
    EXPECT_LT(longest_way_back_rad, 1e-6);        // the resolution of a float
    EXPECT_EQ(rig.driver->report().resyncs, 1U);  // to open
    EXPECT_EQ(rig.driver->report().jumps, 0U);
}

TEST(UnitCounts, AHigherLimitOfTheBoardIsReachedWhereTheUnitIsSetToIt) {
    BoardTruth truth;
    truth.firmware.torque_limit_Nm = 0.156;
    truth.firmware.scales_together = true;
    const JointTorques large{0.3, -0.15};
    BoardRig as_usual(truth);
    ASSERT_TRUE(as_usual.driver->open().has_value());
    (void)as_usual.tick({});
    as_usual.tick_for(0.005, large);
    EXPECT_NEAR(as_usual.held().x, 0.123, 2e-4);
    EXPECT_NEAR(as_usual.held().y, -0.0615, 2e-4);
    Calibration calibration;
    calibration.torque_limit_Nm = 0.156;
    BoardRig known(truth, {}, calibration);
    ASSERT_TRUE(known.driver->open().has_value());
    (void)known.tick({});
    known.tick_for(0.005, large);
    EXPECT_NEAR(known.held().x, 0.156, 2e-4);
    EXPECT_NEAR(known.held().y, -0.078, 2e-4);
}

}  // namespace
}  // namespace touchline
