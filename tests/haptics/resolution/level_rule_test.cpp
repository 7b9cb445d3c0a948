#include "haptics/resolution/level_rule.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

LevelLimits fine_device() {
    return {1e-4, 1e-5, 400.0, 0.0, 16.0};
}

/// Moves a hand at constant speed for a while; the level at the end.
double level_at(LevelRule& rule, double speed_m_per_s, double seconds, double dt_s = 1e-3) {
    static double x_m = 0.0;
    double level = 0.0;
    for (int i = 0; i < static_cast<int>(seconds / dt_s); ++i) {
        x_m += speed_m_per_s * dt_s;
        level = rule.step({x_m, 0.0}, dt_s);
    }
    return level;
}

TEST(LevelRule, ShortestWavelengthAtASpeedIsTheTables) {
    // lambda_min(v): 20 mm/s 0.4 mm, 100 mm/s 2 mm, 250 mm/s 5 mm at 500 Hz; half of it from 1 kHz.
    const LevelLimits limits = fine_device();
    for (const auto& [dt_s, speed, wavelength] : {std::tuple{2e-3, 0.02, 4e-4},
                                                  {2e-3, 0.1, 2e-3},
                                                  {2e-3, 0.25, 5e-3},
                                                  {1e-3, 0.02, 2e-4},
                                                  {1e-3, 0.1, 1e-3},
                                                  {1e-3, 0.25, 2.5e-3},
                                                  {2.5e-4, 0.1, 1e-3}}) {
        EXPECT_NEAR(wavelength_m(limits, speed_level(limits, speed, dt_s)), wavelength, 1e-9);
    }
}

TEST(LevelRule, EncoderTermKeepsWavelengthsThatTheDeviceCanTell) {
    LevelLimits limits = fine_device();
    EXPECT_EQ(encoder_level(limits), 0.0);
    limits.encoder_step_m = 1.5e-4;
    EXPECT_EQ(encoder_level(limits), 1.0);
    limits.encoder_step_m = 8e-4;
    EXPECT_EQ(encoder_level(limits), 3.0);
    EXPECT_GE(wavelength_m(limits, encoder_level(limits)), 4.0 * limits.encoder_step_m);
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

TEST(LevelRule, TremorDoesNotSwitchLevels) {
    // 60 mm/s modulated by half at 0.4 Hz, and 10 mm of tremor at 5 Hz: few changes in 20 s.
    LevelLimits limits = fine_device();
    limits.spacing_m = 1.25e-4;
    LevelRule rule(limits);
    int changes = 0;
    double before = -1.0;
    for (int i = 0; i < 20000; ++i) {
        const double t = i * 1e-3;
        const double s =
            0.06 * t + 0.03 / (0.8 * std::numbers::pi) * std::sin(0.8 * std::numbers::pi * t);
        const Position handle{s + 0.01 * std::sin(10.0 * std::numbers::pi * t),
                              0.007 * std::sin(10.0 * std::numbers::pi * t + 1.0)};
        const double level = rule.step(handle, 1e-3);
        changes += i > 600 && level != before ? 1 : 0;
        before = level;
    }
    EXPECT_LE(changes, 3);
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
}

TEST(LevelRule, AHandleThatIsNoPlaceChangesNothing) {
    LevelRule rule(fine_device());
    const double level = level_at(rule, 0.2, 0.3);
    EXPECT_EQ(rule.step({std::numeric_limits<double>::quiet_NaN(), 0.0}, 1e-3), level);
    EXPECT_EQ(rule.step({0.0, 0.0}, 0.0), level);
}

}  // namespace
}  // namespace touchline
