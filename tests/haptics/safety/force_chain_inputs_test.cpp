// What each input of the chain does on its own, and where each of its limits comes from.

#include "haptics/pantograph/profile.h"
#include "tests/haptics/safety/chains.h"

#include <array>
#include <cstdint>
#include <limits>

namespace touchline {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::uint32_t ticks_of(const ForceChain& chain, Limit limit) {
    return chain.status().limited[static_cast<std::size_t>(limit)];
}

struct Cause {
    bool ChainInput::*flag;
    Fault fault;
};

TEST(ForceChainInputs, StopLossAndJumpAreZeroInTheSameTickAndTold) {
    for (const auto& [flag, fault] : {Cause{&ChainInput::is_stopped, Fault::emergency_stop},
                                      Cause{&ChainInput::is_lost, Fault::device_lost},
                                      Cause{&ChainInput::has_jumped, Fault::position_jump}}) {
        ForceChain chain = live_chain();
        (void)settled(chain, {1.0, 0.0});
        EXPECT_EQ(chain.status().state, ForceState::live);
        ChainInput input = wanting({1.0, 0.0});
        input.*flag = true;
        const SafeForce out = chain.step(input, tick_s);
        EXPECT_EQ(out.force_D, Force{});
        EXPECT_EQ(out.torques, JointTorques{});
        EXPECT_EQ(out.limit, Limit::fault);
        EXPECT_EQ(chain.status().state, ForceState::fault);
        EXPECT_EQ(chain.status().fault, fault);
        EXPECT_TRUE(chain.is_faded());
    }
}

TEST(ForceChainInputs, EitherJointOfThePoseMayBeNoNumber) {
    for (const Jacobian& bad :
         {Jacobian{{0.05, 0.0}, {nan, 0.05}}, Jacobian{{0.05, nan}, {0.0, 0.05}},
          Jacobian{{0.05, 0.0}, {0.0, infinity}}}) {
        ForceChain chain = live_chain();
        EXPECT_EQ(chain.step(wanting({1.0, 0.0}, bad), tick_s).force_D, Force{});
        EXPECT_EQ(chain.status().fault, Fault::not_finite);
    }
}

TEST(ForceChainInputs, TheShareIsOfForceAndLimit) {
    ForceLimits limits;
    limits.torque_Nm = 10.0;
    const auto with_share = [&](double share, double wanted_N) {
        ForceChain chain = live_chain(limits);
        ChainInput input = wanting({wanted_N, 0.0});
        input.share = share;
        return run(chain, input).force_D.x;
    };
    EXPECT_NEAR(with_share(0.5, 1.0), 0.5, 1e-12);
    EXPECT_NEAR(with_share(0.5, 5.0), 1.5, 1e-12);  // half of 3 N
    EXPECT_NEAR(with_share(2.0, 1.0), 1.0, 1e-12);
    EXPECT_NEAR(with_share(infinity, 5.0), 3.0, 1e-12);
    for (const double none : {0.0, -1.0, nan}) {
        ForceChain chain = live_chain(limits);
        ChainInput input = wanting({1.0, 0.0});
        input.share = none;
        EXPECT_EQ(run(chain, input, 5).force_D, Force{}) << none;
        EXPECT_EQ(chain.state(), ForceState::off) << none;
    }
}

TEST(ForceChainInputs, TheLeastOfTheCeilingsHolds) {
    for (const auto& [force_N, ceiling_N, most_N] :
         {std::array{2.0, 3.0, 2.0}, std::array{3.0, 1.0, 1.0}, std::array{3.0, 0.5, 0.5},
          std::array{3.0, 0.0, 0.0}, std::array{3.0, -1.0, 0.0}, std::array{3.0, nan, 0.0}}) {
        ForceLimits limits;
        limits.torque_Nm = 10.0;
        limits.force_N = force_N;
        ForceChain chain = live_chain(limits);
        ChainInput input = wanting({5.0, 0.0});
        input.ceiling_N = ceiling_N;
        EXPECT_NEAR(run(chain, input).force_D.x, most_N, 1e-12) << force_N << ", " << ceiling_N;
    }
}

TEST(ForceChainInputs, LimitsOfHeatAndHandComeFromTheDeviceToo) {
    DeviceProfile device = default_profile();
    device.torque_limit_Nm = 0.2;
    device.mechanics.continuous_torque = 0.4;
    device.mechanics.warming_s = 33.0;
    device.mechanics.tip_mass_kg = 0.11;
    device.mechanics.viscous_Ns_per_m = 0.7;
    device.mechanics.coulomb_N = 0.05;
    const ForceLimits limits = limits_of(device);
    EXPECT_DOUBLE_EQ(limits.continuous_torque_Nm, 0.08);
    EXPECT_EQ(limits.warming_s, 33.0);
    EXPECT_EQ(limits.tip.mass_kg, 0.11);
    EXPECT_EQ(limits.tip.viscous_Ns_per_m, 0.7);
    EXPECT_EQ(limits.tip.coulomb_N, 0.05);
    EXPECT_EQ(limits.tip.count_m, encoder_step_m(device));
}

TEST(ForceChainInputs, ADeviceThatTakesForcesHasItsOwnLimits) {
    const DeviceProfile& device = cartesian_profiles().front();
    const ForceLimits limits = limits_of(device);
    EXPECT_EQ(limits.continuous_N, device.cartesian->continuous_N);
    EXPECT_EQ(limits.force_N, device.force_limit_N);
    EXPECT_EQ(limits.tip.count_m, device.cartesian->step_m);
    EXPECT_FALSE(limits_of(default_profile()).continuous_N.has_value());
}

/// It needs no Jacobian, and one that is singular takes nothing away.
TEST(ForceChainInputs, WithoutJointsThereIsNoPoseAndNoTorque) {
    for (const bool has_one : {false, true}) {
        ForceChain chain = live_chain(of_forces());
        ChainInput input = wanting({2.5, 0.5}, pose_with_condition(100.0));
        if (!has_one) input.jacobian.reset();
        const SafeForce out = run(chain, input);
        EXPECT_NEAR(out.force_D.x, 2.5, 1e-12);
        EXPECT_NEAR(out.force_D.y, 0.5, 1e-12);
        EXPECT_EQ(out.torques, JointTorques{});
    }
}

TEST(ForceChainInputs, WithoutJointsAPlaceThatIsNotKnownIsZeroAtOnce) {
    ForceChain chain = live_chain(of_forces());
    (void)settled(chain, {2.0, 0.0});
    ChainInput unknown = wanting({2.0, 0.0});
    unknown.is_placed = false;
    const SafeForce out = chain.step(unknown, tick_s);
    EXPECT_EQ(out.force_D, Force{});
    EXPECT_EQ(out.plane_share, 0.0);
    EXPECT_EQ(out.limit, Limit::unreachable);
}

/// With joints it is the Jacobian that is needed, wherever the handle is said to be.
TEST(ForceChainInputs, WithJointsAPlaceWithoutAJacobianIsZero) {
    ForceChain chain = live_chain();
    ChainInput input = wanting({1.0, 0.0});
    input.jacobian.reset();
    EXPECT_EQ(run(chain, input).force_D, Force{});
}

/// The force that is borne forever warms to the rated rise, and from 70 % of it less is let
/// through.
TEST(ForceChainInputs, WithoutJointsHeatIsThatOfTheForce) {
    ForceLimits limits = of_forces();
    limits.warming_s = 0.5;
    ForceChain chain = live_chain(limits);
    EXPECT_NEAR(run(chain, wanting({1.2, 0.0}), 3000).force_D.x, 1.2, 1e-12);
    EXPECT_NEAR(chain.motor_heat(), 1.2 * 1.2 / (1.8 * 1.8), 5e-3);
    EXPECT_LT(run(chain, wanting({2.5, 0.0}), 3000).force_D.x, 1.8);
    EXPECT_LT(chain.motor_heat(), 0.9);
}

TEST(ForceChainInputs, WithoutJointsTheForceAcrossThePlaneWarmsToo) {
    ForceLimits limits = of_forces();
    limits.warming_s = 0.5;
    ForceChain chain = live_chain(limits);
    ChainInput held = wanting({0.9, 0.0});
    held.across_N = -1.2;
    EXPECT_NEAR(run(chain, held, 3000).force_D.x, 0.9, 1e-12);
    EXPECT_NEAR(chain.motor_heat(), 1.5 * 1.5 / (1.8 * 1.8), 5e-3);
    held.across_N = -1.8;
    EXPECT_LT(run(chain, held, 3000).plane_share, 1.0) << "the plane is held more softly";
}

TEST(ForceChainInputs, OffThePlaneTheForceFadesAndWhatIsFastAcrossIsFast) {
    ForceChain chain = live_chain(of_forces());
    ChainInput input = wanting({2.0, 0.0});
    input.on_plane = 0.25;
    EXPECT_NEAR(run(chain, input).force_D.x, 0.5, 1e-12);
    input.on_plane = nan;
    EXPECT_EQ(run(chain, input).force_D, Force{});
    input.on_plane = 1.0;
    input.across_m_per_s = 1.2;
    input.velocity_D = {0.1, 0.0};
    EXPECT_LE(run(chain, input).force_D.x, 0.0) << "it does not drive";
    input.across_m_per_s = 1.6;
    (void)chain.step(input, tick_s);
    EXPECT_EQ(chain.status().fault, Fault::too_fast);
}

TEST(ForceChainInputs, ThePlanesShareComesSlowlyOnceArmedAndGoesAtOnce) {
    ForceChain chain(of_forces());
    double before = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const double share = chain.step(wanting({}), tick_s).plane_share;
        const bool may_act = chain.state() == ForceState::ramp || chain.state() == ForceState::live;
        ASSERT_TRUE(may_act || share == 0.0);
        ASSERT_LE(share - before, 2.1e-3);
        before = share;
    }
    EXPECT_DOUBLE_EQ(before, 1.0);
    ChainInput fading = wanting({});
    fading.is_fading = true;
    EXPECT_DOUBLE_EQ(run(chain, fading).plane_share, 1.0) << "a picture is changed on the plane";
    ChainInput softer = wanting({});
    softer.ceiling_N = 1.5;
    EXPECT_DOUBLE_EQ(chain.step(softer, tick_s).plane_share, 0.5);
    softer.is_stopped = true;
    EXPECT_EQ(chain.step(softer, tick_s).plane_share, 0.0);
    ForceChain of_joints = live_chain();
    EXPECT_EQ(run(of_joints, wanting({})).plane_share, 0.0);
}

