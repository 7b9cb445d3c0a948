#include "haptics/safety/force_chain.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double tick_s = 1e-3;
// A pose of a 2diy gen 3: condition about 1.
constexpr Jacobian good_pose{{-0.049, -0.0496}, {-0.049, 0.0496}};

Jacobian pose_with_condition(double c) {
    return {{0.02 * c, 0.0}, {0.0, 0.02}};
}

ChainInput wanting(Force wanted, const Jacobian& pose = good_pose) {
    ChainInput input;
    input.wanted_D = wanted;
    input.jacobian = pose;
    return input;
}

ForceChain live_chain(const ForceLimits& limits = {}) {
    ForceChain chain(limits);
    for (int i = 0; i < 1000; ++i) (void)chain.step(wanting({}), tick_s);
    EXPECT_EQ(chain.state(), ForceState::live);
    return chain;
}

SafeForce run(ForceChain& chain, const ChainInput& input, int ticks = 100) {
    SafeForce last;
    for (int i = 0; i < ticks; ++i) last = chain.step(input, tick_s);
    return last;
}

SafeForce settled(ForceChain& chain, Force wanted, const Jacobian& pose = good_pose) {
    return run(chain, wanting(wanted, pose));
}

TEST(ForceChain, IsSilentWhileNobodyWantsForce) {
    ForceChain chain{ForceLimits{}};
    ChainInput input = wanting({1.0, 1.0});
    input.is_wanted = false;
    const SafeForce out = run(chain, input);
    EXPECT_EQ(out.force_D, Force{});
    EXPECT_EQ(out.torques, JointTorques{});
    EXPECT_EQ(chain.state(), ForceState::off);
}

TEST(ForceChain, SwitchedOffItIsSilentWithinTheSoftStop) {
    ForceChain chain = live_chain();
    (void)settled(chain, {1.5, 0.0});
    ChainInput input = wanting({1.5, 0.0});
    input.is_wanted = false;
    EXPECT_EQ(run(chain, input, 2).force_D, Force{});
    EXPECT_EQ(chain.state(), ForceState::off);
}

TEST(ForceChain, ArmsOnlyAfterForceWasSmallForAFifthOfASecond) {
    ForceChain chain{ForceLimits{}};
    for (int i = 0; i < 1000; ++i) (void)chain.step(wanting({0.5, 0.0}), tick_s);
    EXPECT_EQ(chain.state(), ForceState::armed);
    for (int i = 0; i < 195; ++i) (void)chain.step(wanting({0.05, 0.0}), tick_s);
    EXPECT_EQ(chain.state(), ForceState::armed);
    for (int i = 0; i < 10; ++i) (void)chain.step(wanting({0.05, 0.0}), tick_s);
    EXPECT_EQ(chain.state(), ForceState::ramp);
}

TEST(ForceChain, RampsUpInHalfASecond) {
    ForceChain chain{ForceLimits{}};
    while (chain.state() != ForceState::ramp) (void)chain.step(wanting({}), tick_s);
    SafeForce out = run(chain, wanting({1.0, 0.0}), 249);
    EXPECT_NEAR(out.force_D.x, 0.5, 0.01);
    EXPECT_EQ(out.limit, Limit::gain);
    out = run(chain, wanting({1.0, 0.0}), 252);
    EXPECT_EQ(out.force_D, (Force{1.0, 0.0}));
    EXPECT_EQ(out.limit, Limit::none);
    EXPECT_EQ(chain.state(), ForceState::live);
}

TEST(ForceChain, FadesOutWithin50MillisecondsAndResumes) {
    ForceChain chain = live_chain();
    (void)settled(chain, {1.5, 0.0});
    ChainInput fading = wanting({1.5, 0.0});
    fading.is_fading = true;
    int ticks = 0;
    for (; !chain.is_faded() && ticks < 100; ++ticks) (void)chain.step(fading, tick_s);
    EXPECT_LE(ticks, 51);
    EXPECT_EQ(chain.step(fading, tick_s).force_D, Force{});
    (void)run(chain, wanting({1.5, 0.0}), 151);
    EXPECT_EQ(chain.state(), ForceState::live);
    EXPECT_EQ(settled(chain, {1.5, 0.0}).force_D, (Force{1.5, 0.0}));
}

