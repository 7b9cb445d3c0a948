#include "haptics/device/simulated/simulated_cartesian.h"

#include "tests/haptics/tick.h"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

namespace touchline {
namespace {

const DeviceProfile& of_three_axes() {
    return cartesian_profiles().front();
}

std::shared_ptr<MouseHand> hand_there(Position p_W) {
    return std::make_shared<MouseHand>(p_W);
}

TEST(SimulatedCartesian, StartsWhereTheHandIs) {
    SimulatedCartesian device(of_three_axes(), {}, hand_there({0.01, -0.02}),
                              hand_there({0.03, 0.0}));
    const DeviceReading told = device.read(0.0).value();
    EXPECT_NEAR(norm(told.p_D.value() - of_three_axes().centre - Position{-0.01, 0.02}), 0.0, 2e-5);
    EXPECT_FALSE(told.jacobian.has_value());
    EXPECT_NEAR(device.off_m(), 0.03, 1e-7);
}

TEST(SimulatedCartesian, TellsPlacesInWholeStepsAndItsVelocity) {
    SimulatedCartesian device(of_three_axes(), {}, hand_there({}));
    const double step_m = encoder_step_m(of_three_axes());
    for (int k = 0; k < 300; ++k) {
        const DeviceReading told = device.read(k * tick_s).value();
        (void)device.write({{1.0, 0.5}, {}, 0.0, 0.0});
        const double steps = told.p_D->x / step_m;
        ASSERT_NEAR(steps, std::round(steps), 1e-6);
        ASSERT_EQ(*told.velocity_D, turned(device.tip().velocity));
    }
    EXPECT_LT(device.tip().position.x, -1e-3) << "a push to +x in D goes to -x in W";
}

TEST(SimulatedCartesian, AForceActsAfterTheDelayNotBefore) {
    DeviceProfile profile = of_three_axes();
    profile.mechanics.delay_s = 2.5 * tick_s;
    SimulatedCartesian device(profile, {}, hand_there({}));
    (void)device.read(0.0);
    (void)device.write({{1.0, 0.0}, {}, 0.0, 0.0});
    (void)device.read(2.0 * tick_s);
    EXPECT_EQ(device.acting().in_plane_D, Force{});
    (void)device.read(3.0 * tick_s);
    EXPECT_EQ(device.acting().in_plane_D, (Force{1.0, 0.0}));
}

TEST(SimulatedCartesian, ThePlanesSpringIsOfItsShareAndWithinTheLimit) {
    SimulatedCartesian device(of_three_axes(), {}, hand_there({}), hand_there({0.02, 0.0}));
    (void)device.read(0.0);
    (void)device.write({{100.0, 0.0}, {}, 0.0, 0.5});
    (void)device.read(5.0 * tick_s);
    const double most_N = 0.5 * cartesian_profiles().front().cartesian->spring.most_N;
    EXPECT_GE(device.acting().across_N, -most_N);
    EXPECT_LT(device.acting().across_N, -0.9 * most_N) << "all but what its damping takes";
    EXPECT_EQ(device.acting().in_plane_D, Force{}) << "off the plane";
    SimulatedCartesian on_plane(of_three_axes(), {}, hand_there({}));
    (void)on_plane.read(0.0);
    (void)on_plane.write({{100.0, 0.0}, {}, 0.0, 1.0});
    (void)on_plane.read(5.0 * tick_s);
    EXPECT_NEAR(norm(on_plane.acting().in_plane_D), of_three_axes().force_limit_N, 1e-9);
}

TEST(SimulatedCartesian, WithoutAHandTheSpringBringsItToThePlaneAndItStaysThere) {
    CartesianOptions options;
    options.hand = no_hand;
    SimulatedCartesian device(of_three_axes(), options, hand_there({}), hand_there({0.015, 0.0}));
    for (int k = 0; k < 3000; ++k) {
        (void)device.read(k * tick_s);
        (void)device.write({{}, {}, 0.0, 1.0});
    }
    EXPECT_LT(std::abs(device.off_m()), 1e-3);
    const double rest_m = device.off_m();
    (void)device.read(3.5);
    EXPECT_EQ(device.off_m(), rest_m);
}

TEST(SimulatedCartesian, WhatIsNoNumberIsZero) {
    SimulatedCartesian device(of_three_axes(), {}, hand_there({}));
    (void)device.read(0.0);
    (void)device.write({{std::numeric_limits<double>::quiet_NaN(), 1.0}, {}, 0.0, 1.0});
    (void)device.read(5.0 * tick_s);
    EXPECT_EQ(device.acting().in_plane_D, Force{});
    EXPECT_EQ(device.acting().across_N, 0.0);
}

}  // namespace
}  // namespace touchline
