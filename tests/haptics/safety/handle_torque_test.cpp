// The torque of a motor at the handle: the chain's limits hold for it as they do for the force.
#include "tests/haptics/safety/chains.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double limit_Nm = 0.09;

ForceLimits with_handle() {
    return limits_of(find_profile("gen3.1-turning").value());
}

ChainInput twisting(double torque_Nm) {
    ChainInput input = wanting({});
    input.wanted_turn_Nm = torque_Nm;
    return input;
}

TEST(HandleTorque, WithoutAMotorThereIsNone) {
    ForceChain chain = live_chain();
    EXPECT_EQ(run(chain, twisting(0.05)).handle_Nm, 0.0);
}

TEST(HandleTorque, WithinItsLimitItIsWhatIsWanted) {
    ForceChain chain = live_chain(with_handle());
    EXPECT_EQ(run(chain, twisting(-0.03)).handle_Nm, -0.03);
    EXPECT_NEAR(run(chain, twisting(5.0)).handle_Nm, limit_Nm, 1e-12);
    EXPECT_NEAR(run(chain, twisting(-5.0)).handle_Nm, -limit_Nm, 1e-12);
}

TEST(HandleTorque, RisesAndTurnsRoundByItsRates) {
    ForceChain chain = live_chain(with_handle());
    double before_Nm = 0.0;
    for (int i = 0; i < 200; ++i) {
        const double wanted_Nm = i % 70 < 35 ? 0.05 : -0.05;
        const double told_Nm = chain.step(twisting(wanted_Nm), tick_s).handle_Nm;
        EXPECT_LE(std::abs(told_Nm), std::abs(before_Nm) + 0.003 + 1e-12);
        EXPECT_LE(std::abs(told_Nm - before_Nm), 0.015 + 1e-12);
        before_Nm = told_Nm;
    }
}

TEST(HandleTorque, FadesWithTheForceAndStopsWithEveryFault) {
    ForceChain chain = live_chain(with_handle());
    EXPECT_GT(run(chain, twisting(0.05)).handle_Nm, 0.0);
    ChainInput fading = twisting(0.05);
    fading.is_fading = true;
    EXPECT_EQ(run(chain, fading).handle_Nm, 0.0);
    chain = live_chain(with_handle());
    (void)run(chain, twisting(0.05));
    ChainInput lost = twisting(0.05);
    lost.is_lost = true;
    EXPECT_EQ(chain.step(lost, tick_s).handle_Nm, 0.0);
}

TEST(HandleTorque, NoPoseIsNoTorque) {
    ForceChain chain = live_chain(with_handle());
    (void)run(chain, twisting(0.05));
    ChainInput lost = twisting(0.05);
    lost.jacobian.reset();
    EXPECT_EQ(chain.step(lost, tick_s).handle_Nm, 0.0);
}

TEST(HandleTorque, WhatIsNoNumberIsAFaultAndZero) {
    for (double ChainInput::*field :
         {&ChainInput::wanted_turn_Nm, &ChainInput::handle_rad, &ChainInput::turn_rad_per_s}) {
        ForceChain chain = live_chain(with_handle());
        (void)run(chain, twisting(0.05));
        ChainInput broken = twisting(0.05);
        broken.*field = nan;
        const SafeForce told = chain.step(broken, tick_s);
        EXPECT_EQ(told.handle_Nm, 0.0);
        EXPECT_EQ(told.force_D, Force{});
        EXPECT_EQ(chain.status().fault, Fault::not_finite);
    }
}

TEST(HandleTorque, AFastTurnIsOnlyBraked) {
    ForceChain chain = live_chain(with_handle());
    (void)run(chain, twisting(0.05));
    ChainInput fast = twisting(0.05);
    fast.turn_rad_per_s = 13.0;
    EXPECT_EQ(chain.step(fast, tick_s).handle_Nm, 0.0);
    fast.wanted_turn_Nm = -0.05;
    EXPECT_LT(run(chain, fast).handle_Nm, -0.04);
}

TEST(HandleTorque, TheOperatorsCeilingLowersItToo) {
    ForceChain chain = live_chain(with_handle());
    ChainInput input = twisting(0.09);
    input.ceiling_N = 1.0;
    EXPECT_NEAR(run(chain, input).handle_Nm, limit_Nm / 3.0, 1e-12);
}

TEST(HandleTorque, AWarmMotorLetsGo) {
    ForceChain chain = live_chain(with_handle());
    double told_Nm = 0.0;
    for (int i = 0; i < 120'000; ++i) told_Nm = chain.step(twisting(0.09), tick_s).handle_Nm;
    EXPECT_LT(told_Nm, 0.06);
    EXPECT_GT(told_Nm, 0.03);
}

TEST(HandleTorque, WorkOfTheTorqueIsBooked) {
    ForceChain chain = live_chain(with_handle());
    ChainInput input = twisting(0.08);
    (void)run(chain, input, 50);
    for (int i = 0; i < 500 && chain.state() != ForceState::fault; ++i) {
        input.handle_rad += 0.01;  // 10 rad/s
        (void)chain.step(input, tick_s);
    }
    EXPECT_EQ(chain.status().fault, Fault::energy);
}

/// A handle that is held half a turn away does no work.
TEST(HandleTorque, NoWorkIsDoneAtRest) {
    ForceChain chain = live_chain(with_handle());
    ChainInput input = twisting(0.08);
    input.handle_rad = 3.0;
    (void)run(chain, input, 1000);
    EXPECT_EQ(chain.status().fault, Fault::none);
}

/// Turns of less than 0.2 mm at the fingers count as encoder noise.
TEST(HandleTorque, AHandThatOnlyTurnsIsThere) {
    for (const double turn_rad : {0.0, 0.005, 0.2}) {
        ForceChain chain = live_chain(with_handle());
        ChainInput input = wanting({0.8, 0.0});
        for (int i = 0; i < 25'000; ++i) {
            input.handle_rad = turn_rad * std::sin(0.002 * i);
            (void)chain.step(input, tick_s);
        }
        EXPECT_EQ(chain.state() == ForceState::live, turn_rad > 0.1) << turn_rad;
    }
}

/// It does so whatever torque came before.
TEST(HandleTorque, BeginsAtZeroAfterAFault) {
    ForceChain chain = live_chain(with_handle());
    (void)run(chain, twisting(0.05));
    ChainInput lost = twisting(0.05);
    lost.is_lost = true;
    (void)run(chain, lost);
    ChainInput cleared = twisting(0.0);
    cleared.is_cleared = true;
    for (int i = 0; i < 2000; ++i) EXPECT_EQ(chain.step(cleared, tick_s).handle_Nm, 0.0);
    EXPECT_EQ(chain.state(), ForceState::live);
}

TEST(HandleTorque, IsNoneWhereNobodyAskedForOne) {
    ForceChain chain = live_chain(with_handle());
    EXPECT_EQ(run(chain, wanting({0.5, 0.0})).handle_Nm, 0.0);
}

TEST(HandleTorque, ArmingWaitsUntilItIsSmall) {
    ForceChain chain(with_handle());
    (void)run(chain, twisting(0.01), 1000);
    EXPECT_EQ(chain.state(), ForceState::armed);
    (void)run(chain, twisting(0.0), 1000);
    EXPECT_EQ(chain.state(), ForceState::live);
}

}  // namespace
}  // namespace touchline
