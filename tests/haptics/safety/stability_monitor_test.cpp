#include "haptics/safety/stability_monitor.h"

#include "tests/haptics/safety/chains.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A hand presses a wall of 500 N/m by 0.2 N and swings in by `amplitude_N`. The force is late by
/// one tick, so the loop gives energy.
void ring(StabilityMonitor& monitor, double amplitude_N, double frequency_Hz, int ticks) {
    constexpr double stiffness_N_per_m = 500.0;
    double before_N = 0.2;
    for (int i = 0; i < ticks; ++i) {
        const double phase = 2.0 * std::numbers::pi * frequency_Hz * tick_s * i;
        const double force_N = 0.2 + amplitude_N * std::sin(phase);
        const double stored_J = 0.5 * force_N * force_N / stiffness_N_per_m;
        const double moved_m = (before_N - force_N) / stiffness_N_per_m;
        monitor.step({{0.0, force_N}, {0.0, moved_m}, stored_J}, tick_s);
        before_N = force_N;
    }
}

/// The force changes as much while the hand slides along, so it gives no energy.
void scan(StabilityMonitor& monitor, double amplitude_N, double frequency_Hz, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        const double phase = 2.0 * std::numbers::pi * frequency_Hz * tick_s * i;
        monitor.step({{0.0, 0.5 + amplitude_N * std::sin(phase)}, {1e-4, 0.0}, 0.0}, tick_s);
    }
}

StabilityMonitor rung(double amplitude_N, double frequency_Hz, int ticks) {
    StabilityMonitor monitor;
    ring(monitor, amplitude_N, frequency_Hz, ticks);
    return monitor;
}

TEST(StabilityMonitor, CutsWhereTheForceRings) {
    for (const double frequency_Hz : {30.0, 80.0, 150.0}) {
        const StabilityMonitor monitor = rung(0.5, frequency_Hz, 300);
        EXPECT_EQ(monitor.cause(), Ringing::ripple) << frequency_Hz;
        EXPECT_LE(monitor.gain(), 0.51) << frequency_Hz;
    }
    EXPECT_NEAR(rung(0.5, 80.0, 10000).gain(), 0.125, 0.02);  // and no further
}

TEST(StabilityMonitor, LeavesAloneWhatAHandFeelsOnPurpose) {
    EXPECT_EQ(rung(0.1, 80.0, 5000).cuts(), 0U);  // too little to matter
    EXPECT_EQ(rung(1.0, 4.0, 5000).cuts(), 0U);   // pressing and letting go
    StabilityMonitor monitor;
    scan(monitor, 0.4, 50.0, 5000);
    EXPECT_EQ(monitor.cuts(), 0U);  // texture
    for (int i = 0; i < 20; ++i) {  // contact made and lost
        const double force_N = i % 2 == 0 ? 1.0 : 0.0;
        for (int k = 0; k < 60; ++k) monitor.step({{0.0, force_N}, {}, 0.0}, tick_s);
    }
    EXPECT_EQ(monitor.cuts(), 0U);
}

/// A swing slower than 20 Hz is a hand's, and so are two or three swings.
TEST(StabilityMonitor, TakesNoSlowOrShortSwingForRinging) {
    EXPECT_EQ(rung(0.25, 18.0, 5000).cuts(), 0U);
    EXPECT_EQ(rung(0.5, 10.0, 5000).cuts(), 0U);
    EXPECT_EQ(rung(0.8, 12.0, 5000).cuts(), 0U);
    EXPECT_EQ(rung(0.5, 80.0, 20).cuts(), 0U);
}

/// A torque that gives 0.1 W while the force rests counts as ringing; one that takes as much does
/// not.
TEST(StabilityMonitor, CountsTheWorkOfATorque) {
    for (const double turning_J : {1e-4, -1e-4}) {
        StabilityMonitor monitor;
        for (int i = 0; i < 300; ++i) monitor.step({{0.0, 0.5}, {}, 0.0, true, turning_J}, tick_s);
        EXPECT_EQ(monitor.cause(), turning_J > 0.0 ? Ringing::energy : Ringing::none);
    }
}

