// A hand that goes to and fro across a wave, and the page faults of its ticks, for tests that count
// the cost of a tick. Threads: any.
#pragma once

#include "haptics/collision/scene.h"
#include "haptics/device/simulated/simulated_pantograph.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <sys/resource.h>

namespace touchline {

/// A wave of 20 mm height across the drawing area, with 1000 edges.
inline std::shared_ptr<const Scene> turned_wave_scene(double phase_rad) {
    TactileMap map;
    Outline wave;
    for (int i = 0; i <= 1000; ++i) {
        const double x = -0.05 + 0.1 * i / 1000.0;
        wave.points.push_back({x, 0.01 * std::sin(150.0 * x + phase_rad)});
    }
    map.outlines.push_back(wave);
    return std::make_shared<const Scene>(build_scene(map, {}, 0.001).value());
}

/// Goes to and fro across the middle, up to `reach_m` above and below it, a turn each half second.
inline std::shared_ptr<const IntendedPath> to_and_fro(int turns, double reach_m) {
    std::vector<WaypointPath::Waypoint> waypoints;
    for (int i = 0; i <= turns; ++i)
        waypoints.push_back({0.5 * i, {0.04 * std::sin(0.7 * i), reach_m * std::cos(1.3 * i)}});
    return std::make_shared<WaypointPath>(std::move(waypoints));
}

inline std::int64_t faults_of_this_thread() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_minflt + usage.ru_majflt;
}

}  // namespace touchline
