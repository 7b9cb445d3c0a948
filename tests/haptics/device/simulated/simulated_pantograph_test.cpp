#include "haptics/device/simulated/simulated_pantograph.h"

#include "tests/haptics/tick.h"

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::shared_ptr<const IntendedPath> still_at(Position p) {
    return std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{{0.0, p}});
}

DeviceProfile frictionless(double delay_s = 0.0) {
    DeviceProfile profile = default_profile();
    profile.mechanics = {0.05, 0.0, 0.0, delay_s};
    return profile;
}

SimulationOptions with_hand(const HandModel& hand) {
    SimulationOptions options;
    options.hand = hand;
    return options;
}

// Returns the torques that push with `force_W` at the centre of the drawing area.
JointTorques torques_for(const DeviceProfile& profile, Force force_W) {
    const JointAngles angles = inverse(profile.geometry, profile.centre).value();
    return joint_torques(forward(profile.geometry, angles).value().jacobian, turned(force_W));
}

TEST(SimulatedPantograph, StartsWhereTheHandIs) {
    const DeviceProfile profile = default_profile();
    SimulatedPantograph device(profile, {}, still_at({0.02, -0.03}));
    const JointAngles angles = device.read_angles(0.0).value();
    const Position p_WH =
        picture_from_device(profile, forward(profile.geometry, angles).value().p_DH);
    EXPECT_NEAR(norm(p_WH - Position{0.02, -0.03}), 0.0, 2.0 * encoder_step_m(profile));
}

TEST(SimulatedPantograph, StartsAtTheCentreWhenTheHandIsOutOfReach) {
    SimulatedPantograph device(default_profile(), {}, still_at({0.5, 0.0}));
    EXPECT_EQ(device.tip().position, Position{});
    EXPECT_TRUE(device.read_angles(0.0).has_value());
}

TEST(SimulatedPantograph, ReadsWholeEncoderCounts) {
    const DeviceProfile profile = default_profile();
    const JointAngles quantum = encoder_quantum(profile);
    const auto path = std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.0, {-0.03, 0.0}}, {1.0, {0.03, 0.01}}});
    SimulatedPantograph device(profile, {}, path);
    for (int k = 0; k < 1000; ++k) {
        const JointAngles read = device.read_angles(k * tick_s).value();
        const JointAngles counts{read.x / quantum.x, read.y / quantum.y};
        ASSERT_NEAR(counts.x, std::round(counts.x), 1e-6);
        ASSERT_NEAR(counts.y, std::round(counts.y), 1e-6);
        const JointAngles truth =
            inverse(profile.geometry, device_from_picture(profile, device.tip().position)).value();
        ASSERT_GE(truth.x - read.x, -1e-12);
        ASSERT_LT(truth.x - read.x, quantum.x);
        ASSERT_GE(truth.y - read.y, -1e-12);
        ASSERT_LT(truth.y - read.y, quantum.y);
    }
}

TEST(SimulatedPantograph, TipStepPerCountIsThatOfTheKinematics) {
    const DeviceProfile profile = default_profile();
    SimulatedPantograph device(profile, {}, still_at({}));
    JointAngles angles = device.read_angles(0.0).value();
    const Position here = forward(profile.geometry, angles).value().p_DH;
    angles.x += encoder_quantum(profile).x;
    const Pose there = forward(profile.geometry, angles).value();
    EXPECT_NEAR(norm(there.p_DH - here), norm(there.jacobian.joint_1) * encoder_quantum(profile).x,
                1e-6);
    EXPECT_LE(norm(there.p_DH - here), encoder_step_m(profile));
}

TEST(SimulatedPantograph, PushesTheWayTheForceIsMeant) {
    const DeviceProfile profile = frictionless();
    for (const Force wanted : {Force{0.5, 0.0}, Force{0.0, 0.5}, Force{-0.3, 0.4}}) {
        SimulatedPantograph device(profile, with_hand(no_hand), still_at({}));
        (void)device.read_angles(0.0);
        ASSERT_TRUE(device.write_torques(torques_for(profile, wanted)));
        (void)device.read_angles(tick_s);
        const Position moved = along<Position>(wanted, 0.5 * tick_s * tick_s / 0.05);
        EXPECT_NEAR(norm(device.tip().position - moved), 0.0, 1e-9);
    }
}

TEST(SimulatedPantograph, TorqueActsAfterTheDelayNotBefore) {
    for (const double ticks : {0.25, 0.5, 1.0, 2.5}) {
        const DeviceProfile profile = frictionless(ticks * tick_s);
        SimulatedPantograph device(profile, with_hand(no_hand), still_at({}));
        (void)device.read_angles(0.0);
        (void)device.write_torques(torques_for(profile, {0.5, 0.0}));
        (void)device.read_angles(ticks * tick_s);
        EXPECT_EQ(device.tip().position, Position{});
        (void)device.read_angles((ticks + 1.0) * tick_s);
        EXPECT_NEAR(device.tip().position.x, 0.5 * 0.5 / 0.05 * tick_s * tick_s, 1e-9);
    }
}

