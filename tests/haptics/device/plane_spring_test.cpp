// The spring that holds a handle with three axes to the drawing plane.
#include "haptics/device/plane_spring.h"

#include "haptics/safety/guards.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

const DeviceProfile inverse3 = find_device_profile("inverse3").value();
const PlaneSpring spring = inverse3.cartesian->spring;
constexpr double all = 1.0;

TEST(PlaneSpring, OnThePlaneTheForceIsAsTold) {
    const PlaneForce force = held_to_plane(inverse3, {1.0, -2.0}, 0.0, 0.0, all);
    EXPECT_EQ(force.in_plane_D, (Force{1.0, -2.0}));
    EXPECT_EQ(force.across_N, 0.0);
}

TEST(PlaneSpring, PullsBackAndBrakes) {
    EXPECT_DOUBLE_EQ(held_to_plane(inverse3, {}, 0.002, 0.0, all).across_N, -0.8);
    EXPECT_DOUBLE_EQ(held_to_plane(inverse3, {}, -0.002, 0.0, all).across_N, 0.8);
    EXPECT_DOUBLE_EQ(held_to_plane(inverse3, {}, 0.0, 0.1, all).across_N, -0.2);
    EXPECT_DOUBLE_EQ(held_to_plane(inverse3, {}, spring.held_m, 0.0, all).across_N, -spring.most_N);
}

TEST(PlaneSpring, ShareBoundsItAndAtNoneNothingActsAcross) {
    EXPECT_DOUBLE_EQ(held_to_plane(inverse3, {}, 0.02, 0.0, 0.2).across_N, -0.2 * spring.most_N);
    EXPECT_EQ(held_to_plane(inverse3, {1.0, 0.0}, 0.001, 1.0, 0.0).across_N, 0.0);
}

TEST(PlaneSpring, OffThePlaneTheForceInItFadesToNone) {
    EXPECT_EQ(held_to_plane(inverse3, {1.0, 0.0}, spring.on_plane_m, 0.0, all).in_plane_D.x, 1.0);
    const double halfway_m = 0.5 * (spring.on_plane_m + spring.off_plane_m);
    EXPECT_NEAR(share_on_plane(spring, -halfway_m), 0.5, 1e-12);
    EXPECT_NEAR(held_to_plane(inverse3, {9.0, 0.0}, -halfway_m, 0.0, all).in_plane_D.x,
                0.5 * inverse3.force_limit_N, 1e-12);
    EXPECT_EQ(share_on_plane(spring, std::numeric_limits<double>::quiet_NaN()), 0.0);
    EXPECT_EQ(held_to_plane(inverse3, {1.0, 0.0}, spring.off_plane_m, 0.0, all).in_plane_D,
              Force{});
    EXPECT_EQ(held_to_plane(inverse3, {1.0, 0.0}, 1.0, 0.0, all).in_plane_D, Force{});
}

TEST(PlaneSpring, FarFromThePlaneNothingHoldsTheHandle) {
    const double halfway_m = 0.5 * (spring.held_m + spring.let_go_m);
    EXPECT_NEAR(held_to_plane(inverse3, {}, halfway_m, 0.0, all).across_N, -0.5 * spring.most_N,
                1e-12);
    for (const double off_m : {spring.let_go_m, -spring.let_go_m, 0.15, 1e300})
        EXPECT_EQ(held_to_plane(inverse3, {}, off_m, -0.5, all).across_N, 0.0) << off_m;
}

