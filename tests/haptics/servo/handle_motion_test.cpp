#include "haptics/servo/handle_motion.h"

#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/tick.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

double counted(double x, double step_m) {
    return std::floor(x / step_m) * step_m;
}

struct Errors {
    double rms_m_per_s = 0.0;
    int stop_ticks = 0;  // after a stop until less than half of the speed is left
};

/// Returns the errors for a steady hand seen through an encoder.
Errors errors_at(double speed_m_per_s, double step_m) {
    VelocityEstimate estimate(step_m);
    double sum = 0.0;
    constexpr int ticks = 4000;
    constexpr int warm_up = 100;
    for (int i = 0; i < ticks; ++i) {
        const double x = speed_m_per_s * tick_s * i;
        const Velocity v = estimate.step({counted(x, step_m), counted(-0.7 * x, step_m)}, tick_s);
        if (i < warm_up) continue;
        sum += std::pow(v.x - speed_m_per_s, 2);
    }
    Errors errors;
    errors.rms_m_per_s = std::sqrt(sum / (ticks - warm_up));
    const double rest = speed_m_per_s * tick_s * (ticks - 1);
    while (errors.stop_ticks < 50) {
        ++errors.stop_ticks;
        const Velocity v =
            estimate.step({counted(rest, step_m), counted(-0.7 * rest, step_m)}, tick_s);
        if (std::abs(v.x) < 0.5 * speed_m_per_s) break;
    }
    return errors;
}

TEST(VelocityEstimate, IsQuietAtSteadySpeedsAndQuickToStop) {
    // facts 1.4, FOAW of 16 at 1 ms: 0.3 / 0.2 / 0.2 mm/s at 10 um, 3.0 / 3.4 / 0.9 at 110 um; here
    // the phase between hand and encoder is another. The estimate sees a stop after 2 and 4 ms.
    const double speeds[] = {0.005, 0.051, 0.213};
    const double fine[] = {0.3e-3, 0.2e-3, 0.2e-3};
    const double coarse[] = {3.0e-3, 3.4e-3, 0.9e-3};
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(errors_at(speeds[i], 10e-6).rms_m_per_s, 1.6 * fine[i]) << speeds[i];
        EXPECT_LE(errors_at(speeds[i], 110e-6).rms_m_per_s, 1.5 * coarse[i]) << speeds[i];
    }
    EXPECT_LE(errors_at(0.1, 10e-6).stop_ticks, 2);
    EXPECT_LE(errors_at(0.1, 110e-6).stop_ticks, 4);
}

TEST(VelocityEstimate, IsExactOnAStraightWayWithUnevenTicks) {
    VelocityEstimate estimate(1e-9);
    double t_s = 0.0;
    Velocity v;
    for (int i = 0; i < 100; ++i) {
        const double dt_s = i % 3 == 0 ? 3e-3 : 1e-3;
        t_s += dt_s;
        v = estimate.step({0.2 * t_s, -0.1 * t_s}, dt_s);
    }
    EXPECT_NEAR(v.x, 0.2, 1e-12);
    EXPECT_NEAR(v.y, -0.1, 1e-12);
}

TEST(VelocityEstimate, NonsenseIsRestAndForgetsWhatWasBefore) {
    VelocityEstimate estimate(1e-5);
    for (int i = 0; i < 20; ++i) (void)estimate.step({1e-4 * i, 0.0}, tick_s);
    EXPECT_GT(estimate.velocity().x, 0.09);
    EXPECT_EQ(estimate.step({std::numeric_limits<double>::quiet_NaN(), 0.0}, tick_s), Velocity{});
    EXPECT_EQ(estimate.step({0.5, 0.0}, tick_s), Velocity{});
    EXPECT_EQ(estimate.step({0.5, 0.0}, 0.0), Velocity{});
}

/// Moves at 0.2 m/s along x in W, and lets the device tell `factor` times that.
Velocity believed(double factor) {
    const DeviceProfile& profile = cartesian_profiles().front();
    HandleMotion motion(profile);
    Velocity last;
    for (int i = 0; i < 100; ++i) {
        StepInput input;
        input.reading.emplace();
        input.reading->p_D = device_from_picture(profile, {0.2e-3 * i - 0.01, 0.0});
        input.reading->velocity_D = turned(Velocity{0.2 * factor, 0.0});
        last = motion.step(profile, input, std::nullopt, tick_s, tick_s).velocity;
    }
    return last;
}

