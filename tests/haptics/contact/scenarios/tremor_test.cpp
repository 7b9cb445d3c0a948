// S14: a hand that rests 1 mm deep on a line and trembles, from the healthiest to Parkinson's.
#include "tests/haptics/contact/scenarios/runner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline::scenarios {
namespace {

struct Tremor {
    double frequency_Hz, amplitude_mm;
    double force_N;  // the reference's largest
};

/// Trembles with 0.83 of the frequency along the line. Starts 2 mm off it and comes down in a
/// second.
Trajectory trembling(const Tremor& tremor) {
    return [tremor](double t) -> Intention {
        const double omega = 2.0 * std::numbers::pi * tremor.frequency_Hz;
        const double a = tremor.amplitude_mm * mm;
        const double lifted_m = t < 0.2 ? 2 * mm : 0.0;
        return {{a * std::sin(0.83 * omega * t),
                 lifted_m - 1 * mm * std::min(t, 1.0) + a * std::sin(omega * t)},
                {0.83 * a * omega * std::cos(0.83 * omega * t), a * omega * std::cos(omega * t)}};
    };
}

class ScenarioS14 : public testing::TestWithParam<Tremor> {};

TEST_P(ScenarioS14, ATremblingHandIsNeverLetThrough) {
    const ScenarioRun felt = run(scene_of({flat_line()}), trembling(GetParam()), 10.0);
    EXPECT_TRUE(is_within(largest_force_N(felt), GetParam().force_N, 0.03));
    EXPECT_EQ(
        std::count_if(felt.proxy.begin(), felt.proxy.end(), [](Position p) { return p.y < 0.0; }),
        0);
    EXPECT_EQ(felt.watch.side_flips, 0);
    expect_sound(felt.watch);
    RecordProperty("force_N", fmt::format("{:.4f}", largest_force_N(felt)));
    RecordProperty("jump_N", fmt::format("{:.4f}", largest_jump(felt).size_N));
}

TEST_P(ScenarioS14, WithMotorsThatSaturateNeither) {
    for (const double motors_N : {5.0, 3.0}) {
        CommonSetUp set_up;
        set_up.motors_N = motors_N;
        const ScenarioRun felt = run(scene_of({flat_line()}), trembling(GetParam()), 10.0, set_up);
        // The force exceeds the motors exactly when the reference does.
        EXPECT_EQ(largest_force_N(felt) > motors_N, GetParam().force_N > motors_N);
        EXPECT_EQ(std::count_if(felt.proxy.begin(), felt.proxy.end(),
                                [](Position p) { return p.y < 0.0; }),
                  0);
        EXPECT_EQ(felt.watch.side_flips, 0);
        expect_sound(felt.watch);
    }
}

INSTANTIATE_TEST_SUITE_P(Tremors, ScenarioS14,
                         testing::Values(Tremor{8, 0.05, 0.62}, Tremor{7, 0.18, 0.68},
                                         Tremor{5, 5, 3.55}, Tremor{5, 10, 7.27}));

}  // namespace
}  // namespace touchline::scenarios
