#include "tests/haptics/safety/chains.h"

#include <cmath>

namespace touchline {
namespace {

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

TEST(ForceChain, HA2_FadesOutWithin50MillisecondsAndResumes) {
    ForceChain chain = live_chain();
    (void)settled(chain, {1.5, 0.0});
    ChainInput fading = wanting({1.5, 0.0});
    fading.is_fading = true;
    int ticks = 0;
    for (; !chain.is_faded() && ticks < 100; ++ticks) (void)chain.step(fading, tick_s);
    EXPECT_LE(ticks, 51);
    EXPECT_EQ(chain.step(fading, tick_s).force_D, Force{});
    (void)run(chain, wanting({1.5, 0.0}), 298);
    EXPECT_EQ(chain.state(), ForceState::ramp);  // no sooner than after 0.3 s
    (void)run(chain, wanting({1.5, 0.0}), 3);
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