/// A tenth of a newton is not less than a tenth.
TEST(ForceChainInputs, ArmsBelowTheLimitAndNotAtIt) {
    ForceChain chain{ForceLimits{}};
    (void)run(chain, wanting({0.1, 0.0}), 1000);
    EXPECT_EQ(chain.state(), ForceState::armed);
    (void)run(chain, wanting({0.0999, 0.0}), 1000);
    EXPECT_EQ(chain.state(), ForceState::live);
}

TEST(ForceChainInputs, PosesFadeStraightBetweenTheirTwoConditions) {
    ForceLimits limits;
    limits.torque_Nm = 10.0;
    limits.condition_full = 5.0;
    limits.condition_zero = 9.0;
    ForceChain chain = live_chain(limits);
    for (const auto& [condition, gain] :
         {std::array{4.0, 1.0}, std::array{6.0, 0.75}, std::array{8.0, 0.25}, std::array{9.5, 0.0}})
        EXPECT_NEAR(settled(chain, {1.0, 0.0}, pose_with_condition(condition)).force_D.x, gain,
                    1e-9);
}

/// A profile with a continuous torque of zero makes the heat of the motors 0 / 0.
TEST(ForceChainInputs, WhatComesOutAsNoNumberIsAFault) {
    ForceLimits limits;
    limits.continuous_torque_Nm = 0.0;
    ForceChain chain(limits);
    SafeForce out;
    for (int i = 0; i < 5; ++i) {
        out = chain.step(wanting({1.0, 0.0}), tick_s);
        EXPECT_EQ(out.force_D, Force{});
        EXPECT_EQ(out.torques, JointTorques{});
    }
    EXPECT_EQ(out.limit, Limit::fault);
    EXPECT_EQ(chain.status().state, ForceState::fault);
    EXPECT_EQ(chain.status().fault, Fault::not_finite);
    EXPECT_TRUE(chain.is_faded());
}

