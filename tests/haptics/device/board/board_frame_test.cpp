#include "haptics/device/board/board_frame.h"

#include "config/types/angle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

BoardFrame frame_of(const char* profile, const Calibration& calibration = {}) {
    return {find_profile(profile).value(), calibration};
}

TEST(BoardFrame, WhatTheBoardSaysAtHomeIsHome) {
    for (const DeviceProfile& profile : device_profiles()) {
        const BoardFrame frame(profile, {});
        const JointAngles angles = frame.joint_angles(frame.home_reading());
        EXPECT_NEAR(norm(angles - profile.home), 0.0, 1e-12) << profile.name;
        EXPECT_TRUE(frame.is_whole_counts(frame.home_reading())) << profile.name;
    }
}

TEST(BoardFrame, HomeReadingIsThatOfTheFirmware) {
    const PortAngles gen31 = frame_of("2diy-gen3.1").home_reading();
    EXPECT_NEAR(gen31.x, 11.9508, 1e-4);
    EXPECT_NEAR(gen31.y, 167.9016, 1e-4);
    EXPECT_EQ(frame_of("2diy-gen2").home_reading(), (PortAngles{-60.9375, 240.9375}));
    EXPECT_EQ(frame_of("haplet").home_reading(), (PortAngles{180.0, 0.0}));
}

TEST(BoardFrame, MotorsAndEncodersAreEachWhereTheUnitHasThem) {
    const BoardFrame plain = frame_of("2diy-gen2");
    EXPECT_EQ(plain.port_torques({0.01, 0.02}), (PortTorques{0.02, 0.01}));
    EXPECT_EQ(plain.motor_port(1), 2);
    Calibration unit;
    unit.motors = {true, false, true};
    unit.encoders = {false, true, false};
    const BoardFrame frame = frame_of("2diy-gen2", unit);
    EXPECT_EQ(frame.port_torques({0.01, 0.02}), (PortTorques{0.01, -0.02}));
    EXPECT_EQ(frame.motor_port(1), 1);
    EXPECT_EQ(frame.motor_port(2), 2);
    // Joint 1 is on port 2.
    const PortAngles moved = frame.home_reading() + 3.0 * PortAngles{0.0, frame.quantum().y};
    const JointAngles turned = frame.joint_angles(moved) - frame.profile().home;
    EXPECT_NEAR(turned.x, -3.0 * encoder_quantum(frame.profile()).x, 1e-12);
    EXPECT_NEAR(turned.y, 0.0, 1e-12);
}

TEST(BoardFrame, AUnitIsSetUpAsItsMakerDoesItWhateverItsPlugs) {
    Calibration unit;
    unit.motors = unit.encoders = {true, true, true};
    const Command told = set_up_command(frame_of("2diy-gen2", unit).set_up_at_home());
    const Command usual = set_up_command(frame_of("2diy-gen2").set_up_at_home());
    EXPECT_TRUE(std::equal(told.bytes().begin(), told.bytes().end(), usual.bytes().begin()));
}

TEST(Plugs, ThereAndBackIsTheSame) {
    for (std::uint32_t number = 0; number < 8; ++number) {
        const Plugs plugs = plugs_of(number);
        EXPECT_EQ(number_of(plugs), number);
        const JointTorques torques{0.01, 0.02};
        EXPECT_EQ(at_joints(plugs, at_ports(plugs, torques)), torques);
    }
}

TEST(BoardFrame, OffsetAndScaleActOnTheTurnFromHome) {
    Calibration calibration;
    calibration.offset = {0.01, -0.02};
    calibration.scale = 1.05;
    const BoardFrame frame = frame_of("2diy-gen3.1", calibration);
    const PortAngles raw = frame.home_reading() + PortAngles{10.0, -20.0};  // joint 2, joint 1
    const JointAngles angles = frame.joint_angles(raw);
    EXPECT_NEAR(angles.x, radians(168.0 - 1.05 * 20.0) + 0.01, 1e-12);
    EXPECT_NEAR(angles.y, radians(12.0 + 1.05 * 10.0) - 0.02, 1e-12);
}

TEST(BoardFrame, TorquesAreScaledTogetherToTheUnitsLimit) {
    Calibration weak;
    weak.torque_limit_Nm = 0.05;
    const PortTorques told = frame_of("haplet", weak).port_torques({0.1, -0.02});
    EXPECT_DOUBLE_EQ(told.x, 0.05);
    EXPECT_DOUBLE_EQ(told.y, -0.01);
    EXPECT_EQ(calibrated(default_profile(), weak).torque_limit_Nm, 0.05);
    EXPECT_EQ(calibrated(default_profile(), {}).torque_limit_Nm, 0.123);
}

TEST(BoardFrame, NothingThatIsNotANumberReachesAMotor) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const BoardFrame frame = frame_of("2diy-gen3.1");
    EXPECT_EQ(frame.port_torques({nan, 0.1}), PortTorques{});
    EXPECT_EQ(frame.port_torques({0.1, std::numeric_limits<double>::infinity()}), PortTorques{});
    EXPECT_LE(std::abs(frame.port_torques({1e308, -1e308}).x), 0.123);
    Calibration broken;
    broken.torque_limit_Nm = nan;
    const Command told = write_command(frame_of("haplet", broken).port_torques({0.1, 0.1}));
    const Command zero = write_command({});
    EXPECT_TRUE(std::equal(told.bytes().begin(), told.bytes().end(), zero.bytes().begin()));
}

// The board takes the whole part of offset * counts / 360, in single precision.
int counts_after(const BoardSetUp& set_up, std::size_t port, double told_per_count) {
    const double counts = static_cast<double>(set_up.counts_told[port]) / told_per_count;
    return static_cast<int>(static_cast<double>(set_up.offsets_deg[port]) * counts / 360.0);
}

TEST(BoardFrame, SettingUpAgainKeepsEveryCount) {
    for (const DeviceProfile& profile : device_profiles()) {
        const BoardFrame frame(profile, {});
        const double told = profile.wiring.told_per_count;
        for (int count = -3000; count <= 3000; ++count) {
            const PortAngles said{
                static_cast<double>(static_cast<float>(count * frame.quantum().x)),
                static_cast<double>(static_cast<float>(count * frame.quantum().y))};
            const BoardSetUp again = frame.set_up_at(said);
            ASSERT_EQ(counts_after(again, 0, told), count) << profile.name;
            ASSERT_EQ(counts_after(again, 1, told), count) << profile.name;
            ASSERT_TRUE(frame.is_whole_counts(said)) << profile.name << count;
            ASSERT_FALSE(frame.is_whole_counts(said + PortAngles{0.3 * frame.quantum().x, 0.0}));
        }
    }
}

}  // namespace
}  // namespace touchline
