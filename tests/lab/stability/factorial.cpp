#include "tests/lab/stability/factorial.h"

#include "haptics/servo/loop_settings.h"
#include "tests/lab/stability/for_each_index.h"
#include "tests/lab/stability/hands.h"
#include "tests/lab/stability/maps.h"
#include "tests/lab/stability/shipped_loop.h"

#include <cmath>

#include <fmt/core.h>

namespace touchline::stability {
namespace {

constexpr double high_m = 0.01;  // above the wall, at first
constexpr double press_N = 1.0;
constexpr double speed_m_per_s = 0.2;
constexpr double armed_s = 0.9;
constexpr double slide_m = 0.02;
constexpr double wall_span_s = 4.0;
constexpr double tail_s = 0.5;

Faults faults_of(const std::string& name) {
    Faults faults;
    const bool is_all = name == "all";
    if (is_all || name == "scale") faults.arm_1_scale_error = 0.015;
    if (is_all || name == "friction") faults.friction_factor = 2.0;
    if (is_all || name == "noise") faults.torque_noise = 0.05;
    if (is_all || name == "late") faults.late_share = 0.01;
    return faults;
}

ShippedLoop loop_of(const FactorialCase& each) {
    ShippedLoop loop;
    loop.profile = find_device_profile(each.profile).value();
    loop.period_s = each.period_s;
    loop.delay_s = each.delay_periods * each.period_s;
    loop.hand = loop_hand(each.hand);
    loop.faults = faults_of(each.fault);
    const LoopSettings settings = loop_settings(loop.profile, loop.period_s, 0.0);
    loop.stiffness_N_per_m =
        each.is_stiffest ? settings.largest_stiffness_N_per_m : settings.stiffness_N_per_m;
    return loop;
}

/// Returns a place along the wall and away from it.
Position placed(double along_m, double away_m, bool is_upright) {
    return is_upright ? Position{away_m, along_m} : Position{along_m, away_m};
}

std::shared_ptr<const IntendedPath> press_hold_slide_hold(const ShippedLoop& loop,
                                                          bool is_upright) {
    const double deep_m =
        press_N * (1.0 / loop.hand.stiffness_N_per_m + 1.0 / loop.stiffness_N_per_m);
    const double down_s = armed_s + (high_m + deep_m) / speed_m_per_s;
    const auto at = [&](double along_m, double away_m) {
        return placed(along_m, away_m, is_upright);
    };
    return std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{
        {armed_s, at(-0.5 * slide_m, high_m)},
        {down_s, at(-0.5 * slide_m, -deep_m)},
        {down_s + 0.8, at(-0.5 * slide_m, -deep_m)},
        {down_s + 1.2, at(0.5 * slide_m, -deep_m)},
    });
}

Scene wall(bool is_upright) {
    TactileMap map;
    map.outlines.push_back({});
    map.outlines.back().points = {placed(-0.03, 0.0, is_upright), placed(0.03, 0.0, is_upright)};
    return build_scene(map, {}, 0.0).value();
}

constexpr double geometry_period_s = 1e-3;
constexpr double rest_s = 2.0;

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
    loop.period_s = geometry_period_s / loop_methods()[each.method].local_rate;
    loop.delay_s = each.delay_periods * loop.period_s;
    loop.hand = loop_hand(each.hand);
    loop.stiffness_N_per_m =
        each.asked * loop_settings(loop.profile, geometry_period_s, 0.0).stiffness_N_per_m;
    const LoopScenario& scenario = loop_scenarios()[each.scenario];
    loop.radius_m = scenario.radius_m;
    if (scenario.level) {
        loop.level = [&scenario](double t_s) {
            return scenario.level(std::max(0.0, t_s - armed_s));
        };
    }
    if (scenario.scene_at) {
        loop.scene_at = [&scenario](double t_s) {
            return scenario.scene_at(std::max(0.0, t_s - armed_s));
        };
    }
    return loop;
}

}  // namespace

const HandModel& loop_hand(const std::string& name) {
    return name == "none" ? soft_press : hand_by_name(name);
}

std::vector<DeviceProfile> all_devices() {
    std::vector<DeviceProfile> all(device_profiles().begin(), device_profiles().end());
    all.push_back(open_five_bar());
    all.push_back(find_device_profile("inverse3").value());
    return all;
}

std::vector<FactorialCase> factorial(const std::vector<double>& delays) {
    std::vector<FactorialCase> cases;
    for (const DeviceProfile& profile : all_devices()) {
        for (const double period_s : {2e-3, 1e-3, 2.5e-4}) {
            for (const double delay : delays) {
                for (const char* hand : loop_hands) {
                    for (const char* fault :
                         {"none", "scale", "friction", "noise", "late", "all"}) {
                        for (const bool is_stiffest : {false, true}) {
                            for (const bool is_upright : {false, true}) {
                                cases.push_back({std::string(profile.name), period_s, delay, hand,
                                                 fault, is_stiffest, is_upright});
                            }
                        }
                    }
                }
            }
        }
    }
    return cases;
}

bool shakes(const FactorialResult& result) {
    return result.extent_m > 20e-6 && result.extent_steps > 2.0 && result.ripple_N > 0.02;
}

FactorialResult measure(const FactorialCase& each) {
    const ShippedLoop loop = loop_of(each);
    const Scene scene = wall(each.is_upright);
    const LoopTrace trace =
        run(loop, scene, press_hold_slide_hold(loop, each.is_upright), wall_span_s);
    FactorialResult result;
    result.stiffness_N_per_m = loop.stiffness_N_per_m;
    result.extent_m = extent_m(trace, wall_span_s - tail_s);
    result.extent_steps = result.extent_m / encoder_step_m(loop.profile);
    result.ripple_N = ripple_N(trace, wall_span_s - tail_s);
    result.least_gain = trace.least_gain;
    result.generated_J = trace.generated_J;
    result.bound_J = trace.bound_J;
    for (const Position proxy : trace.place) {
        result.is_through |= (each.is_upright ? proxy.x : proxy.y) < -1e-6;
    }
    return result;
}

std::vector<FactorialResult> measure_all(const std::vector<FactorialCase>& cases) {
    std::vector<FactorialResult> results(cases.size());
    for_each_index(cases.size(), [&](std::size_t i) { results[i] = measure(cases[i]); });
    return results;
}

std::string csv_line(const FactorialCase& each, const FactorialResult& result) {
    return fmt::format(
        "{},{:g},{:g},{},{},{},{},{:.4g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{:.3g},{},{}",
        each.profile, 1e3 * each.period_s, each.delay_periods, each.hand, each.fault,
        each.is_stiffest ? "stiffest" : "default", each.is_upright ? "upright" : "level",
        result.stiffness_N_per_m, 1e6 * result.extent_m, result.extent_steps, result.ripple_N,
        result.least_gain, result.generated_J, result.bound_J, result.is_through ? 1 : 0,
        shakes(result) ? 1 : 0);
}

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
