#include "haptics/pantograph/kinematics.h"

#include "config/types/angle.h"
#include "haptics/pantograph/profile.h"
#include "tests/haptics/pantograph/workspace.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Kinematics, ForwardOfInverseIsThePointOverEveryWorkspace) {
    for (const DeviceProfile& profile : device_profiles()) {
        const int points = visit_workspace(
            profile.geometry, 1.7 * mm, [&](Position p, JointAngles, const Pose& pose) {
                // The rounding of the angles reaches the tip through the Jacobian.
                const double error_m = norm(pose.p_DH - p);
                const double rounding_m = 1e-15 * (1.0 + singular_values(pose.jacobian).largest);
                EXPECT_LE(error_m, 1e-12 + 10.0 * rounding_m) << profile.name << p.x << ' ' << p.y;
            });
        EXPECT_GT(points, 4000) << profile.name;
    }
}

TEST(Kinematics, InverseOfForwardIsTheAnglesOverEveryWorkspace) {
    for (const DeviceProfile& profile : device_profiles()) {
        visit_workspace(profile.geometry, 1.7 * mm, [&](Position, JointAngles a, const Pose& pose) {
            if (condition(pose.jacobian) > 100.0)
                return;  // the tip does not define the angles there
            const JointAngles again = inverse(profile.geometry, pose.p_DH).value();
            EXPECT_LE(norm(again - a), 1e-12 * (1.0 + condition(pose.jacobian))) << profile.name;
        });
    }
}

TEST(Kinematics, JacobianIsTheNumericDerivativeOverEveryWorkspace) {
    constexpr double step = 1e-6;
    for (const DeviceProfile& profile : device_profiles()) {
        const Geometry& g = profile.geometry;
        int compared = 0;
        visit_workspace(g, 2.9 * mm, [&](Position, JointAngles a, const Pose& pose) {
            if (condition(pose.jacobian) > 30.0) return;  // the difference itself is inexact there
            const auto slope = [&](JointAngles turn) {
                const auto before = forward(g, a - turn);
                const auto after = forward(g, a + turn);
                return along<TipPerTurn>(after.value().p_DH - before.value().p_DH, 0.5 / step);
            };
            const double tolerance =
                1e-8 * (1.0 + std::pow(singular_values(pose.jacobian).largest / g.distal_m, 3.0));
            EXPECT_LE(norm(slope({step, 0.0}) - pose.jacobian.joint_1), tolerance);
            EXPECT_LE(norm(slope({0.0, step}) - pose.jacobian.joint_2), tolerance);
            ++compared;
        });
        EXPECT_GT(compared, 1000) << profile.name;
    }
}

struct ReferencePose {
    Geometry geometry;
    double angle_1_deg, angle_2_deg;
    double x_mm, y_mm;
    Jacobian jacobian;
};

TEST(Kinematics, ReferencePosesHaveTheirPublishedDigits) {
    const ReferencePose poses[] = {
        {gen2, 241, -61, 0, 22.13, {{-.01107, -.00451}, {-.01107, .00451}}},
        {gen3, 97.23, 82.77, 19, 155.04, {{-.04828, -.01569}, {-.04828, .01569}}},
        {gen3, 168, 12, 19, 35.74, {{-.01557, -.06428}, {-.01557, .06428}}},
        {gen3, 130, 50, 19, 116.91, {{-.04906, -.04961}, {-.04906, .04961}}},
        {gen3, 150, 60, -4.91, 105.68, {{-.03504, -.06059}, {-.05554, .04378}}},
    };
    for (const ReferencePose& r : poses) {
        const Pose pose =
            forward(r.geometry, {radians(r.angle_1_deg), radians(r.angle_2_deg)}).value();
        EXPECT_NEAR(pose.p_DH.x / mm, r.x_mm, 0.005);
        EXPECT_NEAR(pose.p_DH.y / mm, r.y_mm, 0.005);
        EXPECT_NEAR(pose.jacobian.joint_1.x, r.jacobian.joint_1.x, 5e-6);
        EXPECT_NEAR(pose.jacobian.joint_1.y, r.jacobian.joint_1.y, 5e-6);
        EXPECT_NEAR(pose.jacobian.joint_2.x, r.jacobian.joint_2.x, 5e-6);
        EXPECT_NEAR(pose.jacobian.joint_2.y, r.jacobian.joint_2.y, 5e-6);
    }
}

Pose some_pose() {
    const double x = *rc::gen::inRange(-30, 68) * mm;
    const double y = *rc::gen::inRange(52, 136) * mm;
    return forward(gen3, inverse(gen3, {x, y}).value()).value();
}

Force some_force() {
    return {*rc::gen::inRange(-3000, 3001) / 1000.0, *rc::gen::inRange(-3000, 3001) / 1000.0};
}

