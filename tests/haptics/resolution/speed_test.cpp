// The level against the speed of the hand: the formula, the sweep, tremor.
#include "haptics/resolution/level_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

namespace touchline {
namespace {

LevelLimits finest_device() {
    return {2.5e-5, 1e-6, 400.0, 0.0, 16.0};
}

/// Returns the shortest wavelength rendered for a hand that has moved at this speed for 0.8 s.
double wavelength_at(LevelRule& rule, double& x_m, double speed_m_per_s, double dt_s) {
    double level = 0.0;
    for (int i = 0; i < static_cast<int>(0.8 / dt_s); ++i) {
        x_m += speed_m_per_s * dt_s;
        level = rule.step({x_m, 0.0}, dt_s);
    }
    return wavelength_m(finest_device(), level);
}

TEST(LevelBySpeed, ShortestWavelengthAtASpeedIsTheTables) {
    // lambda_min(v): 20 mm/s 0.4 mm, 100 mm/s 2 mm, 250 mm/s 5 mm at 500 Hz; half of that from 1
    // kHz.
    const LevelLimits limits = finest_device();
    for (const auto& [dt_s, speed, wavelength] : {std::tuple{2e-3, 0.02, 4e-4},
                                                  {2e-3, 0.1, 2e-3},
                                                  {2e-3, 0.25, 5e-3},
                                                  {1e-3, 0.02, 2e-4},
                                                  {1e-3, 0.1, 1e-3},
                                                  {1e-3, 0.25, 2.5e-3},
                                                  {2.5e-4, 0.1, 1e-3}}) {
        EXPECT_NEAR(wavelength_m(limits, speed_level(limits, speed, dt_s)), wavelength, 1e-9);
        LevelRule rule(limits);
        double x_m = 0.0;
        const double rendered = wavelength_at(rule, x_m, speed, dt_s);
        EXPECT_GE(rendered, wavelength * (1.0 - 1e-9)) << speed;
        EXPECT_LE(rendered, wavelength * 2.0) << speed;
    }
}

/// From 1 to 320 mm/s in steps of an eighth of an octave. Levels are whole, so the wavelength
/// rendered is the next above the formula's; a hand that slows down keeps a quarter of an octave
/// more.
TEST(LevelBySpeed,
     ShortestWavelengthStaysWithinAnOctaveOfTheFormulaFrom1To320MillimetresPerSecond) {
    for (const double dt_s : {2e-3, 1e-3}) {
        const double f_Hz = dt_s == 2e-3 ? 50.0 : 100.0;
        LevelRule rule(finest_device());
        double x_m = 0.0;
        double worst = 0.0;
        const auto excess_octaves = [&](double speed) {
            const double formula = std::max(speed / f_Hz, wavelength_m(finest_device(), 0.0));
            return std::log2(wavelength_at(rule, x_m, speed, dt_s) / formula);
        };
        const int last = static_cast<int>(8.0 * std::log2(320.0));
        for (int k = 0; k <= last; ++k) {
            const double octaves = excess_octaves(1e-3 * std::exp2(k / 8.0));
            EXPECT_GE(octaves, -1e-6) << k;
            EXPECT_LE(octaves, 1.0) << k;
            worst = std::max(worst, octaves);
        }
        EXPECT_GT(worst, 0.5);
        for (int k = last; k >= 0; --k) {
            const double octaves = excess_octaves(1e-3 * std::exp2(k / 8.0));
            EXPECT_GE(octaves, -1e-6) << k;
            EXPECT_LE(octaves, 1.25 + 1e-6) << k;
        }
    }
}

struct Tremor {
    const char* name;
    double f_Hz;
    double amplitude_m;
    int most_changes;
    int fewest_changes;
};

void PrintTo(const Tremor& tremor, std::ostream* out) {
    *out << tremor.name;
}

class Tremors : public testing::TestWithParam<Tremor> {};

/// A hand scans at 60 mm/s, modulated by half at 0.4 Hz, with a tremor across; lambda_0 = 0.5 mm
/// and f_max = 50 Hz. The test counts the changes from 0.6 s to 20 s, the first from level 0. The
/// scan alone crosses a level twice in each of its 8 periods; a violent tremor hides that, but none
/// may add to it.
TEST_P(Tremors, DoNotSwitchLevels) {
    const Tremor& tremor = GetParam();
    LevelLimits limits{1.25e-4, 1e-6, 50.0, 0.0, 16.0};
    LevelRule rule(limits);
    constexpr double two_pi = 2.0 * std::numbers::pi;
    int changes = 0;
    double before = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double t = i * 1e-3;
        const double scan = 0.06 * t + 0.03 / (two_pi * 0.4) * std::sin(two_pi * 0.4 * t);
        const double phase = two_pi * tremor.f_Hz * t;
        const Position handle{scan + tremor.amplitude_m * std::sin(phase),
                              0.7 * tremor.amplitude_m * std::sin(phase + 1.0)};
        const double level = rule.step(handle, 1e-3);
        if (i < 600) continue;
        changes += level != before ? 1 : 0;
        before = level;
    }
    RecordProperty("changes", changes);
    EXPECT_LE(changes, tremor.most_changes);
    EXPECT_GE(changes, tremor.fewest_changes);
}

INSTANTIATE_TEST_SUITE_P(LevelBySpeed, Tremors,
                         testing::Values(Tremor{"none", 8.0, 0.0, 19, 15},
                                         Tremor{"8 Hz 0.05 mm", 8.0, 0.05e-3, 19, 15},
                                         Tremor{"7 Hz 0.18 mm", 7.0, 0.18e-3, 19, 15},
                                         Tremor{"5 Hz 2 mm", 5.0, 2e-3, 3, 0},
                                         Tremor{"5 Hz 10 mm", 5.0, 10e-3, 3, 0}));

TEST(LevelOfAShape, IsThatOfAPointAsFastAsItsFastestPoint) {
    constexpr double r_m = 0.02;
    for (const double speed : {0.013, 0.07, 0.31}) {
        LevelRule point(finest_device());
        ShapeLevelRule slides(finest_device(), r_m);
        ShapeLevelRule turns(finest_device(), r_m);
        for (int i = 1; i <= 800; ++i) {
            const double way_m = speed * 1e-3 * i;
            const double expected = point.step({way_m, 0.0}, 1e-3);
            EXPECT_EQ(slides.step({way_m, 0.0}, 0.3, 1e-3), expected);
            EXPECT_EQ(turns.step({0.01, 0.0}, -way_m / r_m, 1e-3), expected);
        }
        EXPECT_NEAR(turns.speed_m_per_s(), speed, 1e-6);
    }
    ShapeLevelRule both(finest_device(), r_m);
    for (int i = 1; i <= 800; ++i) (void)both.step({1e-4 * i, 0.0}, 5e-3 * i, 1e-3);
    EXPECT_NEAR(both.speed_m_per_s(), 0.2, 1e-6);
    const double level = both.step({0.08, 0.0}, 4.0, 1e-3);
    EXPECT_EQ(both.step({NAN, 0.0}, 0.0, 1e-3), level);
    EXPECT_EQ(both.step({0.0, 0.0}, NAN, 1e-3), level);
}

}  // namespace
}  // namespace touchline
