// The parts of the force chain, each on its own.

#include "haptics/safety/guards.h"

#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/safety/hand_presence.h"
#include "tests/haptics/safety/chains.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(SpeedLimit, LeavesWhatBrakesAndWhatGoesAcross) {
    const Force across = without_drive({1.0, 2.0}, {3.0, 0.0});
    EXPECT_NEAR(norm(across - Force{0.0, 2.0}), 0.0, 1e-11);
    EXPECT_LT(across.x, 0.0);
    EXPECT_EQ(without_drive({5e-324, 0.0}, {1.1, -0.9}), Force{});
    EXPECT_EQ(without_drive({-1.0, 2.0}, {3.0, 0.0}), (Force{-1.0, 2.0}));
    EXPECT_FALSE(is_braked(0.99));
    EXPECT_TRUE(is_braked(1.01));
    EXPECT_TRUE(is_braked(nan));
}

/// A handle at rest is not driven, and nothing can drive it along.
TEST(SpeedLimit, LeavesEveryForceOnAHandleAtRest) {
    EXPECT_EQ(without_drive({1.0, -2.0}, {}), (Force{1.0, -2.0}));
}

TEST(SpeedLimit, ATraceOfForceIsNone) {
    EXPECT_EQ(without_drive({-1e-10, 0.0}, {3.0, 0.0}), Force{});
}

TEST(SpeedWatch, TooFastIsAboveTheLimit) {
    SpeedWatch watch;
    EXPECT_FALSE(watch.step(1.5, tick_s));
    EXPECT_TRUE(watch.step(1.501, tick_s));
}

/// The state ends after a full second slower than 0.2 m/s.
TEST(SpeedWatch, TooFastEndsAfterASecondOfSlowness) {
    constexpr double quarter_s = 0.25;
    SpeedWatch watch;
    EXPECT_TRUE(watch.step(2.0, quarter_s));
    for (int i = 0; i < 8; ++i) EXPECT_TRUE(watch.step(0.2, quarter_s));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(watch.step(0.1, quarter_s));
    EXPECT_TRUE(watch.step(0.5, quarter_s));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(watch.step(0.1, quarter_s));
    EXPECT_FALSE(watch.step(0.1, quarter_s));
}

TEST(SpeedWatch, NoNumberIsTooFast) {
    SpeedWatch watch;
    EXPECT_FALSE(watch.step(1.49, tick_s));
    EXPECT_TRUE(watch.step(nan, tick_s));
    EXPECT_TRUE(watch.step(0.5, tick_s));
}

