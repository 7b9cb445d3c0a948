// A wall that moves under a pressing hand, as a detail of a curve does when the hand runs along it:
// what the hand follows, and where it loses contact.

#include "tests/lab/stability/wall_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline::stability {
namespace {

struct Following {
    double contact_share;
    double amplitude_ratio;  // the hand's motion over the wall's
};

/// K = 1000 N/m, 1 kHz, pressed with 1 N in the middle; looks at the last 2 of 3 s.
Following follow(const HandModel& hand, double amplitude_m, double frequency_Hz) {
    constexpr double stiffness = 1000.0;
    constexpr double press_N = 1.0;
    constexpr double rest_m = press_N / stiffness;
    WallLoop loop;
    loop.hand = hand;
    loop.tip.coulomb_N = 0.0;
    loop.substeps = 10;
    const Excitation excitation{rest_m, 0.0, press_N + hand.stiffness_N_per_m * rest_m};
    int k = 0;
    const WallTrace trace = run(
        loop, excitation,
        [&](double x_m) {
            const double angle = 2.0 * std::numbers::pi * frequency_Hz * loop.period_s * k++;
            const double depth_m = x_m + amplitude_m * std::sin(angle);
            return depth_m > 0.0 ? -stiffness * depth_m : 0.0;
        },
        3.0);
    const auto touching = std::count_if(trace.force_N.begin() + 1000, trace.force_N.end(),
                                        [](double force_N) { return force_N < 0.0; });
    return {static_cast<double>(touching) / 2000.0,
            0.5 * peak_to_peak_m(trace, 1.0 / 3.0, 1.0) / amplitude_m};
}

TEST(MovingWall, IsFollowedBelowTheResonanceAndLostWhereDetailIsDeeperThanThePress) {
    struct Row {
        HandModel hand;
        double amplitude_m, frequency_Hz, contact_share, amplitude_ratio;
    };

    const Row rows[] = {
        {normal_hand, 1e-4, 5, 1.0, 0.87},   {normal_hand, 1e-4, 30, 1.0, 0.25},
        {normal_hand, 1e-4, 50, 1.0, 0.07},  {normal_hand, 1e-3, 10, 1.0, 1.38},
        {normal_hand, 1e-3, 20, 0.68, 0.64}, {normal_hand, 1e-3, 30, 0.79, 0.23},
        {normal_hand, 1e-3, 50, 0.85, 0.07}, {normal_hand, 3e-3, 30, 0.53, 0.12},
        {normal_hand, 3e-3, 50, 0.55, 0.04}, {relaxed_arm, 1e-3, 20, 0.84, 0.12},
        {relaxed_arm, 3e-3, 30, 0.53, 0.03}, {light_hand, 1e-4, 20, 1.0, 4.34},
    };
    for (const Row& row : rows) {
        const Following found = follow(row.hand, row.amplitude_m, row.frequency_Hz);
        EXPECT_NEAR(found.contact_share, row.contact_share, 0.03)
            << row.amplitude_m << " " << row.frequency_Hz;
        EXPECT_NEAR(found.amplitude_ratio, row.amplitude_ratio, 0.03 * row.amplitude_ratio + 0.01)
            << row.amplitude_m << " " << row.frequency_Hz;
    }
}

}  // namespace
}  // namespace touchline::stability
