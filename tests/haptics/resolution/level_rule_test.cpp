#include "haptics/resolution/level_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

LevelLimits fine_device() {
    return {1e-4, 1e-5, 400.0, 0.0, 16.0};
}

/// Moves a hand at constant speed for a while. Returns the last level.
double level_at(LevelRule& rule, double speed_m_per_s, double seconds) {
    constexpr double dt_s = 1e-3;
    static double x_m = 0.0;
    double level = 0.0;
    for (int i = 0; i < static_cast<int>(seconds / dt_s); ++i) {
        x_m += speed_m_per_s * dt_s;
        level = rule.step({x_m, 0.0}, dt_s);
    }
    return level;
}

TEST(EncoderLevel, KeepsWavelengthsThatTheDeviceCanTell) {
    LevelLimits limits = fine_device();
    EXPECT_EQ(encoder_level(limits), 0.0);
    limits.encoder_step_m = 1.5e-4;
    EXPECT_EQ(encoder_level(limits), 1.0);
    limits.encoder_step_m = 8e-4;
    EXPECT_EQ(encoder_level(limits), 3.0);
    EXPECT_GE(wavelength_m(limits, encoder_level(limits)), 4.0 * limits.encoder_step_m);
}

TEST(RadiusLevel, KeepsTheSpacingAtAnEighthOfTheRadius) {
    LevelLimits limits = fine_device();
    EXPECT_EQ(radius_level(limits), 0.0);
    limits.radius_m = 8e-4;
    EXPECT_EQ(radius_level(limits), 0.0);
    limits.radius_m = 8.1e-4;
    EXPECT_EQ(radius_level(limits), 1.0);
    limits.radius_m = 64e-4;
    EXPECT_EQ(radius_level(limits), 3.0);
    limits.radius_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(radius_level(limits), 0.0);
}

RC_GTEST_PROP(RadiusAndEncoderLevel, AreTheFinestWithAnEnoughWideSpacing, ()) {
    LevelLimits limits;
    limits.spacing_m = 1e-7 * *rc::gen::inRange(1, 30000);
    limits.encoder_step_m = 1e-7 * *rc::gen::inRange(0, 10000);
    limits.radius_m = 1e-6 * *rc::gen::inRange(0, 20000);
    const auto spacing_m = [&](double level) { return limits.spacing_m * std::exp2(level); };
    const auto is_finest = [&](double level, double least_m) {
        return spacing_m(level) >= least_m * (1.0 - 1e-8) &&
               (level == 0.0 || spacing_m(level - 1.0) < least_m);
    };
    RC_ASSERT(is_finest(encoder_level(limits), limits.encoder_step_m));
    RC_ASSERT(is_finest(radius_level(limits), limits.radius_m / 8.0));
}

TEST(LevelRule, CoarsensAtOnceAndRefinesLater) {
    LevelRule rule(fine_device());
    EXPECT_EQ(rule.level(), 0.0);
    const double fast = level_at(rule, 0.2, 0.3);
    EXPECT_EQ(fast, std::ceil(speed_level(fine_device(), 0.2, 1e-3)));
    EXPECT_EQ(level_at(rule, 0.0, 0.3), fast);  // the speed of the last half second is held
    EXPECT_EQ(level_at(rule, 0.0, 0.6), 0.0);
}

TEST(LevelRule, HysteresisOfAQuarterOctaveStopsFlicker) {
    LevelRule rule(fine_device());
    const double threshold = 100.0 * 4e-4 * 2.0;  // from level 1 to level 2
    EXPECT_EQ(level_at(rule, 1.02 * threshold, 0.6), 2.0);
    EXPECT_EQ(level_at(rule, 0.9 * threshold, 1.5), 2.0);
    EXPECT_EQ(level_at(rule, 0.8 * threshold, 1.5), 1.0);
}

TEST(LevelRule, RefinesNoSoonerThan150MillisecondsAfterItsLastChange) {
    LevelRule rule(fine_device());
    level_at(rule, 0.2, 0.5);
    double since_change_s = 1.0;
    double before = rule.level();
    for (int i = 0; i < 3000; ++i) {  // slows down within 2 s
        const double level = level_at(rule, 0.2 * std::exp2(-i / 300.0), 0.001);
        since_change_s += 0.001;
        if (level == before) continue;
        EXPECT_LT(level, before);
        EXPECT_GE(since_change_s, 0.15 - 1e-9);
        since_change_s = 0.0;
        before = level;
    }
    EXPECT_EQ(before, 0.0);
}

