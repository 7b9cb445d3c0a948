// A simulated hand that presses a proxy against torture geometry, and what is measured of it.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/scene.h"
#include "haptics/device/hand.h"

#include <functional>
#include <vector>

namespace touchline {

inline constexpr double scenario_stiffness_N_per_m = 1000.0;
inline constexpr double scenario_radius_m = 5e-5;
inline constexpr double scenario_tick_s = 1e-3;

struct Polyline {
    std::vector<Position> points_mm;
    bool is_closed = false;
};

/// Level 0 of the production curves through these points.
[[nodiscard]] Scene scenario_scene(const std::vector<Polyline>& polylines);

using Trajectory = std::function<Intention(double t_s)>;

struct Waypoint_mm {
    double t_s, x_mm, y_mm;
};

/// Straight stretches, at rest at t = 0.
[[nodiscard]] Trajectory through(const std::vector<Waypoint_mm>& waypoints);

struct ScenarioRun {
    std::vector<Position> hand, proxy;  // per tick
    std::vector<Force> force;
    double work_J = 0.0;  // done on the hand
    double allowed_J =
        0.0;  // sum of 1/2 K |dx|^2 over the ticks of contact: what sampling may give away
    double farthest_growth_m = 0.0;  // of |hand - proxy| by an update of the proxy
};

/// Ticks of 1 ms, 8 integration steps each: tip 0.05 kg, 0.1 N s/m, 0.05 N of friction, held by a
/// normal hand; proxy radius 50 um, K = 1000 N/m, no delay.
[[nodiscard]] ScenarioRun run_scenario(const Scene& scene, const Trajectory& trajectory,
                                       double end_s);

[[nodiscard]] double largest_force_N(const ScenarioRun& run);

/// Largest change of the force vector within `ticks` ticks, from tick `first` on, and the tick
/// before it.
struct Jump {
    double size_N = 0.0;
    std::size_t tick = 0;
};

[[nodiscard]] Jump largest_jump(const ScenarioRun& run, std::size_t first = 0,
                                std::size_t ticks = 1);

/// Largest extent of the hand's motion along an axis in the last fifth of the run.
[[nodiscard]] double tail_peak_to_peak_m(const ScenarioRun& run);

}  // namespace touchline
