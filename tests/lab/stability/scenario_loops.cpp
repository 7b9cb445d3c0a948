#include "tests/lab/stability/scenario_loops.h"

#include "haptics/servo/loop_settings.h"
#include "tests/lab/stability/factorial.h"
#include "tests/lab/stability/for_each_index.h"
#include "tests/lab/stability/shipped_loop.h"

#include <fmt/core.h>

namespace touchline::stability {
namespace {

constexpr double period_s = 1e-3;
constexpr double armed_s = 0.9;
constexpr double rest_s = 2.0;
constexpr double tail_s = 0.5;

/// Goes where the scenario says once force is on, and stays at its end.
class DelayedPath final : public IntendedPath {
  public:
    DelayedPath(scenarios::Trajectory path, double end_s) : path_(std::move(path)), end_s_(end_s) {}

    [[nodiscard]] Intention at(double t_s) const override {
        const double own_s = t_s - armed_s;
        if (own_s > 0.0 && own_s < end_s_) return path_(own_s);
        return {path_(own_s > 0.0 ? end_s_ : 0.0).position, {}};
    }

  private:
    scenarios::Trajectory path_;
    double end_s_;
};

ShippedLoop loop_of(const ScenarioCase& each) {
    ShippedLoop loop;
    loop.profile = default_profile();
    loop.period_s = period_s / loop_methods()[each.method].local_rate;
    loop.delay_s = each.delay_periods * loop.period_s;
    loop.hand = loop_hand(each.hand);
    loop.stiffness_N_per_m =
        each.asked * loop_settings(loop.profile, period_s, 0.0).stiffness_N_per_m;
    const LoopScenario& scenario = loop_scenarios()[each.scenario];
    loop.radius_m = scenario.radius_m;
    if (scenario.level) {
        loop.level = [&scenario](double t_s) {
            return scenario.level(std::max(0.0, t_s - armed_s));
        };
    }
    return loop;
}

}  // namespace

std::vector<ScenarioCase> scenario_cases(std::size_t method, double asked) {
    std::vector<ScenarioCase> cases;
    for (std::size_t i = 0; i < loop_scenarios().size(); ++i) {
        if (!loop_scenarios()[i].is_plain() && method != 0) continue;
        for (const char* hand : loop_hands) {
            for (const double delay : {0.0, 1.0, 2.0})
                cases.push_back({i, method, hand, delay, asked});
        }
    }
    return cases;
}

bool buzzes(const ScenarioResult& result) {
    return result.extent_steps > 2.0 && result.ripple_N > 0.02;
}

ScenarioResult measure(const ScenarioCase& each) {
    const LoopScenario& scenario = loop_scenarios()[each.scenario];
    const bench::Torture& torture = scenario.torture;
    const ShippedLoop loop = loop_of(each);
    const auto controller = loop_methods()[each.method].make(
        loop.profile, {loop.period_s, loop.stiffness_N_per_m, loop.radius_m}, scenario);
    const double span_s = armed_s + torture.end_s + rest_s;
    const auto path = std::make_shared<DelayedPath>(torture.hand, torture.end_s);
    const LoopTrace trace = run(loop, *controller, path, span_s);
    ScenarioResult result;
    for (std::size_t k = 0; k < trace.place.size(); ++k) {
        result.largest_N = std::max(result.largest_N, norm(trace.force[k]));
        if (k == 0 || trace.time_s[k] <= armed_s) continue;
        if (torture.is_through(trace.tip[k - 1], trace.tip[k])) ++result.handle_through;
        if (torture.is_through(trace.place[k - 1], trace.place[k])) ++result.let_through;
    }
    result.extent_steps = extent_m(trace, span_s - tail_s) / encoder_step_m(loop.profile);
    result.ripple_N = ripple_N(trace, span_s - tail_s);
    result.least_gain = trace.least_gain;
    result.generated_J = trace.generated_J;
    result.bound_J = trace.bound_J;
    return result;
}

std::vector<ScenarioResult> measure_all(const std::vector<ScenarioCase>& cases) {
    std::vector<ScenarioResult> results(cases.size());
    (void)loop_scenarios();  // makes them before the threads start
    for_each_index(cases.size(), [&](std::size_t i) { results[i] = measure(cases[i]); });
    return results;
}

std::string csv_line(const ScenarioCase& each, const ScenarioResult& result) {
    const bench::Torture& torture = loop_scenarios()[each.scenario].torture;
    return fmt::format("{},{},{},{},{:g},{:g},{},{},{:.3g},{:.3g},{},{:.3g},{:.3g},{:.3g},{:.3g}",
                       torture.group, torture.name, loop_methods()[each.method].name, each.hand,
                       each.delay_periods, each.asked, result.handle_through, result.let_through,
                       result.extent_steps, result.ripple_N, buzzes(result) ? 1 : 0,
                       result.largest_N, result.least_gain, result.generated_J, result.bound_J);
}

}  // namespace touchline::stability