TEST(LevelRule, StaysWithinTheOperatorSBoundsAndAboveTheEncoder) {
    LevelLimits limits = fine_device();
    limits.finest = 1.0;
    limits.coarsest = 2.0;
    LevelRule rule(limits);
    EXPECT_EQ(rule.level(), 1.0);
    EXPECT_EQ(level_at(rule, 1.0, 0.5), 2.0);
    EXPECT_EQ(level_at(rule, 0.0, 2.0), 1.0);
    limits.coarsest = 0.0;  // the operator's coarsest wins
    rule.set_limits(limits);
    EXPECT_EQ(level_at(rule, 0.5, 0.5), 0.0);
    limits.encoder_step_m = 7e-4;  // but not over the device
    rule.set_limits(limits);
    EXPECT_EQ(rule.level(), 3.0);
}

TEST(LevelRule, LimitsThatAreSetAgainAtEveryTickChangeNothing) {
    LevelRule once(fine_device());
    LevelRule again(fine_device());
    double x_m = 0.0;
    for (int i = 0; i < 8000; ++i) {
        x_m += 1e-3 * 0.3 * std::abs(std::sin(0.002 * i));
        again.set_limits(fine_device());
        ASSERT_EQ(once.step({x_m, 0.0}, 1e-3), again.step({x_m, 0.0}, 1e-3));
    }
}

TEST(LevelRule, AnotherSpacingIsTheLevelOfTheSameSpeedAtOnce) {
    LevelLimits limits = fine_device();
    LevelRule rule(limits);
    const double level = level_at(rule, 0.2, 0.6);
    limits.spacing_m /= 8.0;
    rule.set_limits(limits);
    EXPECT_EQ(rule.level(), level + 3.0);
    limits.spacing_m *= 16.0;
    rule.set_limits(limits);
    EXPECT_EQ(rule.level(), level - 1.0);
    EXPECT_EQ(level_at(rule, 0.2, 0.1), level - 1.0);
}

TEST(LevelRule, AHandleThatIsNoPlaceChangesNothing) {
    LevelRule rule(fine_device());
    const double level = level_at(rule, 0.2, 0.3);
    EXPECT_EQ(rule.step({std::numeric_limits<double>::quiet_NaN(), 0.0}, 1e-3), level);
    EXPECT_EQ(rule.step({0.0, 0.0}, 0.0), level);
}

LevelLimits any_limits() {
    const auto whole = [] { return static_cast<double>(*rc::gen::inRange(0, 12)); };
    LevelLimits limits;
    limits.spacing_m = 1e-6 * *rc::gen::inRange(1, 1000);
    limits.encoder_step_m = 1e-6 * *rc::gen::inRange(0, 1000);
    limits.finest = whole();
    limits.coarsest = whole();
    limits.radius_m = 1e-5 * *rc::gen::inRange(0, 500);
    limits.percept = whole();
    limits.safe = whole();
    limits.cost = whole();
    return limits;
}

/// Holds whatever the hand does and however the limits change.
RC_GTEST_PROP(LevelRule, NeverFinerThanDeviceProxyAndTimeAllowAndNeverCoarserThanSafe, ()) {
    LevelLimits limits = any_limits();
    LevelRule rule(limits);
    const double dt_s = *rc::gen::element(5e-4, 1e-3, 2e-3);
    Position handle;
    for (int phase = 0; phase < 6; ++phase) {
        const double speed = 1e-3 * *rc::gen::inRange(0, 2000);
        const double direction_rad = 0.1 * *rc::gen::inRange(0, 63);
        const Position way{speed * dt_s * std::cos(direction_rad),
                           speed * dt_s * std::sin(direction_rad)};
        for (int i = 0; i < 300; ++i) {
            handle += way;
            const double level = rule.step(handle, dt_s);
            const double allowed =
                std::max({encoder_level(limits), radius_level(limits), limits.cost});
            RC_ASSERT(level <= limits.safe);
            RC_ASSERT(level >= std::min(limits.safe, allowed));
            RC_ASSERT(level <= std::max(limits.coarsest, allowed));
            const double by_speed = std::ceil(speed_level(limits, rule.speed_m_per_s(), dt_s));
            RC_ASSERT(level >=
                      std::min({limits.safe, limits.coarsest, std::max(by_speed, limits.percept)}));
            RC_ASSERT(level == choose_level(rule.terms()).level);
        }
        limits = any_limits();
        rule.set_limits(limits);
    }
}

}  // namespace
}  // namespace touchline