TEST(ForceChainInputs, AFaultDoesNotHoldItselfUp) {
    ForceChain chain = live_chain();
    ChainInput input = wanting({0.2, 0.0});
    for (int i = 0; i < 4; ++i) {
        ++input.cuts;
        (void)chain.step(input, tick_s);
    }
    EXPECT_EQ(chain.status().fault, Fault::ringing);
    input.is_wanted = false;
    (void)chain.step(input, tick_s);
    EXPECT_EQ(chain.state(), ForceState::off);
}

TEST(ForceChainInputs, CutsAreForgottenInASecond) {
    ForceChain chain = live_chain();
    ChainInput input = wanting({0.2, 0.0});
    for (int i = 0; i < 3; ++i) {
        ++input.cuts;
        (void)run(chain, input, 400);  // 1 + 0.67 + 0.45 at most
    }
    EXPECT_EQ(chain.state(), ForceState::live);
    input.cuts += 3;
    (void)chain.step(input, tick_s);
    EXPECT_EQ(chain.status().fault, Fault::ringing);
}

/// Brakes grow from zero, not from the drive that was just taken away.
TEST(ForceChainInputs, AFastHandIsBrakedInTheSameTick) {
    ForceChain chain = live_chain();
    (void)settled(chain, {1.4, 0.0});
    ChainInput fast = wanting({-2.0, 0.0});
    fast.velocity_D = {1.2, 0.0};
    EXPECT_NEAR(chain.step(fast, tick_s).force_D.x, -0.3, 1e-9);
}