RC_GTEST_PROP(Kinematics, WorkAtTheTipIsWorkAtTheMotors, ()) {
    const Pose pose = some_pose();
    const Force f = some_force();
    const JointAngles turn{*rc::gen::inRange(-100, 101) * 1e-4,
                           *rc::gen::inRange(-100, 101) * 1e-4};
    const TipPerTurn move = turn.x * pose.jacobian.joint_1 + turn.y * pose.jacobian.joint_2;
    RC_ASSERT(std::abs(dot(f, move) - dot(joint_torques(pose.jacobian, f), turn)) <= 1e-15);
}

RC_GTEST_PROP(Kinematics, TipForceUndoesJointTorques, ()) {
    const Pose pose = some_pose();
    const Force f = some_force();
    const auto back = tip_force(pose.jacobian, joint_torques(pose.jacobian, f));
    RC_ASSERT(back.has_value());
    RC_ASSERT(norm(*back - f) <= 1e-13);
}

RC_GTEST_PROP(Kinematics, SingularValuesBoundTheTipsMotion, ()) {
    const Pose pose = some_pose();
    const double angle = *rc::gen::inRange(0, 6284) / 1000.0;
    const TipPerTurn move = std::cos(angle) * pose.jacobian.joint_1 +  //
                            std::sin(angle) * pose.jacobian.joint_2;
    const SingularValues s = singular_values(pose.jacobian);
    RC_ASSERT(norm(move) <= s.largest * (1.0 + 1e-12));
    RC_ASSERT(norm(move) >= s.smallest * (1.0 - 1e-12));
    RC_ASSERT(std::abs(condition(pose.jacobian) - s.largest / s.smallest) <= 1e-12);
}

TEST(Kinematics, ConditionGrowsWithoutBoundTowardsAStretchedArm) {
    const double bearing = radians(75.0);  // within the reach of arm 2
    double before = 1.0;
    for (const double short_of_m : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const double reach_m = gen3.proximal_m + gen3.distal_m - short_of_m;
        const Position p{reach_m * std::cos(bearing), reach_m * std::sin(bearing)};
        const double now = condition(forward(gen3, inverse(gen3, p).value()).value().jacobian);
        EXPECT_GT(now, 4.0 * before);
        before = now;
    }
}

TEST(Kinematics, ConditionGrowsWithoutBoundTowardsDistalLinksInLine) {
    const Geometry g{0.070, 0.080, 0.038};
    double before = 1.0;
    for (const double short_of_m : {1e-3, 1e-5, 1e-7, 1e-9}) {
        const double width_m = 2.0 * g.distal_m - short_of_m;
        const double angle = std::acos((width_m - g.base_m) / (2.0 * g.proximal_m));
        const Pose pose = forward(g, {std::numbers::pi - angle, angle}).value();
        EXPECT_GT(condition(pose.jacobian), 4.0 * before);
        before = condition(pose.jacobian);
    }
}

TEST(Kinematics, OutOfReachIsNothing) {
    EXPECT_FALSE(inverse(gen3, {0.019, 0.170}));
    EXPECT_FALSE(inverse(gen3, {-0.2, 0.0}));
    EXPECT_FALSE(inverse(gen3, {0.0, 0.0}));
    EXPECT_FALSE(inverse(gen3, {0.0, 0.01}));  // nearer than L - l to motor 1
    EXPECT_FALSE(forward({0.07, 0.08, 0.038}, {std::numbers::pi, 0.0}));  // wider than 2 L
    EXPECT_FALSE(forward(gen2, {1.0, 1.0}));                              // folded: elbows coincide
}

TEST(Kinematics, AnElbowTurnedInIsAnotherBranchAndNothing) {
    const Position p{0.030, 0.100};
    const JointAngles out = inverse(gen3, p).value();
    const double bearing_1 = std::atan2(p.y, p.x);
    const double bearing_2 = std::atan2(p.y, p.x - gen3.base_m);
    EXPECT_FALSE(forward(gen3, {2.0 * bearing_1 - out.x, out.y}));
    EXPECT_FALSE(forward(gen3, {out.x, 2.0 * bearing_2 - out.y}));
}

TEST(Kinematics, NotFiniteIsNothing) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_FALSE(forward(gen3, {bad, 0.2}));
        EXPECT_FALSE(forward(gen3, {2.9, bad}));
        EXPECT_FALSE(inverse(gen3, {bad, 0.1}));
        EXPECT_FALSE(inverse(gen3, {0.0, bad}));
    }
    EXPECT_FALSE(tip_force({{0.1, 0.0}, {0.1, 0.0}}, {0.1, 0.1}));
    EXPECT_FALSE(tip_force({{nan, 0.0}, {0.1, 0.0}}, {0.1, 0.1}));
    EXPECT_EQ(condition({{0.0, 0.0}, {0.1, 0.0}}), infinity);
    EXPECT_EQ(condition({{nan, 0.0}, {0.1, 0.0}}), infinity);
}

}  // namespace
}  // namespace touchline