TEST(HandleMotion, ADevicesOwnVelocityIsTakenAsFarAsItsPlacesBearItOut) {
    EXPECT_NEAR(believed(1.0).x, 0.2, 1e-6);
    EXPECT_NEAR(believed(1.2).x, 0.24, 1e-12) << "finer than what the places say";
    EXPECT_NEAR(believed(0.8).x, 0.16, 1e-12);
}

TEST(HandleMotion, AVelocityThatLiesIsNotBelieved) {
    constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
    for (const double factor : {10.0, 2.0, 0.0, -1.0, nan_value})
        EXPECT_NEAR(believed(factor).x, 0.2, 1e-3) << factor;
}

/// A hand at this speed of which every third place comes a tick or two late.
struct LateHand {
    explicit LateHand(double m_per_s) : speed_m_per_s(m_per_s) {}

    HandleReading step(bool is_new) {
        StepInput input;
        input.reading.emplace();
        if (is_new) last_m = speed_m_per_s * tick_s * ticks - 0.05;
        ++ticks;
        input.reading->p_D = device_from_picture(profile, {last_m, 0.0});
        input.reading->freshness.is_new = is_new;
        return motion.step(profile, input, std::nullopt, tick_s, tick_s);
    }

    const DeviceProfile& profile = cartesian_profiles().front();
    HandleMotion motion{profile};
    double speed_m_per_s;
    double last_m = -0.05;
    int ticks = 0;
};

TEST(HandleMotion, APlaceThatWasToldBeforeIsNoStandStillAndNoLeap) {
    for (const double speed : {0.2, 0.9, 1.4}) {
        LateHand hand(speed);
        for (int i = 0; i < 100; ++i) {
            const HandleReading seen = hand.step(i % 7 < 3 || i % 7 == 6);
            EXPECT_TRUE(seen.is_placed);
            EXPECT_FALSE(seen.has_jumped);
            EXPECT_NEAR(seen.p_WH.x, hand.last_m, 1e-12);
            EXPECT_TRUE(i <= 2 || std::abs(seen.velocity.x - speed) < 1e-9) << i;
        }
    }
}

TEST(HandleMotion, APlaceThatWasToldBeforeAndIsTheFirstIsNone) {
    LateHand hand(0.2);
    EXPECT_FALSE(hand.step(false).is_placed);
    EXPECT_TRUE(hand.step(true).is_placed);
}

TEST(HandleMotion, APlaceThatIsNotFiniteIsNone) {
    const DeviceProfile& profile = cartesian_profiles().front();
    for (const bool is_first : {true, false}) {
        HandleMotion motion(profile);
        StepInput input;
        input.reading.emplace();
        input.reading->p_D = profile.centre;
        if (!is_first) (void)motion.step(profile, input, std::nullopt, tick_s, tick_s);
        input.reading->p_D->y = std::numeric_limits<double>::quiet_NaN();
        for (int i = 0; i < 10; ++i) {
            const HandleReading handle = motion.step(profile, input, std::nullopt, tick_s, tick_s);
            EXPECT_FALSE(handle.is_placed);
            EXPECT_EQ(handle.p_WH, Position{});
            EXPECT_EQ(handle.velocity, Velocity{});
        }
        input.reading->p_D = profile.centre;
        EXPECT_TRUE(motion.step(profile, input, std::nullopt, tick_s, tick_s).is_placed);
    }
}

TEST(HandleMotion, APlaceNeedsNoJacobianAndJointsWithoutAPlaceAreNone) {
    const DeviceProfile& profile = cartesian_profiles().front();
    HandleMotion motion(profile);
    StepInput input;
    input.reading.emplace();
    EXPECT_FALSE(motion.step(profile, input, std::nullopt, tick_s, tick_s).is_placed);
    input.reading->p_D = profile.centre;
    const HandleReading handle = motion.step(profile, input, std::nullopt, tick_s, tick_s);
    EXPECT_TRUE(handle.is_placed);
    EXPECT_FALSE(handle.jacobian.has_value());
    EXPECT_EQ(handle.p_WH, Position{});
    EXPECT_EQ(handle.silent_s, 0.0);
}

}  // namespace
}  // namespace touchline
