// The spring that holds a handle with three axes to the drawing plane.
#include "haptics/device/plane_spring.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr PlaneSpring spring{};
constexpr double all = 1.0;

TEST(PlaneSpring, OnThePlaneTheForceIsAsTold) {
    const PlaneForce force = held_to_plane(spring, {1.0, -2.0}, 0.0, 0.0, all);
    EXPECT_EQ(force.in_plane_D, (Force{1.0, -2.0}));
    EXPECT_EQ(force.across_N, 0.0);
}

TEST(PlaneSpring, PullsBackAndBrakes) {
    EXPECT_DOUBLE_EQ(held_to_plane(spring, {}, 0.002, 0.0, all).across_N, -0.8);
    EXPECT_DOUBLE_EQ(held_to_plane(spring, {}, -0.002, 0.0, all).across_N, 0.8);
    EXPECT_DOUBLE_EQ(held_to_plane(spring, {}, 0.0, 0.1, all).across_N, -0.2);
    EXPECT_DOUBLE_EQ(held_to_plane(spring, {}, 0.05, 0.0, all).across_N, -spring.most_N);
}

TEST(PlaneSpring, ShareBoundsItAndAtNoneNothingActsAcross) {
    EXPECT_DOUBLE_EQ(held_to_plane(spring, {}, 0.05, 0.0, 0.2).across_N, -0.2 * spring.most_N);
    EXPECT_EQ(held_to_plane(spring, {1.0, 0.0}, 0.001, 1.0, 0.0).across_N, 0.0);
}

TEST(PlaneSpring, OffThePlaneTheForceInItFadesToNone) {
    EXPECT_EQ(held_to_plane(spring, {1.0, 0.0}, spring.on_plane_m, 0.0, all).in_plane_D.x, 1.0);
    const double halfway_m = 0.5 * (spring.on_plane_m + spring.off_plane_m);
    EXPECT_NEAR(held_to_plane(spring, {1.0, 0.0}, -halfway_m, 0.0, all).in_plane_D.x, 0.5, 1e-12);
    EXPECT_EQ(held_to_plane(spring, {1.0, 0.0}, spring.off_plane_m, 0.0, all).in_plane_D, Force{});
    EXPECT_EQ(held_to_plane(spring, {1.0, 0.0}, 1.0, 0.0, all).in_plane_D, Force{});
}

TEST(PlaneSpring, WhatIsNoNumberGivesNoForce) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        for (const PlaneForce& force : {held_to_plane(spring, {bad, 0.0}, 0.001, 0.0, all),
                                        held_to_plane(spring, {1.0, 0.0}, bad, 0.0, all),
                                        held_to_plane(spring, {1.0, 0.0}, 0.001, bad, all),
                                        held_to_plane(spring, {1.0, 0.0}, 0.001, 0.0, bad),
                                        held_to_plane(spring, {1.0, 0.0}, 0.001, 0.0, 1.5),
                                        held_to_plane(spring, {1.0, 0.0}, 0.001, 0.0, -0.1)}) {
            EXPECT_EQ(force.in_plane_D, Force{});
            EXPECT_EQ(force.across_N, 0.0);
        }
    }
}

RC_GTEST_PROP(PlaneSpring, BothForcesTogetherAreWithinTheDevicesLimit, ()) {
    const auto number = [](int most) { return *rc::gen::inRange(-1000, 1001) * 1e-3 * most; };
    const double share = *rc::gen::inRange(0, 1001) * 1e-3;
    const Force told{number(20), number(20)};
    const PlaneForce force = held_to_plane(spring, told, number(1) * 0.02, number(3), share);
    const double size_N = std::hypot(norm(force.in_plane_D), force.across_N);
    RC_ASSERT(size_N <= spring.limit_N * (1.0 + 1e-12));
    RC_ASSERT(std::abs(force.across_N) <= share * spring.most_N);
    RC_ASSERT(norm(force.in_plane_D) <= norm(told) * (1.0 + 1e-12));
    RC_ASSERT(std::abs(cross(force.in_plane_D, told)) <= 1e-9);
}

}  // namespace
}  // namespace touchline
