#include "haptics/pantograph/profile.h"

#include "tests/haptics/pantograph/workspace.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

// Returns the largest force that both motors can hold in every direction: the inner radius of the
// polygon |J^T F| <= limit.
double force_in_every_direction(const Pose& pose, double torque_Nm) {
    return torque_Nm / std::max(norm(pose.jacobian.joint_1), norm(pose.jacobian.joint_2));
}

double force_in_best_direction(const Pose& pose, double torque_Nm) {
    const auto corner = [&](double sign) {
        return norm(tip_force(pose.jacobian, {torque_Nm, sign * torque_Nm}).value());
    };
    return std::max(corner(1.0), corner(-1.0));
}

TEST(Profiles, AreFoundByName) {
    for (const char* name :
         {"2diy-gen2", "2diy-gen2-240", "2diy-gen3", "2diy-gen3.1", "2diy-gen3.1-172",
          "2diy-gen3.1-180", "haplet", "mk2", "gen3.1-turning"}) {
        const auto profile = find_profile(name);
        ASSERT_TRUE(profile.has_value()) << name;
        EXPECT_EQ(profile->name, name);
    }
    EXPECT_EQ(default_profile().name, "2diy-gen3.1");
}

TEST(Profiles, UnknownNameListsTheNamesThereAre) {
    const auto profile = find_profile("omega3");
    ASSERT_FALSE(profile.has_value());
    EXPECT_EQ(profile.error().line,
              "no device profile is named 'omega3'; choose one of 2diy-gen3.1, 2diy-gen3.1-172, "
              "2diy-gen3.1-180, 2diy-gen3, 2diy-gen2, 2diy-gen2-240, haplet, mk2, gen3.1-turning");
}

TEST(Profiles, FramesAreTurnedByHalfATurnAboutTheCentre) {
    const DeviceProfile& p = default_profile();
    // Right in the picture is -x of the device (+x is the user's left); away is -y (+y points to
    // the user).
    const Position right = device_from_picture(p, {0.01, 0.0});
    EXPECT_DOUBLE_EQ(right.x, 0.009);
    EXPECT_DOUBLE_EQ(right.y, 0.094);
    const Position away = device_from_picture(p, {0.0, 0.01});
    EXPECT_DOUBLE_EQ(away.x, 0.019);
    EXPECT_DOUBLE_EQ(away.y, 0.084);
    const Position back = picture_from_device(p, right);
    EXPECT_NEAR(back.x, 0.01, 1e-16);
    EXPECT_NEAR(back.y, 0.0, 1e-16);
    EXPECT_EQ(turned(Force{1.0, -2.0}), (Force{-1.0, 2.0}));
}

TEST(Profiles, DrawingAreasStayBelowCondition3AndReachable) {
    for (const DeviceProfile& profile : device_profiles()) {
        double worst = 0.0;
        visit_area(profile, 2.0 * mm, [&](Position, JointAngles, const Pose& pose) {
            worst = std::max(worst, condition(pose.jacobian));
        });
        EXPECT_LE(worst, 3.0) << profile.name;
    }
}

TEST(Profiles, TheOneThatOneBuildsIsFoundByNameAndHasThePublishedSize) {
    const auto found = find_device_profile("open-five-bar");
    ASSERT_TRUE(found.has_value());
    const DeviceProfile mk2 = find_profile("mk2").value();
    EXPECT_EQ(found->geometry, mk2.geometry);
    EXPECT_EQ(found->area.width_m, mk2.area.width_m);
    EXPECT_EQ(found->centre, mk2.centre);
    EXPECT_LT(encoder_step_m(*found), 3e-5);
    EXPECT_FALSE(find_profile("open-five-bar").has_value()) << "no board drives it";
}

// The condition is 6.6 where the arms stop in one line; the force comes in the drawing area.
TEST(Profiles, HomePosesCanBeReachedAndCarryForce) {
    for (const DeviceProfile& profile : device_profiles()) {
        const auto pose = forward(profile.geometry, profile.home);
        ASSERT_TRUE(pose.has_value()) << profile.name;
        EXPECT_LT(condition(pose->jacobian), 7.0) << profile.name;
    }
}

struct WorkspaceNumbers {
    double weakest_N, median_N, best_N;  // force in every direction, in the best one
    double worst_step_um, fine_step_um;  // median tip step per count
};

TEST(Profiles, ForceAndStepInTheAreaAreTheTabledOnes) {
    const std::map<std::string_view, WorkspaceNumbers> table{
        {"2diy-gen3.1", {1.6, 1.7, 3.1, 204, 144}},
        {"2diy-gen3", {1.6, 1.7, 3.1, 190, 134}},
        {"2diy-gen2", {1.55, 1.9, 3.1, 76, 65}},
        {"haplet", {2.1, 2.55, 4.4, 23, 18}},
        {"2diy-gen3.1-172", {1.6, 1.7, 3.1, 204, 144}},
        {"2diy-gen3.1-180", {1.6, 1.7, 3.1, 204, 144}},
        {"2diy-gen2-240", {1.55, 1.9, 3.1, 75, 64}},
        {"mk2", {1.45, 1.55, 2.8, 6.9, 4.83}},
        {"gen3.1-turning", {1.6, 1.7, 3.1, 102, 72}},
    };
    for (const DeviceProfile& profile : device_profiles()) {
        std::vector<double> every, best, worst_step, fine_step;
        visit_area(profile, 2.0 * mm, [&](Position, JointAngles, const Pose& pose) {
            every.push_back(force_in_every_direction(pose, profile.torque_limit_Nm));
            best.push_back(force_in_best_direction(pose, profile.torque_limit_Nm));
            const SingularValues step = singular_values(pose.jacobian, encoder_quantum(profile));
            worst_step.push_back(step.largest / 1e-6);
            fine_step.push_back(step.smallest / 1e-6);
        });
        const WorkspaceNumbers& expected = table.at(profile.name);
        EXPECT_NEAR(*std::min_element(every.begin(), every.end()), expected.weakest_N, 0.05)
            << profile.name;
        EXPECT_NEAR(median(every), expected.median_N, 0.05) << profile.name;
        EXPECT_NEAR(median(best), expected.best_N, 0.1) << profile.name;
        EXPECT_NEAR(median(worst_step), expected.worst_step_um, 0.03 * expected.worst_step_um)
            << profile.name;
        EXPECT_NEAR(median(fine_step), expected.fine_step_um, 0.04 * expected.fine_step_um)
            << profile.name;
    }
}

TEST(Profiles, EncoderStepIsTheTipsMotionForOneCount) {
    for (const DeviceProfile& profile : device_profiles()) {
        const JointAngles angles = inverse(profile.geometry, profile.centre).value();
        const JointAngles q = encoder_quantum(profile);
        const Position here = forward(profile.geometry, angles).value().p_DH;
        double farthest = 0.0;  // largest over all directions of a joint step of length one count
        for (int i = 0; i < 3600; ++i) {
            const double a = i * 2.0 * 3.14159265358979 / 3600.0;
            const JointAngles turn{q.x * std::cos(a), q.y * std::sin(a)};
            const Position there = forward(profile.geometry, angles + turn).value().p_DH;
            farthest = std::max(farthest, norm(there - here));
        }
        EXPECT_NEAR(encoder_step_m(profile), farthest, 0.01 * farthest) << profile.name;
    }
    EXPECT_NEAR(encoder_step_m(find_profile("2diy-gen3.1").value()), 200e-6, 20e-6);
}

}  // namespace
}  // namespace touchline
