// A simulated hand that presses a proxy against torture geometry, and what is measured.
#pragma once

#include "tests/haptics/contact/scenarios/plant.h"
#include "tests/haptics/contact/scenarios/watched_machine.h"

#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace touchline::scenarios {

struct ScenarioRun {
    std::vector<Position> hand, proxy;  // per tick
    std::vector<Force> force;           // the contact's, before the motors
    std::vector<double> level;          // rendered
    Watch watch;
};

using WantedLevel = std::function<double(double t_s)>;

[[nodiscard]] double level_0(double t_s);

[[nodiscard]] ScenarioRun run(const Scene& scene, const Trajectory& trajectory, double end_s,
                              const CommonSetUp& set_up = {}, const WantedLevel& level = level_0);

[[nodiscard]] double largest_force_N(const ScenarioRun& run);

/// Largest change of the force vector within `ticks` ticks, from tick `first` on and the tick
/// before it.
struct Jump {
    double size_N = 0.0;
    std::size_t tick = 0;
};

[[nodiscard]] Jump largest_jump(const ScenarioRun& run, std::size_t first = 0,
                                std::size_t ticks = 1);

/// Returns the largest extent of the hand's motion along an axis in the last fifth of the run.
[[nodiscard]] double tail_peak_to_peak_m(const ScenarioRun& run);

/// Checks |value - reference| <= share |reference|.
[[nodiscard]] testing::AssertionResult is_within(double value, double reference, double share);

/// Expects the largest force within 3 %, the largest jump within 10 %, and a sound run.
void expect_forces(const ScenarioRun& run, double force_N, double jump_N);

}  // namespace touchline::scenarios
