#include "tests/haptics/servo/scenario_runner.h"

#include "haptics/contact/contact_machine.h"
#include "haptics/device/tip_dynamics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace touchline {
namespace {

constexpr int substeps = 8;
constexpr TipParameters tip{0.05, 0.1, 0.05};

double spring_J(Position stretch) {
    return 0.5 * scenario_stiffness_N_per_m * dot(stretch, stretch);
}

bool is_pushing(const ScenarioRun& run, std::size_t tick) {
    return tick < run.force.size() && run.force[tick] != Force{};
}

}  // namespace

Scene scenario_scene(const std::vector<Polyline>& polylines) {
    TactileMap map;
    for (const Polyline& polyline : polylines) {
        Outline outline;
        outline.is_closed = polyline.is_closed;
        for (const Position p : polyline.points_mm) outline.points.push_back(1e-3 * p);
        map.outlines.push_back(outline);
    }
    return build_scene(map, {}, scenario_radius_m).value();
}

Trajectory through(const std::vector<Waypoint_mm>& waypoints) {
    std::vector<WaypointPath::Waypoint> points;
    for (const Waypoint_mm& w : waypoints)
        points.push_back({w.t_s, {w.x_mm * 1e-3, w.y_mm * 1e-3}});
    return [path = WaypointPath(points)](double t_s) {
        Intention intention = path.at(t_s);
        if (t_s <= 0.0) intention.velocity = {};
        return intention;
    };
}

ScenarioRun run_scenario(const Scene& scene, const Trajectory& trajectory, double end_s) {
    const auto ticks = static_cast<std::size_t>(std::lround(end_s / scenario_tick_s));
    const ContactSettings settings{Mode::wall, scenario_stiffness_N_per_m, 0.0, scenario_radius_m,
                                   0.003};
    const Intention start = trajectory(0.0);
    TipDynamics dynamics(tip, normal_hand, start.position);
    dynamics.set_velocity(start.velocity);
    const auto contact = std::make_unique<ContactMachine>();
    contact->reset(scene, start.position, 0.0);

    ScenarioRun run;
    std::vector<double> sampling_J;
    for (std::size_t k = 0; k < ticks; ++k) {
        const Position hand = dynamics.tip().position;
        const double before_m = norm(hand - contact->proxy().centre);
        const ContactReport report = contact->step(hand, 0.0, settings, Budget{});
        run.farthest_growth_m =
            std::max(run.farthest_growth_m, norm(hand - report.p_WP) - before_m);
        run.hand.push_back(hand);
        run.proxy.push_back(report.p_WP);
        run.force.push_back(report.force);
        for (int i = 0; i < substeps; ++i) {
            const double h_s = scenario_tick_s / substeps;
            dynamics.step(report.force,
                          trajectory(static_cast<double>(k) * scenario_tick_s + i * h_s), h_s);
        }
        const Position moved = dynamics.tip().position - hand;
        run.work_J += dot(report.force, moved);
        sampling_J.push_back(spring_J(moved));
    }
    for (std::size_t k = 0; k < ticks; ++k) {
        if (is_pushing(run, k) || is_pushing(run, k + 1)) run.allowed_J += sampling_J[k];
    }
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

}  // namespace touchline
