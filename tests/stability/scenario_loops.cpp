#include "tests/stability/scenario_loops.h"

#include "haptics/servo/loop_settings.h"
#include "tests/stability/cell.h"
#include "tests/stability/for_each_index.h"
#include "tests/stability/shipped_loop.h"

#include <cmath>
#include <numbers>

#include <fmt/core.h>

namespace touchline::stability {
namespace {

using bench::Torture;
using scenarios::flat_line;
using scenarios::mm;
using scenarios::Polyline;
using scenarios::through;

constexpr double pi = std::numbers::pi;
constexpr double armed_s = 0.9;
constexpr double rest_s = 1.0;
constexpr double tail_s = 0.5;

bool is_below(Position, Position to) {
    return to.y < -1e-7;
}

/// A hand that means to be where the scenario says, once force is on, and stays there.
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

Torture flat(const std::string& name, const std::vector<Polyline>& lines) {
    return {"flat lines", name,    {}, lines, through({{0, -30, 10}, {.2, -30, -5}, {.8, 30, -5}}),
            0.9,          is_below};
}

Torture convex_vertex(double interior_deg) {
    const double turn = (180.0 - interior_deg) * pi / 180.0;
    const Position down{std::cos(turn), -std::sin(turn)};
    const Polyline line{{{-50.0, 0.0}, {0.0, 0.0}, 50.0 * down}};
    return {"convex vertices",
            fmt::format("{:g} degrees", interior_deg),
            {},
            {line},
            through({{0, -30, 10}, {.2, -30, -6}, {1.0, 20, -6}}),
            1.1,
            // Below the first face and on the inner side of the second.
            [down](Position, Position to) { return to.y < -1e-7 && cross(down, to) < -1e-9; }};
}

Torture polygon(int vertices) {
    const double inner_m = 30 * mm * std::cos(pi / vertices);
    const auto path = [](double t) -> Intention {
        const double angle = std::max(0.0, t - 0.2) * 0.1 / (27 * mm);
        const double radius_m = mm * (36.0 - 9.0 * std::min(1.0, t / 0.2));
        const Position out{std::cos(angle), std::sin(angle)};
        return {radius_m * out, {}};
    };
    return {"polygons",
            fmt::format("{} vertices", vertices),
            {},
            {scenarios::polygon(30.0, vertices)},
            path,
            2.0,
            [inner_m](Position, Position to) { return norm(to) < inner_m - 1e-7; }};
}

Torture tremor(double frequency_Hz, double amplitude_mm) {
    const auto path = [=](double t) -> Intention {
        const double omega = 2.0 * pi * frequency_Hz;
        // 2 mm deep: friction holds a light hand that means to be 1 mm deep outside.
        const double down_mm = 3.0 - 5.0 * std::min(1.0, t / 0.2);
        const double shake = t < 2.5 ? amplitude_mm : 0.0;
        return {
            {mm * shake * std::sin(0.83 * omega * t), mm * (down_mm + shake * std::sin(omega * t))},
            {mm * shake * 0.83 * omega * std::cos(0.83 * omega * t),
             mm * shake * omega * std::cos(omega * t)}};
    };
    return {"tremor", fmt::format("{:g} Hz {:g} mm", frequency_Hz, amplitude_mm),
            {},       {flat_line()},
            path,     2.6,
            is_below};
}

std::vector<Torture> all_scenarios() {
    std::vector<Torture> made = bench::tortures();
    const Polyline line = flat_line();
    const Polyline reversed{{line.points_mm.back(), line.points_mm.front()}};
    made.push_back(flat("one", {line}));
    made.push_back(flat("doubled", {line, reversed}));
    for (const double interior : {150.0, 90.0, 30.0}) made.push_back(convex_vertex(interior));
    for (const int vertices : {16, 64, 256}) made.push_back(polygon(vertices));
    made.push_back(tremor(8.0, 0.05));
    made.push_back(tremor(7.0, 0.18));
    made.push_back(tremor(5.0, 5.0));
    made.push_back(tremor(5.0, 10.0));
    return made;
}

}  // namespace

const std::vector<Torture>& loop_scenarios() {
    static const std::vector<Torture> made = all_scenarios();
    return made;
}

std::vector<ScenarioCase> scenario_cases() {
    std::vector<ScenarioCase> cases;
    for (std::size_t i = 0; i < loop_scenarios().size(); ++i) {
        for (const char* hand : {"light", "normal", "stiff arm", "arm + bad skin"}) {
            for (const double delay : {0.0, 1.0, 2.0}) cases.push_back({i, hand, delay});
        }
    }
    return cases;
}

ScenarioResult measure(const ScenarioCase& each) {
    const Torture& scenario = loop_scenarios()[each.scenario];
    CurveOptions whole_edges;
    whole_edges.spacing_m = 1.0;
    const Scene scene = scenarios::scene_of(scenario.lines, 0.0, whole_edges);
    ShippedLoop loop;
    loop.profile = default_profile();
    loop.delay_s = each.delay_periods * loop.period_s;
    loop.hand = hand_by_name(each.hand);
    loop.stiffness_N_per_m = loop_settings(loop.profile, loop.period_s, 0.0).stiffness_N_per_m;
    const double span_s = armed_s + scenario.end_s + rest_s;
    const LoopTrace trace =
        run(loop, scene, std::make_shared<DelayedPath>(scenario.hand, scenario.end_s), span_s);
    ScenarioResult result;
    for (std::size_t k = 0; k < trace.proxy.size(); ++k) {
        result.largest_N = std::max(result.largest_N, norm(trace.force[k]));
        if (k == 0 || trace.time_s[k] <= armed_s) continue;
        if (scenario.is_through(trace.tip[k - 1], trace.tip[k])) ++result.handle_through;
        if (scenario.is_through(trace.proxy[k - 1], trace.proxy[k])) ++result.let_through;
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
    (void)loop_scenarios();  // made before the threads are
    for_each_index(cases.size(), [&](std::size_t i) { results[i] = measure(cases[i]); });
    return results;
}

std::string csv_line(const ScenarioCase& each, const ScenarioResult& result) {
    const Torture& scenario = loop_scenarios()[each.scenario];
    return fmt::format("{},{},{},{:g},{},{},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g}",
                       scenario.group, scenario.name, each.hand, each.delay_periods,
                       result.handle_through, result.let_through, result.extent_steps,
                       result.ripple_N, result.largest_N, result.least_gain, result.generated_J,
                       result.bound_J);
}

}  // namespace touchline::stability