TEST(ForceChain, ClampsTheVectorAndKeepsItsDirection) {
    ForceLimits limits;
    limits.torque_Nm = 10.0;
    ForceChain chain = live_chain(limits);
    const SafeForce out = settled(chain, {6.0, 8.0});
    EXPECT_NEAR(out.force_D.x, 1.8, 1e-12);
    EXPECT_NEAR(out.force_D.y, 2.4, 1e-12);
    EXPECT_EQ(out.limit, Limit::force);
}

TEST(ForceChain, ScalesBothMotorsWhenOneSaturates) {
    ForceChain chain = live_chain();
    const Jacobian pose{{0.06, 0.03}, {0.0, 0.05}};
    const SafeForce out = settled(chain, {2.5, 1.0}, pose);
    EXPECT_EQ(out.limit, Limit::torque);
    EXPECT_NEAR(out.torques.x, 0.9 * 0.123, 1e-15);
    EXPECT_NEAR(out.force_D.y / out.force_D.x, 1.0 / 2.5, 1e-12);
    EXPECT_NEAR(out.torques.y, 0.05 * out.force_D.y, 1e-15);
}

TEST(ForceChain, GrowsAt300NewtonsASecondAndTurnsAt1500) {
    ForceChain chain = live_chain();
    EXPECT_NEAR(chain.step(wanting({1.0, 0.0}), tick_s).force_D.x, 0.3, 1e-12);
    EXPECT_EQ(chain.step(wanting({1.0, 0.0}), tick_s).limit, Limit::slew);
    (void)settled(chain, {1.0, 0.0});
    const Force turning = chain.step(wanting({0.0, 1.0}), tick_s).force_D;
    EXPECT_NEAR(norm(turning - Force{0.0, 1.0}), 0.0, 1e-12);  // 1.41 N away, 1.5 N allowed
    const Force reversed = chain.step(wanting({0.0, -2.0}), tick_s).force_D;
    EXPECT_NEAR(reversed.y, -0.5, 1e-12);
}

TEST(ForceChain, SoftStopFromThreeNewtonsTakesTwoMilliseconds) {
    ForceLimits limits;
    limits.torque_Nm = 10.0;
    ForceChain chain = live_chain(limits);
    (void)settled(chain, {3.0, 0.0});
    EXPECT_NEAR(chain.step(wanting({}), tick_s).force_D.x, 1.5, 1e-12);
    EXPECT_NEAR(chain.step(wanting({}), tick_s).force_D.x, 0.0, 1e-12);
}

TEST(ForceChain, FadesToNothingTowardsASingularPose) {
    ForceLimits limits;
    limits.torque_Nm = 10.0;
    ForceChain chain = live_chain(limits);
    EXPECT_EQ(settled(chain, {1.0, 0.0}, pose_with_condition(4.9)).force_D.x, 1.0);
    const SafeForce half = settled(chain, {1.0, 0.0}, pose_with_condition(5.5));
    EXPECT_NEAR(half.force_D.x, 0.5, 1e-9);
    EXPECT_EQ(half.limit, Limit::pose);
    EXPECT_EQ(settled(chain, {1.0, 0.0}, pose_with_condition(6.0)).force_D, Force{});
    EXPECT_EQ(settled(chain, {1.0, 0.0}, {{0.1, 0.0}, {0.0, 0.0}}).torques, JointTorques{});
    EXPECT_EQ(chain.state(), ForceState::live);
}

TEST(ForceChain, UnknownPoseIsZeroAtOnceAndComesBackSlowly) {
    ForceChain chain = live_chain();
    (void)settled(chain, {1.5, 0.0});
    ChainInput unknown = wanting({1.5, 0.0});
    unknown.jacobian.reset();
    const SafeForce out = chain.step(unknown, tick_s);
    EXPECT_EQ(out.force_D, Force{});
    EXPECT_EQ(out.torques, JointTorques{});
    EXPECT_EQ(out.limit, Limit::unreachable);
    EXPECT_NEAR(chain.step(wanting({1.5, 0.0}), tick_s).force_D.x, 0.3, 1e-12);
}