TEST(StabilityMonitor, CutsTenTimesASecondAtMostAndEachOverTwentyMilliseconds) {
    StabilityMonitor monitor;
    int ticks = 0;
    for (; monitor.cuts() == 0 && ticks < 1000; ++ticks) {
        const double before_N = 0.2 + 0.5 * std::sin(2.0 * std::numbers::pi * 0.08 * (ticks - 1));
        const double force_N = 0.2 + 0.5 * std::sin(2.0 * std::numbers::pi * 0.08 * ticks);
        monitor.step({{0.0, force_N}, {0.0, (before_N - force_N) / 500.0}, force_N * force_N / 1e3},
                     tick_s);
    }
    ASSERT_EQ(monitor.cuts(), 1U);
    double before = monitor.gain();
    EXPECT_NEAR(before, 1.0 - 0.5 / 20.0, 1e-9);
    for (int i = 0; i < 10; ++i) {
        const double gain = monitor.step({{0.0, 0.2}, {}, 0.0}, tick_s);
        EXPECT_NEAR(before - gain, 0.5 / 20.0, 1e-9);
        before = gain;
    }
    EXPECT_EQ(rung(0.5, 80.0, 120).cuts(), 1U);
    EXPECT_LE(rung(0.5, 80.0, 1000).cuts(), 10U);
    EXPECT_GE(rung(0.5, 80.0, 1000).cuts(), 5U);
}

TEST(StabilityMonitor, CutsWhereTheLoopGivesEnergy) {
    // 1 N along with a hand at 0.2 m/s, and no spring that it came from: 0.2 W.
    StabilityMonitor monitor;
    int ticks = 0;
    while (monitor.cuts() == 0 && ticks < 2000) {
        monitor.step({{1.0, 0.0}, {2e-4, 0.0}, 0.0}, tick_s);
        ++ticks;
    }
    EXPECT_EQ(monitor.cause(), Ringing::energy);
    EXPECT_GT(ticks, 40);
    EXPECT_LT(ticks, 80);
}

TEST(StabilityMonitor, TakesNoSpringThatGivesBackForALeak) {
    StabilityMonitor monitor;
    constexpr double stiffness_N_per_m = 500.0;
    double before_m = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double depth_m = 0.003 * (1.0 - std::cos(2.0 * std::numbers::pi * 3.0 * tick_s * i));
        const double stored_J = 0.5 * stiffness_N_per_m * depth_m * depth_m;
        const Force force{0.0, stiffness_N_per_m * depth_m};
        monitor.step({force, {0.0, before_m - depth_m}, stored_J}, tick_s);
        before_m = depth_m;
    }
    EXPECT_EQ(monitor.cuts(), 0U);
    EXPECT_EQ(monitor.gain(), 1.0);
}

TEST(StabilityMonitor, RestoresByFivePerCentOfTheWholeASecond) {
    StabilityMonitor monitor = rung(0.5, 80.0, 170);
    for (int i = 0; i < 300; ++i) monitor.step({{0.0, 0.2}, {}, 0.0}, tick_s);
    const double cut = monitor.gain();
    for (int i = 0; i < 2000; ++i) monitor.step({{0.0, 0.2}, {}, 0.0}, tick_s);
    EXPECT_NEAR(monitor.gain(), cut + 0.1, 0.005);
    for (int i = 0; i < 20000; ++i) monitor.step({{0.0, 0.2}, {}, 0.0}, tick_s);
    EXPECT_EQ(monitor.gain(), 1.0);
}

