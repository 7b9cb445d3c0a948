// The kinematics of a five-bar on the device's side: angles become places, commands torques.
#include "haptics/device/joint_device.h"

#include "haptics/pantograph/profile.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

class ToldDevice final : public JointDevice {
  public:
    ToldDevice() : JointDevice(default_profile().geometry) {}

    [[nodiscard]] std::optional<JointAngles> read_angles(double /*now_s*/) override {
        return angles;
    }

    [[nodiscard]] std::optional<double> handle_angle_rad() const override { return handle_rad; }

    void turn_handle(double torque_Nm) override { handle_Nm = torque_Nm; }

    [[nodiscard]] bool write_torques(JointTorques told) override {
        EXPECT_EQ(torques, JointTorques{}) << "written once";
        torques = told;
        handle_Nm_with_it = handle_Nm;
        return is_taken;
    }

    std::optional<JointAngles> angles = default_profile().home;
    std::optional<double> handle_rad;
    JointTorques torques;
    double handle_Nm = 0.0;
    double handle_Nm_with_it = 0.0;
    bool is_taken = true;
};

TEST(JointDevice, TellsThePlaceAndTheJacobianOfItsAngles) {
    ToldDevice device;
    device.handle_rad = 0.7;
    const DeviceReading told = device.read(0.0).value();
    const Pose pose = forward(default_profile().geometry, default_profile().home).value();
    EXPECT_EQ(told.p_D, pose.p_DH);
    ASSERT_TRUE(told.jacobian.has_value());
    EXPECT_EQ(told.jacobian->joint_1, pose.jacobian.joint_1);
    EXPECT_EQ(told.jacobian->joint_2, pose.jacobian.joint_2);
    EXPECT_EQ(told.joints, default_profile().home);
    EXPECT_EQ(told.handle_rad, 0.7);
    EXPECT_FALSE(told.velocity_D.has_value());
}

TEST(JointDevice, AnglesThatNoLinksAllowAreToldWithoutAPlace) {
    ToldDevice device;
    const JointAngles home = default_profile().home;
    const Position tip = forward(default_profile().geometry, home).value().p_DH;
    const JointAngles elbow_turned_in{2.0 * std::atan2(tip.y, tip.x) - home.x, home.y};
    for (const JointAngles angles : {elbow_turned_in, JointAngles{nan_value, home.y}}) {
        device.angles = angles;
        const auto told = device.read(0.0);
        ASSERT_TRUE(told.has_value());
        EXPECT_FALSE(told->p_D.has_value());
        EXPECT_FALSE(told->jacobian.has_value());
        EXPECT_EQ(told->joints.y, angles.y);
    }
}

TEST(JointDevice, WithoutAnglesItTellsNothing) {
    ToldDevice device;
    device.angles.reset();
    device.handle_rad = 0.7;
    EXPECT_FALSE(device.read(0.0).has_value());
}

TEST(JointDevice, TakesTheTorquesAndTheHandlesWithThemAndLeavesTheForce) {
    ToldDevice device;
    EXPECT_TRUE(device.write({{1.0, 2.0}, {0.03, -0.04}, 0.05}));
    EXPECT_EQ(device.torques, (JointTorques{0.03, -0.04}));
    EXPECT_EQ(device.handle_Nm_with_it, 0.05);
    device.torques = {};
    device.is_taken = false;
    EXPECT_FALSE(device.write({}));
}

}  // namespace
}  // namespace touchline
