#include "tests/haptics/contact/scenarios/runner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

namespace touchline::scenarios {

double level_0(double) {
    return 0.0;
}

ScenarioRun run(const Scene& scene, const Trajectory& trajectory, double end_s,
                const CommonSetUp& set_up, const WantedLevel& level) {
    const auto ticks = static_cast<std::size_t>(std::lround(end_s / tick_s));
    Plant plant(set_up, trajectory);
    WatchedMachine contact(scene, set_up, plant.position(), level(0.0));
    ScenarioRun run;
    for (std::size_t k = 0; k < ticks; ++k) {
        const Position hand = plant.position();
        const ContactReport report = contact.step(hand, level(static_cast<double>(k) * tick_s));
        run.hand.push_back(hand);
        run.proxy.push_back(report.p_WP);
        run.force.push_back(report.force);
        run.level.push_back(contact.machine().rendered_level());
        plant.tick(k, limited(report.force, set_up.motors_N));
    }
    run.watch = contact.watch();
    return run;
}

double largest_force_N(const ScenarioRun& run) {
    double largest = 0.0;
    for (const Force f : run.force) largest = std::max(largest, norm(f));
    return largest;
}

Jump largest_jump(const ScenarioRun& run, std::size_t first, std::size_t ticks) {
    Jump jump;
    for (std::size_t k = first; k + ticks < run.force.size(); ++k) {
        const double size_N = norm(run.force[k + ticks] - run.force[k]);
        if (size_N > jump.size_N) jump = {size_N, k};
    }
    return jump;
}

double tail_peak_to_peak_m(const ScenarioRun& run) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Position low{infinity, infinity};
    Position high{-infinity, -infinity};
    for (std::size_t k = run.hand.size() - run.hand.size() / 5; k < run.hand.size(); ++k) {
        low = {std::min(low.x, run.hand[k].x), std::min(low.y, run.hand[k].y)};
        high = {std::max(high.x, run.hand[k].x), std::max(high.y, run.hand[k].y)};
    }
    return std::max(high.x - low.x, high.y - low.y);
}

testing::AssertionResult is_within(double value, double reference, double share) {
    if (std::abs(value - reference) <= share * std::abs(reference)) {
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure()
           << fmt::format("{:.6g} is {:+.2f} % off {:.6g}, more than {:.2f} %", value,
                          100.0 * (value / reference - 1.0), reference, 100.0 * share);
}

void expect_forces(const ScenarioRun& run, double force_N, double jump_N) {
    EXPECT_TRUE(is_within(largest_force_N(run), force_N, 0.03));
    EXPECT_TRUE(is_within(largest_jump(run).size_N, jump_N, 0.10));
    testing::Test::RecordProperty("force_N", fmt::format("{:.4f}", largest_force_N(run)));
    testing::Test::RecordProperty("jump_N", fmt::format("{:.4f}", largest_jump(run).size_N));
    expect_sound(run.watch);
}

}  // namespace touchline::scenarios
