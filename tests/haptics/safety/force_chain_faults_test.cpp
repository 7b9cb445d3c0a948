// What stops the force, and how it comes back.

#include "tests/haptics/safety/chains.h"

#include <cmath>

namespace touchline {
namespace {

TEST(ForceChain, NotFiniteIsZeroThisTickAndAFaultUntilTheOperatorClearsIt) {
    const Jacobian bad_pose{{nan, 0.0}, {0.0, 0.05}};
    for (int kind = 0; kind < 7; ++kind) {
        ForceChain chain = live_chain();
        (void)settled(chain, {1.0, 0.0});
        ChainInput bad = wanting({1.0, 0.0});
        if (kind == 0) bad.wanted_D.x = nan;
        if (kind == 1) bad.jacobian = bad_pose;
        if (kind == 2) bad.p_D.y = nan;
        if (kind == 3) bad.velocity_D.x = nan;
        if (kind == 4) bad.is_unreadable = true;
        const SafeForce out = chain.step(bad, kind == 5 ? nan : kind == 6 ? -1.0 : tick_s);
        EXPECT_EQ(out.force_D, Force{}) << kind;
        EXPECT_EQ(out.torques, JointTorques{});
        EXPECT_EQ(out.limit, Limit::fault);
        EXPECT_EQ(chain.state(), ForceState::fault);
        EXPECT_EQ(chain.status().fault, Fault::not_finite);
        EXPECT_EQ(settled(chain, {1.0, 0.0}).force_D, Force{});
        ChainInput cleared = wanting({1.0, 0.0});
        cleared.is_cleared = true;
        (void)chain.step(cleared, tick_s);
        EXPECT_EQ(chain.state(), ForceState::armed);
        EXPECT_EQ(chain.status().fault, Fault::none);
    }
}

TEST(ForceChain, AFastHandIsOnlyBraked) {
    ForceChain chain = live_chain();
    (void)settled(chain, {1.0, 0.5});
    ChainInput fast = wanting({1.0, 0.5});
    fast.velocity_D = {1.2, 0.0};
    const SafeForce across = chain.step(fast, tick_s);
    EXPECT_NEAR(across.force_D.x, 0.0, 1e-11);
    EXPECT_NEAR(across.force_D.y, 0.5, 1e-12);
    EXPECT_EQ(across.limit, Limit::speed);
    fast.wanted_D = {-0.5, 0.0};
    EXPECT_EQ(run(chain, fast).force_D, (Force{-0.5, 0.0}));
    EXPECT_EQ(chain.state(), ForceState::live);
}

TEST(ForceChain, AHandFasterThanHandsAreIsAFaultUntilItWasSlowForASecond) {
    ForceChain chain = live_chain();
    ChainInput input = wanting({});
    input.velocity_D = {0.0, -1.6};
    EXPECT_EQ(chain.step(input, tick_s).limit, Limit::fault);
    EXPECT_EQ(chain.status().fault, Fault::too_fast);
    input.velocity_D = {0.0, -0.19};
    (void)run(chain, input, 990);
    EXPECT_EQ(chain.state(), ForceState::fault);
    (void)run(chain, input, 20);
    EXPECT_EQ(chain.state(), ForceState::armed);
}

TEST(ForceChain, WarmMotorsGetLessForceAndComeBackCold) {
    ForceLimits limits;
    limits.warming_s = 1.0;
    ForceChain chain = live_chain(limits);
    const double full_N = settled(chain, {3.0, 0.0}, good_pose).force_D.x;
    ChainInput moving = wanting({3.0, 0.0});
    SafeForce warm;
    for (int i = 0; i < 5000; ++i) {
        moving.p_D.y = i / 100 % 2 == 0 ? 0.0 : 0.001;  // there is a hand
        warm = chain.step(moving, tick_s);
    }
    EXPECT_TRUE(warm.limit >= Limit::heat);
    EXPECT_LT(warm.force_D.x, 0.7 * full_N);
    EXPECT_LE(warm.torques.x * warm.torques.x, 0.9 * 0.6 * 0.6 * 0.123 * 0.123);
    EXPECT_GT(chain.status().limited[static_cast<std::size_t>(Limit::heat)], 1000U);
    (void)run(chain, wanting({}), 3000);
    EXPECT_NEAR(settled(chain, {3.0, 0.0}).force_D.x, full_N, 1e-9);
}

/// The handle moves along with the force, which no spring does for long.
TEST(ForceChain, EnergyGivenIsDampedAndThenAFaultUntilForceIsSwitchedOff) {
    ForceChain chain = live_chain();
    ChainInput input = wanting({2.0, 0.0});
    input.velocity_D = {0.3, 0.0};
    double given_J = 0.0;
    double damped_at_J = 0.0;
    while (chain.state() != ForceState::fault && given_J < 1.0) {
        input.p_D.x += 0.3 * tick_s;
        const SafeForce out = chain.step(input, tick_s);
        given_J += 0.3 * tick_s * out.force_D.x;
        if (out.limit == Limit::damped && damped_at_J == 0.0) damped_at_J = given_J;
    }
    EXPECT_NEAR(damped_at_J, 0.05, 0.01);
    EXPECT_NEAR(given_J, 0.45, 0.15);  // it forgets a part
    EXPECT_EQ(chain.status().fault, Fault::energy);
    (void)run(chain, wanting({}), 5000);
    EXPECT_EQ(chain.state(), ForceState::fault);
    input.is_wanted = false;
    (void)chain.step(input, tick_s);
    EXPECT_EQ(chain.state(), ForceState::off);
}

TEST(ForceChain, ALoopThatRingsThoughItWasSoftenedIsAFault) {
    ForceChain chain = live_chain();
    ChainInput input = wanting({0.2, 0.0});
    for (int i = 0; i < 1000; ++i) {
        if (i % 200 == 0) ++input.cuts;  // now and then: it is only softened
        (void)chain.step(input, tick_s);
    }
    EXPECT_EQ(chain.state(), ForceState::live);
    for (int i = 0; i < 500; ++i) {
        if (i % 100 == 0) ++input.cuts;
        (void)chain.step(input, tick_s);
    }
    EXPECT_EQ(chain.status().fault, Fault::ringing);
}

/// The force drives the device's mass alone; if the loop rang before, the knob counts as lost.
TEST(ForceChain, AHandleThatFliesAloneLosesForceAndOneThatRangIsAFault) {
    for (const bool rang : {false, true}) {
        ForceLimits limits;
        ForceChain chain = live_chain(limits);
        ChainInput input = wanting({1.5, 0.0});
        input.cuts = rang ? 1 : 0;
        int ticks = 0;
        for (; ticks < 300 && chain.state() == ForceState::live; ++ticks) {
            const double drive_N = chain.step(input, tick_s).force_D.x -
                                   (input.velocity_D.x > 0.0 ? limits.tip.coulomb_N : 0.0) -
                                   limits.tip.viscous_Ns_per_m * input.velocity_D.x;
            input.velocity_D.x += drive_N / limits.tip.mass_kg * tick_s;
            input.p_D.x += input.velocity_D.x * tick_s;
        }
        EXPECT_LT(ticks, 60);
        EXPECT_LT(input.velocity_D.x, 1.0);
        if (rang) {
            EXPECT_EQ(chain.status().fault, Fault::knob_lost);
            continue;
        }
        input.velocity_D = {};
        EXPECT_EQ(run(chain, input, 60).force_D, Force{});
        EXPECT_EQ(chain.state(), ForceState::armed);
        input.wanted_D = {};
        (void)run(chain, input, 2000);
        EXPECT_EQ(chain.state(), ForceState::armed);  // until a hand moves it
        input.p_D.x += 0.001;
        (void)run(chain, input, 300);
        EXPECT_EQ(chain.state(), ForceState::ramp);
    }
}

}  // namespace
}  // namespace touchline