TEST(PlaneSpring, AHandleThatIsLetGoComesDownSlowly) {
    constexpr double mass_kg = 0.15;
    for (double height_m : {0.004, 0.01, 0.02, 0.0299, 0.15}) {
        double off_m = height_m;
        double speed_m_per_s = 0.0;
        double fastest_m_per_s = 0.0;
        double lowest_m = off_m;
        for (int i = 0; i < 3000; ++i) {
            const PlaneForce force = held_to_plane(inverse3, {}, off_m, speed_m_per_s, all);
            speed_m_per_s += force.across_N / mass_kg * tick_s;
            off_m += speed_m_per_s * tick_s;
            fastest_m_per_s = std::max(fastest_m_per_s, std::abs(speed_m_per_s));
            lowest_m = std::min(lowest_m, off_m);
        }
        EXPECT_LT(fastest_m_per_s, 0.75 * braked_m_per_s) << height_m;
        EXPECT_GT(lowest_m, -spring.held_m) << height_m << ": it is caught below the plane";
        EXPECT_TRUE(height_m < spring.let_go_m || off_m == height_m) << "it stays";
    }
}

RC_GTEST_PROP(PlaneSpring, NothingDrivesAcrossOnAFastHandle, ()) {
    const double off_m = *rc::gen::inRange(-40, 41) * 1e-3;
    const double speed_m_per_s = *rc::gen::inRange(-3000, 3001) * 1e-3;
    DeviceProfile strong = inverse3;  // would drive by its numbers
    strong.cartesian->spring.damping_Ns_per_m = 0.1;
    for (const DeviceProfile& any : {inverse3, strong}) {
        const double across_N = held_to_plane(any, {}, off_m, speed_m_per_s, all).across_N;
        RC_ASSERT(std::abs(speed_m_per_s) <= braked_m_per_s || across_N * speed_m_per_s <= 0.0);
    }
}

TEST(PlaneSpring, ADeviceWithoutOneGetsNoForceOffItsPlaneAndNoneAcross) {
    DeviceProfile without = inverse3;
    without.cartesian->spring = {};
    for (const double off_m : {-0.001, 0.0, 0.001}) {
        const PlaneForce force = held_to_plane(without, {1.0, 0.0}, off_m, 0.1, all);
        EXPECT_EQ(force.in_plane_D, Force{});
        EXPECT_EQ(force.across_N, 0.0);
    }
    EXPECT_EQ(held_to_plane(default_profile(), {1.0, 0.0}, 0.0, 0.0, all).in_plane_D, Force{});
}

TEST(PlaneSpring, WhatIsNoNumberGivesNoForce) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (const PlaneForce& force : {held_to_plane(inverse3, {bad, 0.0}, 0.001, 0.0, all),
                                        held_to_plane(inverse3, {1.0, 0.0}, bad, 0.0, all),
                                        held_to_plane(inverse3, {1.0, 0.0}, 0.001, bad, all),
                                        held_to_plane(inverse3, {1.0, 0.0}, 0.001, 0.0, bad),
                                        held_to_plane(inverse3, {1.0, 0.0}, 0.001, 0.0, 1.5),
                                        held_to_plane(inverse3, {1.0, 0.0}, 0.001, 0.0, -0.1)}) {
            EXPECT_EQ(force.in_plane_D, Force{});
            EXPECT_EQ(force.across_N, 0.0);
        }
    }
}

RC_GTEST_PROP(PlaneSpring, BothForcesTogetherAreWithinTheDevicesLimit, ()) {
    const auto number = [](int most) { return *rc::gen::inRange(-1000, 1001) * 1e-3 * most; };
    const double share = *rc::gen::inRange(0, 1001) * 1e-3;
    const Force told{number(20), number(20)};
    const PlaneForce force = held_to_plane(inverse3, told, number(1) * 0.04, number(3), share);
    const double size_N = std::hypot(norm(force.in_plane_D), force.across_N);
    RC_ASSERT(size_N <= inverse3.force_limit_N * (1.0 + 1e-12));
    RC_ASSERT(std::abs(force.across_N) <= share * spring.most_N);
    RC_ASSERT(norm(force.in_plane_D) <= norm(told) * (1.0 + 1e-12));
    RC_ASSERT(std::abs(cross(force.in_plane_D, told)) <= 1e-9);
}

}  // namespace
}  // namespace touchline