TEST(MotorHeat, TheContinuousTorqueWarmsToTheRatedRise) {
    MotorHeat heat(0.07, 60.0);
    for (int i = 0; i < 60'000; ++i) heat.step({0.0, -0.07}, tick_s);
    EXPECT_NEAR(heat.rise(), 1.0 - std::exp(-1.0), 1e-4);
    for (int i = 0; i < 600'000; ++i) heat.step({0.0, -0.07}, tick_s);
    EXPECT_NEAR(heat.rise(), 1.0, 1e-4);
    EXPECT_EQ(heat.allowed(), 0.0);
}

TEST(MotorHeat, IsTakenOverFromAnotherServoAndCoolsFromThere) {
    MotorHeat heat(0.07, 60.0);
    heat.warm(0.8);
    EXPECT_DOUBLE_EQ(heat.rise(), 0.8);
    EXPECT_NEAR(heat.allowed(), 0.5, 1e-9);
    heat.warm(0.1);
    EXPECT_DOUBLE_EQ(heat.rise(), 0.8) << "never cooler than it was";
    heat.step({}, 30.0);
    EXPECT_LT(heat.rise(), 0.5);
}

TEST(MotorHeat, IsDeratedStraightFrom70To90PerCent) {
    for (const double rise : {0.5, 0.7, 0.75, 0.8, 0.85, 0.9, 1.2}) {
        MotorHeat heat(1.0, 1e-3);
        heat.step({std::sqrt(rise), 0.1}, tick_s);  // reached in one tick, the time constant
        EXPECT_NEAR(heat.rise(), rise, 1e-12);
        EXPECT_NEAR(heat.allowed(), std::clamp((0.9 - rise) / 0.2, 0.0, 1.0), 1e-9) << rise;
    }
}

TEST(EnergyGuard, DampsFromAFiftiethOfAJouleAndForgets) {
    EnergyGuard guard;
    guard.step({1.0, 0.0}, {0.04, 0.0}, tick_s);
    EXPECT_EQ(guard.damping_Ns_per_m(), 0.0);
    EXPECT_NEAR(guard.given_J(), 0.04, 1e-12);
    guard.step({1.0, 0.0}, {0.04, 0.0}, tick_s);
    EXPECT_GT(guard.damping_Ns_per_m(), 1.0);
    EXPECT_FALSE(guard.is_too_much());
    guard.step({1.0, 0.0}, {0.24, 0.0}, tick_s);
    EXPECT_TRUE(guard.is_too_much());
    for (int i = 0; i < 5000; ++i) guard.step({}, {}, tick_s);
    EXPECT_LT(guard.given_J(), 0.003);
}

TEST(EnergyGuard, WhatTheHandGaveIsNoCredit) {
    EnergyGuard guard;
    guard.step({-1.0, 0.0}, {10.0, 0.0}, tick_s);
    EXPECT_EQ(guard.given_J(), 0.0);
    guard.step({nan, 0.0}, {1.0, 0.0}, tick_s);
    EXPECT_TRUE(guard.is_too_much());
}

TEST(PositionGuard, AJumpIsHeldForThreeTicksAndThenTold) {
    PositionGuard guard(2e-4);
    EXPECT_EQ(guard.step({0.03, 0.0}, tick_s), Sample::good);
    EXPECT_EQ(guard.step({0.03 + 1.8e-3, 0.0}, tick_s), Sample::good);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(guard.step({0.05, 0.0}, tick_s), Sample::held);
    EXPECT_EQ(guard.step({0.05, 0.0}, tick_s), Sample::jumped);
    EXPECT_EQ(guard.step({0.05, 0.0}, tick_s), Sample::good);
}

TEST(PositionGuard, AGlitchIsPassedOver) {
    PositionGuard guard(2e-4);
    (void)guard.step({}, tick_s);
    EXPECT_EQ(guard.step({0.05, 0.0}, tick_s), Sample::held);
    EXPECT_EQ(guard.step({nan, 0.0}, tick_s), Sample::held);
    EXPECT_EQ(guard.step({1e-3, 0.0}, tick_s), Sample::good);
    guard.miss(0.02);
    EXPECT_EQ(guard.step({0.03, 0.0}, tick_s), Sample::good);  // there was time enough
}

/// A distant good place of long ago does not make a jump of today possible.
TEST(PositionGuard, AJumpIsHeldHoweverLongAllWasWell) {
    PositionGuard guard(2e-4);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(guard.step({}, tick_s), Sample::good);
    EXPECT_EQ(guard.step({0.05, 0.0}, tick_s), Sample::held);
}

/// Each glitch is held for three ticks in a row; those of an earlier glitch do not count.
TEST(PositionGuard, EveryGlitchIsHeldForThreeTicks) {
    PositionGuard guard(2e-4);
    for (int glitch = 0; glitch < 3; ++glitch) {
        ASSERT_EQ(guard.step({}, tick_s), Sample::good);
        for (int i = 0; i < 3; ++i) ASSERT_EQ(guard.step({0.05, 0.0}, tick_s), Sample::held);
    }
}

/// Puts a device under a steady force in the hand of somebody who means to stay put. Returns when
/// it was found to be without a hand; 0: never, in a second.
double found_alone_s(const HandModel& hand, double force_N, double mass_factor) {
    const TipMechanics tip{0.07, 0.2, 0.1, 2e-4};
    TipDynamics dynamics({mass_factor * tip.mass_kg, tip.viscous_Ns_per_m, tip.coulomb_N}, hand,
                         {});
    HandPresence presence(tip);
    for (int i = 1; i <= 1000; ++i) {
        for (int k = 0; k < 8; ++k) dynamics.step({force_N, 0.0}, {}, tick_s / 8);
        const MassState& state = dynamics.tip();
        if (presence.step({force_N, 0.0}, state.velocity, state.position, tick_s))
            return i * tick_s;
    }
    return 0.0;
}

TEST(HandPresence, FindsAHandleThatMovesAlone) {
    for (const double force_N : {1.2, 2.0, 3.0}) {
        for (const double mass_factor : {0.85, 1.0, 1.15}) {
            const double found_s = found_alone_s(no_hand, force_N, mass_factor);
            EXPECT_GT(found_s, 0.029) << force_N << ", " << mass_factor;
            EXPECT_LT(found_s, 0.08) << force_N << ", " << mass_factor;
        }
    }
}

TEST(HandPresence, LeavesEveryHandItsForce) {
    HandModel skinned = relaxed_arm;
    skinned.skin = HandModel::Skin{1000.0, 1.0};
    for (const HandModel& hand : {light_hand, normal_hand, relaxed_arm, stiff_arm, skinned}) {
        for (const double force_N : {0.3, 0.8, 1.5, 3.0}) {
            EXPECT_EQ(found_alone_s(hand, force_N, 1.0), 0.0) << hand.mass_kg << ", " << force_N;
        }
    }
}

TEST(HandPresence, StandingStillUnderForceForTwentySecondsIsNoHand) {
    HandPresence presence({});
    int ticks = 0;
    while (!presence.step({0.6, 0.0}, {}, {0.01, 0.0}, tick_s) && ticks < 50'000) ++ticks;
    EXPECT_NEAR(ticks, 20'000, 5);
    EXPECT_FALSE(presence.is_alone());
    EXPECT_TRUE(presence.step({0.4, 0.0}, {}, {0.0102, 0.0}, tick_s));
    EXPECT_FALSE(presence.step({0.4, 0.0}, {}, {0.0106, 0.0}, tick_s));  // the hand follows
}

TEST(HandPresence, LittleForceOrATremorIsEnoughToBeBelieved) {
    HandPresence resting({});
    HandPresence shaking({});
    for (int i = 0; i < 60'000; ++i) {
        const double y_m = 1.2e-4 * std::sin(2.0 * std::numbers::pi * 8.0 * tick_s * i);
        EXPECT_FALSE(resting.step({0.45, 0.0}, {}, {0.01, 0.0}, tick_s));
        EXPECT_FALSE(shaking.step({1.0, 0.0}, {}, {0.01, y_m}, tick_s));
    }
}

TEST(HandPresence, AHandleLeftAloneIsGivenTimeToCoast) {
    HandPresence presence({});
    double x_m = 0.0;
    double speed = 0.0;
    while (!presence.step({2.0, 0.0}, {speed, 0.0}, {x_m, 0.0}, tick_s) && speed < 5.0) {
        speed += (1.9 - 0.2 * speed) / 0.07 * tick_s;
        x_m += speed * tick_s;
    }
    EXPECT_TRUE(presence.is_alone());
    for (int i = 0; i < 490; ++i) {
        x_m += 1e-4;
        EXPECT_TRUE(presence.step({}, {0.1, 0.0}, {x_m, 0.0}, tick_s));
    }
    for (int i = 0; i < 20; ++i) (void)presence.step({}, {}, {x_m, 0.0}, tick_s);
    EXPECT_TRUE(presence.step({}, {}, {x_m + 3e-4, 0.0}, tick_s));
    EXPECT_FALSE(presence.step({}, {}, {x_m + 5e-4, 0.0}, tick_s));
}

}  // namespace
}  // namespace touchline