TEST(ForceChainInputs, EnergyGivenIsTakenBackByDamping) {
    ForceChain chain = live_chain();
    ChainInput input = wanting({2.0, 0.0});
    (void)settled(chain, {2.0, 0.0});
    const double full_N = chain.step(input, tick_s).force_D.x;
    input.velocity_D = {0.5, 0.0};
    for (int i = 0; i < 200; ++i) {  // 0.1 m: 0.2 J less what is forgotten and damped
        input.p_D.x += 0.5 * tick_s;
        (void)chain.step(input, tick_s);
    }
    ASSERT_EQ(chain.state(), ForceState::live);
    EXPECT_GT(ticks_of(chain, Limit::damped), 50U);
    EXPECT_NEAR(chain.step(input, tick_s).force_D.x, full_N - 2.0 * 0.5, 0.05);
}

bool chain_is_well(const ForceChain& chain) {
    return chain.state() != ForceState::fault;
}

/// Moves the handle as it moves when nobody holds it, for so many ticks.
void fly_alone(ForceChain& chain, ChainInput& input, int ticks) {
    const TipMechanics tip;
    for (int i = 0; i < ticks; ++i) {
        const double drive_N = chain.step(input, tick_s).force_D.x -
                               (input.velocity_D.x > 0.0 ? tip.coulomb_N : 0.0) -
                               tip.viscous_Ns_per_m * input.velocity_D.x;
        input.velocity_D.x += drive_N / tip.mass_kg * tick_s;
        input.p_D.x += input.velocity_D.x * tick_s;
    }
}

TEST(ForceChainInputs, AHandThatIsOffIsTold) {
    ForceChain chain = live_chain();
    ChainInput input = wanting({1.5, 0.0});
    fly_alone(chain, input, 60);
    EXPECT_GT(ticks_of(chain, Limit::hand), 0U);
    EXPECT_NE(chain.state(), ForceState::live);
}

/// One cut counts for 0.7 s: after that the knob does not count as lost, and nobody has to come.
TEST(ForceChainInputs, WhatRangASecondAgoIsForgottenWhenTheHandLetsGo) {
    ForceChain chain = live_chain();
    ChainInput input = wanting({0.0, 0.0});
    ++input.cuts;
    (void)run(chain, input, 1000);
    input.wanted_D = {1.5, 0.0};
    fly_alone(chain, input, 60);
    EXPECT_GT(ticks_of(chain, Limit::hand), 0U);
    EXPECT_NE(chain.state(), ForceState::fault);
}

/// Energy given to the hand, cuts and a missing hand would each cause the next fault.
TEST(ForceChainInputs, AFaultForgetsWhatWasBefore) {
    ForceLimits limits;
    limits.times.arm_s = 0.05;
    limits.times.start_s = 0.05;
    const auto stopped_and_cleared = [](ForceChain& chain, ChainInput input) {
        input.is_stopped = true;
        (void)chain.step(input, tick_s);
        input.is_stopped = false;
        input.is_cleared = true;
        (void)chain.step(input, tick_s);
        EXPECT_EQ(chain.state(), ForceState::armed);
    };
    ForceChain given = live_chain(limits);
    ChainInput input = wanting({2.0, 0.0});
    input.velocity_D = {0.3, 0.0};
    while (chain_is_well(given)) {
        input.p_D.x += 0.3 * tick_s;
        (void)given.step(input, tick_s);
    }
    EXPECT_EQ(given.status().fault, Fault::energy);
    stopped_and_cleared(given, wanting({}));
    const std::uint32_t damped = ticks_of(given, Limit::damped);
    (void)run(given, wanting({}), 200);
    EXPECT_EQ(given.state(), ForceState::live);
    EXPECT_EQ(ticks_of(given, Limit::damped), damped);

    ForceChain alone = live_chain(limits);
    input = wanting({1.5, 0.0});
    fly_alone(alone, input, 60);
    ASSERT_NE(alone.state(), ForceState::fault);
    input.velocity_D = {};
    input.wanted_D = {};
    stopped_and_cleared(alone, input);
    (void)run(alone, input, 200);
    EXPECT_EQ(alone.state(), ForceState::live);
    input.wanted_D = {1.5, 0.0};
    fly_alone(alone, input, 60);  // no cut ever happened, so it does not count as lost
    EXPECT_NE(alone.state(), ForceState::fault);
}

}  // namespace
}  // namespace touchline
