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

ForceChain live_chain(const ForceLimits& limits = {}) {
    ForceChain chain(limits);
    chain.arm();
    for (int i = 0; i < 1000; ++i) (void)chain.step({}, good_pose, tick_s);
    EXPECT_EQ(chain.state(), ForceState::live);
    return chain;
}

SafeForce settled(ForceChain& chain, Force wanted, const Jacobian& pose = good_pose) {
    SafeForce last;
    for (int i = 0; i < 100; ++i) last = chain.step(wanted, pose, tick_s);
    return last;
}

TEST(ForceChain, IsSilentUntilArmed) {
    ForceChain chain{ForceLimits{}};
    const SafeForce out = settled(chain, {1.0, 1.0});
    EXPECT_EQ(out.force_D, Force{});
    EXPECT_EQ(out.torques, JointTorques{});
    EXPECT_EQ(chain.state(), ForceState::off);
}

TEST(ForceChain, ArmsOnlyAfterForceWasSmallForAFifthOfASecond) {
    ForceChain chain{ForceLimits{}};
    chain.arm();
    for (int i = 0; i < 1000; ++i) (void)chain.step({0.5, 0.0}, good_pose, tick_s);
    EXPECT_EQ(chain.state(), ForceState::armed);
    for (int i = 0; i < 195; ++i) (void)chain.step({0.05, 0.0}, good_pose, tick_s);
    EXPECT_EQ(chain.state(), ForceState::armed);
    for (int i = 0; i < 10; ++i) (void)chain.step({0.05, 0.0}, good_pose, tick_s);
    EXPECT_EQ(chain.state(), ForceState::ramp);
}

TEST(ForceChain, RampsUpInHalfASecond) {
    ForceChain chain{ForceLimits{}};
    chain.arm();
    while (chain.state() != ForceState::ramp) (void)chain.step({}, good_pose, tick_s);
    SafeForce out;
    for (int i = 0; i < 249; ++i) out = chain.step({1.0, 0.0}, good_pose, tick_s);
    EXPECT_NEAR(out.force_D.x, 0.5, 0.01);
    EXPECT_EQ(out.limit, Limit::gain);
    for (int i = 0; i < 252; ++i) out = chain.step({1.0, 0.0}, good_pose, tick_s);
    EXPECT_EQ(out.force_D, (Force{1.0, 0.0}));
    EXPECT_EQ(out.limit, Limit::none);
    EXPECT_EQ(chain.state(), ForceState::live);
}

TEST(ForceChain, FadesOutWithin50MillisecondsAndResumes) {
    ForceChain chain = live_chain();
    (void)settled(chain, {1.5, 0.0});
    chain.fade();
    int ticks = 0;
    for (; !chain.is_faded() && ticks < 100; ++ticks) {
        (void)chain.step({1.5, 0.0}, good_pose, tick_s);
    }
    EXPECT_LE(ticks, 51);
    EXPECT_EQ(chain.step({1.5, 0.0}, good_pose, tick_s).force_D, Force{});
    chain.resume();
    for (int i = 0; i < 151; ++i) (void)chain.step({1.5, 0.0}, good_pose, tick_s);
    EXPECT_EQ(chain.state(), ForceState::live);
    EXPECT_EQ(settled(chain, {1.5, 0.0}).force_D, (Force{1.5, 0.0}));
}

TEST(ForceChain, ResumeDoesNotSwitchOnWhatWasNeverArmed) {
    ForceChain chain{ForceLimits{}};
    chain.resume();
    EXPECT_EQ(settled(chain, {1.0, 0.0}).force_D, Force{});
    chain.arm();
    chain.fade();
    chain.resume();
    EXPECT_EQ(chain.state(), ForceState::armed);
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
    EXPECT_NEAR(chain.step({1.0, 0.0}, good_pose, tick_s).force_D.x, 0.3, 1e-12);
    EXPECT_EQ(chain.step({1.0, 0.0}, good_pose, tick_s).limit, Limit::slew);
    (void)settled(chain, {1.0, 0.0});
    const Force turning = chain.step({0.0, 1.0}, good_pose, tick_s).force_D;
    EXPECT_NEAR(norm(turning - Force{0.0, 1.0}), 0.0, 1e-12);  // 1.41 N away, 1.5 N allowed
    const Force reversed = chain.step({0.0, -2.0}, good_pose, tick_s).force_D;
    EXPECT_NEAR(reversed.y, -0.5, 1e-12);
}

TEST(ForceChain, SoftStopFromThreeNewtonsTakesTwoMilliseconds) {
    ForceLimits limits;
    limits.torque_Nm = 10.0;
    ForceChain chain = live_chain(limits);
    (void)settled(chain, {3.0, 0.0});
    EXPECT_NEAR(chain.step({}, good_pose, tick_s).force_D.x, 1.5, 1e-12);
    EXPECT_NEAR(chain.step({}, good_pose, tick_s).force_D.x, 0.0, 1e-12);
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
    const SafeForce out = chain.step({1.5, 0.0}, std::nullopt, tick_s);
    EXPECT_EQ(out.force_D, Force{});
    EXPECT_EQ(out.torques, JointTorques{});
    EXPECT_EQ(out.limit, Limit::unreachable);
    EXPECT_NEAR(chain.step({1.5, 0.0}, good_pose, tick_s).force_D.x, 0.3, 1e-12);
}

TEST(ForceChain, NotFiniteIsZeroThisTickAndAFaultUntilStopped) {
    const Jacobian bad_pose{{nan, 0.0}, {0.0, 0.05}};
    for (int kind = 0; kind < 4; ++kind) {
        ForceChain chain = live_chain();
        (void)settled(chain, {1.0, 0.0});
        const SafeForce out = chain.step(kind == 0 ? Force{nan, 0.0} : Force{1.0, 0.0},
                                         kind == 1 ? bad_pose : good_pose,
                                         kind == 2   ? nan
                                         : kind == 3 ? -1.0
                                                     : tick_s);
        EXPECT_EQ(out.force_D, Force{});
        EXPECT_EQ(out.torques, JointTorques{});
        EXPECT_EQ(out.limit, Limit::fault);
        EXPECT_EQ(chain.state(), ForceState::fault);
        EXPECT_EQ(chain.cause(), Fault::not_finite);
        chain.arm();
        chain.resume();
        EXPECT_EQ(settled(chain, {1.0, 0.0}).force_D, Force{});
        chain.stop();
        EXPECT_EQ(chain.state(), ForceState::off);
        EXPECT_EQ(chain.cause(), Fault::none);
    }
}

TEST(ForceChain, FailingKeepsItsFirstCause) {
    ForceChain chain = live_chain();
    chain.fail(Fault::device_lost);
    EXPECT_EQ(chain.step({nan, 0.0}, good_pose, tick_s).force_D, Force{});
    EXPECT_EQ(chain.cause(), Fault::device_lost);
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
