// The limits of a motor at the handle, each on its own.
#include "haptics/safety/guards.h"
#include "tests/haptics/safety/chains.h"

#include <cmath>

namespace touchline {
namespace {

constexpr double most_Nm = 0.09;

/// The default limits for a motor of 0.09 Nm.
HandleLimit motor() {
    HandleLimits limits;
    limits.torque_Nm = most_Nm;
    return HandleLimit(limits);
}

/// Returns the torque after so many ticks of a wanted torque at that turn.
double told_Nm(HandleLimit& motor, double wanted_Nm, double turn_rad_per_s, int ticks) {
    for (int i = 0; i < ticks; ++i) (void)motor.step(wanted_Nm, turn_rad_per_s, 1.0, 1.0, tick_s);
    return motor.told_Nm();
}

TEST(HandleLimit, BeginsAtZeroAndRisesBy3NmPerSecond) {
    HandleLimit handle = motor();
    EXPECT_EQ(handle.told_Nm(), 0.0);
    EXPECT_NEAR(told_Nm(handle, 1.0, 0.0, 10), 0.03, 1e-12);
    EXPECT_NEAR(told_Nm(handle, 1.0, 0.0, 100), most_Nm, 1e-12);
}

TEST(HandleLimit, OnlyBrakesFromTwoTurnsASecondOn) {
    HandleLimit handle = motor();
    EXPECT_NEAR(told_Nm(handle, 0.05, 12.0, 100), 0.05, 1e-12);
    EXPECT_EQ(told_Nm(handle, 0.05, 12.1, 1), 0.0);
    EXPECT_NEAR(told_Nm(handle, 0.05, -12.1, 100), 0.05, 1e-12);
}

TEST(HandleLimit, IsQuietBelowAMillinewtonmetre) {
    const HandleLimit handle = motor();
    EXPECT_TRUE(handle.is_quiet(-0.9e-3));
    EXPECT_FALSE(handle.is_quiet(1e-3));
    EXPECT_TRUE(HandleLimit(HandleLimits{}).is_quiet(1.0));  // always, without a motor
}

TEST(HandleLimit, StopsAtOnceAndRisesFromZeroAgain) {
    HandleLimit handle = motor();
    (void)told_Nm(handle, 0.05, 0.0, 100);
    handle.stop();
    EXPECT_EQ(handle.told_Nm(), 0.0);
    EXPECT_NEAR(told_Nm(handle, 0.05, 0.0, 1), 0.003, 1e-12);
}

/// The motor bears 0.06 Nm for ever; at 0.09 Nm the rise is rated after -60 s ln(1 - 1 / 1.5^2),
/// and reaches 70 and 90 % of that after 22.7 and 30.6 s.
TEST(HandleLimit, WarmsWithItsTorqueOverAMinute) {
    HandleLimit resting = motor();
    EXPECT_NEAR(told_Nm(resting, 0.0, 0.0, 60'000), 0.0, 1e-12);
    EXPECT_NEAR(told_Nm(resting, most_Nm, 0.0, 22'000), most_Nm, 1e-12);
    EXPECT_LT(told_Nm(resting, most_Nm, 0.0, 2'000), most_Nm - 1e-3);
    EXPECT_GT(resting.told_Nm(), 0.05);
    HandleLimit bearing = motor();
    EXPECT_NEAR(told_Nm(bearing, 0.049, 0.0, 120'000), 0.049, 1e-12);
}

/// The limits come from the device: what its motor bears, and for how long.
TEST(HandleLimit, IsThatOfTheDevice) {
    DeviceProfile profile = find_profile("gen3.1-turning").value();
    profile.mechanics.continuous_torque = 0.25;
    profile.mechanics.warming_s = 7.0;
    const HandleLimits limits = limits_of(profile).handle;
    EXPECT_DOUBLE_EQ(limits.torque_Nm, 0.9 * profile.handle->torque_limit_Nm);
    EXPECT_DOUBLE_EQ(limits.continuous_torque_Nm, 0.25 * profile.handle->torque_limit_Nm);
    EXPECT_EQ(limits.warming_s, 7.0);
}

}  // namespace
}  // namespace touchline
