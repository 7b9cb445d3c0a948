// What loops do in time, against the reference: growth and decay, limit cycles, hard impacts.
#include "tests/lab/stability/wall_run.h"

#include "tests/lab/stability/limits.h"
#include "tests/lab/stability/linear_loop.h"
#include "tests/lab/stability/wall_controllers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline::stability {
namespace {

bool decays(const WallTrace& trace) {
    const double middle_m = peak_to_peak_m(trace, 0.4, 0.5);
    const double end_m = peak_to_peak_m(trace, 0.9, 1.0);
    return end_m < middle_m * (1.0 - 1e-6) || end_m < 1e-9;
}

TEST(WallInTime, GrowsAndDecaysWhereTheEigenvaluesSay) {
    struct Row {
        double mass_kg, b_Ns_per_m, period_s, delay, limit_N_per_m;
    };

    const Row rows[] = {
        {0.05, 0.5, 1e-3, 0.0, 1000}, {0.05, 0.5, 1e-3, 0.5, 500}, {0.05, 0.5, 1e-3, 1.0, 333.3},
        {0.05, 0.5, 1e-3, 2.0, 200},  {0.2, 5.0, 2e-3, 0.0, 5075}, {0.2, 5.0, 2e-3, 1.0, 1700},
    };
    for (const Row& row : rows) {
        WallLoop loop{row.period_s, row.delay * row.period_s, {row.mass_kg, row.b_Ns_per_m, 0.0}};
        loop.substeps = 40;
        const double span_s = std::max(60.0 * row.mass_kg / row.b_Ns_per_m, 1500.0 * row.period_s);
        const StiffnessGrid grid{0.5 * row.limit_N_per_m, 1.01, 120};
        const double unilateral = bisected_stiffness(grid, [&](double stiffness) {
            return decays(render(method("spring"), stiffness, loop, {0.0, 0.02, 1.0}, span_s));
        });
        EXPECT_NEAR(unilateral, row.limit_N_per_m, 0.025 * row.limit_N_per_m);
        const double bilateral = bisected_stiffness(grid, [&](double stiffness) {
            const auto law = [stiffness](double x_m) { return -stiffness * x_m; };
            return decays(run(loop, {0.0, 0.02, 1.0}, law, span_s));
        });
        const double exact =
            LinearLoop(loop.tip, no_hand, {loop.period_s, loop.delay_s}).largest_stiffness();
        EXPECT_NEAR(bilateral, exact, 0.025 * exact);
    }
}

TEST(WallInTime, FrictionCalmsAPlainLoopAsInTheTable) {
    constexpr double period_s = 1e-3;
    constexpr double stiffness = 1000.0;
    constexpr double step_m = 20e-6;
    constexpr double friction[] = {0.0, 0.1, 0.25, 0.4, 0.6, 1.0, 2.0};  // of K Delta

    struct Row {
        double damping;      // of K T
        double residual[7];  // peak to peak, encoder steps; after an impact at 0.1 m/s
    };

    const Row rows[] = {
        {0.10, {2900, 2800, 2700, 2500, 2300, 1900, 960}},
        {0.30, {360, 340, 320, 290, 260, 180, 0}},
        {0.45, {150, 130, 110, 0, 0, 0, 0}},
        {0.55, {20, 0, 0, 0, 0, 0, 0}},
        {0.80, {1.2, 0, 0, 0, 0, 0, 0}},
        {1.50, {0, 0, 0, 0, 0, 0, 0}},
    };
    for (const Row& row : rows) {
        for (int i = 0; i < 7; ++i) {
            WallLoop loop;
            loop.period_s = period_s;
            loop.tip = {0.05, row.damping * stiffness * period_s, friction[i] * stiffness * step_m};
            loop.encoder_step_m = step_m;
            loop.substeps = 20;
            const WallTrace trace = render(method("spring"), stiffness, loop, {}, 4.0);
            const double residual = peak_to_peak_m(trace, 0.9, 1.0) / step_m;
            EXPECT_NEAR(residual, row.residual[i], std::max(0.06 * row.residual[i], 0.06))
                << row.damping << " " << friction[i];
        }
    }
}

TEST(WallInTime, ImpactsAboveTheCalmedSpeedGrow) {
    struct Row {
        double stiffness, period_s, delay_s, b_Ns_per_m, coulomb_N, mass_kg;
    };

    const Row rows[] = {
        {1000, 1e-3, 0, 0.1, 0.05, 0.05},  {1000, 1e-3, 1e-3, 0.1, 0.05, 0.05},
        {1000, 2e-3, 0, 0.1, 0.1, 0.05},   {2000, 1e-3, 0, 0.5, 0.05, 0.05},
        {500, 2e-3, 2e-3, 0.1, 0.1, 0.05}, {1000, 1e-3, 0, 0.1, 0.05, 0.15},
    };
    constexpr double push_N = 20.0;
    for (const Row& row : rows) {
        WallLoop loop{row.period_s, row.delay_s, {row.mass_kg, row.b_Ns_per_m, row.coulomb_N}};
        loop.substeps = 40;
        const double rest_m = push_N / row.stiffness;
        // Always in contact, so the spring also pulls.
        const auto law = [&](double x_m) { return -row.stiffness * x_m; };
        const auto stays_calm = [&](double speed) {
            const WallTrace trace = run(loop, {rest_m, speed, push_N, 1e9, 0.0, -push_N}, law, 1.0);
            double early_m = 0.0;
            double late_m = 0.0;
            const std::size_t count = trace.x_m.size();
            for (std::size_t k = 0; k < count; ++k) {
                const double away_m = std::abs(trace.x_m[k] - rest_m);
                if (k < count / 20) early_m = std::max(early_m, away_m);
                if (k >= count - count / 5) late_m = std::max(late_m, away_m);
            }
            return late_m <= early_m;
        };
        const double theory = calmed_speed_m_per_s(row.stiffness, row.b_Ns_per_m, row.coulomb_N,
                                                   row.period_s, row.delay_s);
        const double found = bisected_stiffness({0.3 * theory, 1.01, 232}, stays_calm);
        EXPECT_NEAR(found, theory, 0.08 * theory);
    }
}

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