TEST(SimulatedPantograph, QueuedTorquesActOneAfterTheOther) {
    const DeviceProfile profile = frictionless(1.5 * tick_s);
    SimulatedPantograph device(profile, with_hand(no_hand), still_at({}));
    for (int k = 0; k < 4; ++k) {
        (void)device.read_angles(k * tick_s);
        (void)device.write_torques({0.001 * (k + 1), 0.0});
    }
    (void)device.read_angles(4.0 * tick_s);  // writes of ticks 0, 1 and 2 have arrived
    EXPECT_EQ(device.acting_torques().x, 0.003);
}

TEST(SimulatedPantograph, ClampsEachMotorAndTakesNaNForZero) {
    SimulatedPantograph device(frictionless(), with_hand(no_hand), still_at({}));
    (void)device.write_torques({5.0, -0.2});
    (void)device.read_angles(tick_s);
    EXPECT_EQ(device.acting_torques(), (JointTorques{0.123, -0.123}));
    (void)device.write_torques({std::numeric_limits<double>::quiet_NaN(), 0.05});
    (void)device.read_angles(2.0 * tick_s);
    EXPECT_EQ(device.acting_torques(), (JointTorques{0.0, 0.05}));
}

TEST(SimulatedPantograph, LastTorqueStaysOnAsOnTheBoard) {
    SimulatedPantograph device(frictionless(), with_hand(normal_hand), still_at({}));
    (void)device.write_torques({0.02, 0.02});
    for (int k = 1; k < 100; ++k) (void)device.read_angles(k * tick_s);
    EXPECT_EQ(device.acting_torques(), (JointTorques{0.02, 0.02}));
}

TEST(SimulatedPantograph, ManyWritesInOneTickLeaveTheLast) {
    SimulatedPantograph device(frictionless(), with_hand(no_hand), still_at({}));
    for (int i = 1; i <= 500; ++i) (void)device.write_torques({i * 1e-4, 0.0});
    (void)device.read_angles(tick_s);
    EXPECT_EQ(device.acting_torques().x, 500 * 1e-4);
}

TEST(SimulatedPantograph, TipStopsWhereTheLinksEnd) {
    const DeviceProfile profile = default_profile();
    const auto path = std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.0, {}}, {0.5, {0.3, 0.0}}, {1.0, {}}});
    SimulatedPantograph device(profile, {}, path);
    for (int k = 0; k < 500; ++k) ASSERT_TRUE(device.read_angles(k * tick_s).has_value());
    EXPECT_LT(device.tip().position.x, 0.16);
    for (int k = 500; k < 2000; ++k) ASSERT_TRUE(device.read_angles(k * tick_s).has_value());
    EXPECT_NEAR(norm(device.tip().position), 0.0, 1e-3);
}

TEST(SimulatedPantograph, ScaleErrorOfAnArmShiftsTheTipAwayFromHome) {
    const DeviceProfile profile = default_profile();
    SimulationOptions options;
    options.arm_1_scale_error = 0.015;
    SimulatedPantograph off(profile, options, still_at({}));
    SimulatedPantograph exact(profile, {}, still_at({}));
    const double turn = off.read_angles(0.0)->x - exact.read_angles(0.0)->x;
    const double from_home = exact.read_angles(0.0)->x - profile.home.x;
    EXPECT_NEAR(turn, 0.015 * from_home, encoder_quantum(profile).x);
    EXPECT_EQ(off.read_angles(0.0)->y, exact.read_angles(0.0)->y);
}

TEST(SimulatedPantograph, LongGapIsAPause) {
    const auto path = std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.0, {}}, {1000.0, {0.02, 0.0}}});
    SimulatedPantograph device(default_profile(), with_hand(normal_hand), path);
    EXPECT_TRUE(device.read_angles(900.0).has_value());
    // 0.1 s of a pull towards 18 mm: it moved, but did not simulate all 900 s.
    EXPECT_GT(device.tip().position.x, 0.001);
    EXPECT_LT(norm(device.tip().position), 0.04);
}

TEST(SimulatedPantograph, TimeThatGoesBackOrIsNotANumberChangesNothing) {
    SimulatedPantograph device(default_profile(), {}, still_at({0.01, 0.0}));
    (void)device.read_angles(0.5);
    const Position before = device.tip().position;
    (void)device.read_angles(0.2);
    (void)device.read_angles(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(device.tip().position, before);
}

TEST(SimulatedPantograph, SameCallsGiveTheSameBits) {
    const auto run = [] {
        const auto path = std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{
            {0.0, {-0.03, 0.02}}, {0.7, {0.04, -0.01}}, {1.1, {0.0, 0.0}}});
        SimulatedPantograph device(default_profile(), {}, path);
        for (int k = 0; k < 1500; ++k) {
            const JointAngles angles = device.read_angles(k * tick_s).value();
            (void)device.write_torques(
                {0.05 * std::sin(angles.x * 40.0), 0.03 * std::cos(k * 0.1)});
        }
        return device.tip();
    };
    const MassState a = run();
    const MassState b = run();
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.velocity, b.velocity);
}

}  // namespace
}  // namespace touchline