TEST(StabilityMonitor, NonsenseBeginsAnewAndKeepsTheGain) {
    StabilityMonitor monitor = rung(0.5, 80.0, 170);
    const double cut = monitor.gain();
    EXPECT_EQ(monitor.step({{nan, 0.0}, {}, 0.0}, tick_s), cut);
    EXPECT_EQ(monitor.step({{0.0, 0.0}, {nan, 0.0}, 0.0}, tick_s), cut);
    EXPECT_EQ(monitor.step({{0.0, 0.0}, {}, nan}, tick_s), cut);
    for (const double bad_s : {nan, 0.0, -1e-3, std::numeric_limits<double>::infinity()})
        EXPECT_EQ(monitor.step({{0.0, 0.0}, {}, 0.0}, bad_s), cut);
}

/// Earlier energy, spring and swings count for nothing.
TEST(StabilityMonitor, AfterNonsenseNothingIsCompared) {
    const StabilityMonitor::Tick nonsense{{nan, 0.0}, {}, 0.0};
    StabilityMonitor spring;
    spring.step({{1.0, 0.0}, {}, 0.0}, tick_s);
    spring.step(nonsense, tick_s);
    spring.step({{1.0, 0.0}, {}, 0.1}, tick_s);
    EXPECT_EQ(spring.cuts(), 0U);
    spring.step({{1.0, 0.0}, {}, 0.2}, 0.0);  // in no time
    EXPECT_EQ(spring.cuts(), 0U);
    StabilityMonitor given;
    for (int i = 0; i < 80; ++i) {
        if (i % 40 == 0) given.step(nonsense, tick_s);
        given.step({{1.0, 0.0}, {2e-4, 0.0}, 0.0}, tick_s);  // 8 mJ each time
    }
    EXPECT_EQ(given.cuts(), 0U);
    StabilityMonitor swung;
    for (int i = 0; i < 10; ++i) {
        ring(swung, 0.5, 80.0, 20);
        swung.step(nonsense, tick_s);
    }
    EXPECT_EQ(swung.cuts(), 0U);
}

/// Energy of a second ago and swings a third of a second apart make no ringing together.
TEST(StabilityMonitor, ForgetsWhatWasBefore) {
    StabilityMonitor kicked;
    for (int i = 0; i < 25; ++i) kicked.step({{0.0, 1.0}, {0.0, 2e-4}, 0.0}, tick_s);  // 5 mJ
    for (int i = 0; i < 1500; ++i) kicked.step({{0.0, 0.5}, {1e-4, 0.0}, 0.0}, tick_s);
    scan(kicked, 0.4, 50.0, 1000);
    EXPECT_EQ(kicked.cuts(), 0U);
    StabilityMonitor tapped;
    for (int i = 0; i < 20; ++i) {
        ring(tapped, 0.5, 80.0, 13);
        for (int k = 0; k < 300; ++k) tapped.step({{0.0, 0.2}, {}, 4e-5}, tick_s);
    }
    EXPECT_EQ(tapped.cuts(), 0U);
}

/// A tick that does not continue the last one counts like nonsense: contact was dropped.
TEST(StabilityMonitor, ADroppedContactIsNoEnergy) {
    StabilityMonitor monitor;
    for (int i = 0; i < 10; ++i) {
        monitor.step({{1.0, 0.0}, {}, i % 2 == 0 ? 0.0 : 0.1, false}, tick_s);
        monitor.step({{1.0, 0.0}, {}, i % 2 == 0 ? 0.1 : 0.0}, tick_s);
    }
    EXPECT_EQ(monitor.cuts(), 0U);
}

/// A wall that the hand already presses when the monitor begins was not charged in that tick.
TEST(StabilityMonitor, TheFirstTickIsComparedWithNothing) {
    StabilityMonitor monitor;
    monitor.step({{0.0, 1.0}, {}, 0.05}, tick_s);
    EXPECT_EQ(monitor.cuts(), 0U);
    monitor.step({{0.0, 1.0}, {}, 0.1}, tick_s);
    EXPECT_EQ(monitor.cause(), Ringing::energy);
}

}  // namespace
}  // namespace touchline