TEST(ForceChain, NotFiniteIsZeroThisTickAndAFaultUntilTheOperatorClearsIt) {
    const Jacobian bad_pose{{nan, 0.0}, {0.0, 0.05}};
    for (int kind = 0; kind < 8; ++kind) {
        ForceChain chain = live_chain();
        (void)settled(chain, {1.0, 0.0});
        ChainInput bad = wanting({1.0, 0.0});
        if (kind == 0) bad.wanted_D.x = nan;
        if (kind == 1) bad.jacobian = bad_pose;
        if (kind == 2) bad.p_D.y = nan;
        if (kind == 3) bad.velocity_D.x = nan;
        if (kind == 4) bad.sample_age_s = nan;
        if (kind == 5) bad.is_unreadable = true;
        const SafeForce out = chain.step(bad, kind == 6 ? nan : kind == 7 ? -1.0 : tick_s);
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

TEST(ForceChain, OldSamplesStopForceWithinFiveMillisecondsAndAreAFaultAfterTwenty) {
    ForceChain chain = live_chain();
    (void)settled(chain, {2.0, 0.0});
    ChainInput input = wanting({2.0, 0.0});
    for (int ms = 0; ms < 20; ++ms) {
        input.sample_age_s = 1e-3 * ms;
        const SafeForce out = chain.step(input, tick_s);
        if (ms < 3) {
            EXPECT_NEAR(out.force_D.x, 2.0, 0.01);
        }
        if (ms >= 3) {
            EXPECT_EQ(out.limit, Limit::late);
        }
        if (ms >= 4) {
            EXPECT_EQ(out.force_D, Force{});
        }
        EXPECT_EQ(chain.state(), ForceState::live);
    }
    input.sample_age_s = 0.02;
    (void)chain.step(input, tick_s);
    EXPECT_EQ(chain.status().fault, Fault::samples_late);
    (void)chain.step(wanting({2.0, 0.0}), tick_s);
    EXPECT_EQ(chain.state(), ForceState::armed);
}

TEST(ForceChain, AFastHandIsOnlyBraked) {
    ForceChain chain = live_chain();
    (void)settled(chain, {1.0, 0.5});
    ChainInput fast = wanting({1.0, 0.5});
    fast.velocity_D = {1.2, 0.0};
    const SafeForce across = chain.step(fast, tick_s);
    EXPECT_EQ(across.force_D.x, 0.0);
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
    EXPECT_NEAR(given_J, 0.2, 0.05);  // a part of it is forgotten
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
        if (i % 200 == 0) ++input.cuts;  // once in a while: it is softened, and that is all
        (void)chain.step(input, tick_s);
    }
    EXPECT_EQ(chain.state(), ForceState::live);
    for (int i = 0; i < 500; ++i) {
        if (i % 100 == 0) ++input.cuts;
        (void)chain.step(input, tick_s);
    }
    EXPECT_EQ(chain.status().fault, Fault::ringing);
}

/// A mass of the device's own, driven by the force it is told: once it rang, the knob is gone.
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

TEST(ForceChain, CountsTheTicksOfEveryLimit) {
    ForceChain chain = live_chain();
    const auto count = [&](Limit limit) {
        return chain.status().limited[static_cast<std::size_t>(limit)];
    };
    const std::uint32_t before = count(Limit::slew);
    (void)chain.step(wanting({1.0, 0.0}), tick_s);
    (void)chain.step(wanting({1.0, 0.0}), tick_s);
    EXPECT_EQ(count(Limit::slew), before + 2);
    EXPECT_EQ(count(Limit::fault), 0U);
    EXPECT_GT(count(Limit::gain), 500U);
}

TEST(ForceChain, LimitsComeFromTheDevice) {
    DeviceProfile weak = default_profile();
    weak.force_limit_N = 1.2;
    weak.torque_limit_Nm = 0.1;
    EXPECT_EQ(limits_of(weak).force_N, 1.2);
    EXPECT_DOUBLE_EQ(limits_of(weak).torque_Nm, 0.09);
    weak.force_limit_N = 10.0;
    EXPECT_EQ(limits_of(weak).force_N, 3.0);
}

}  // namespace
}  // namespace touchline
