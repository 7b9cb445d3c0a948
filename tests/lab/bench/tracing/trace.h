// A follower at the handle of a simulated pantograph, and the path that it traces.
// Threads: one. Deterministic.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/collision/scene.h"

#include <cstdint>
#include <span>
#include <vector>

namespace touchline::bench {

/// forces_off: the groove's follower with nothing to feel. tour: the hand lets itself be led.
enum class Tracing : std::uint8_t { groove, forces_off, wall, tour };

struct Traced {
    /// The handle every 2 ms while the follower believes that it is on a line; for a tour, while it
    /// leads along one.
    std::vector<Position> path;
    std::vector<Position> way;  // the handle every 10 ms, all of it
    double time_s = 0.0;        // until the follower was done, at most the limit
    double most_N = 0.0;
};

/// Runs from the moment that force is live until the limit. `scene` must have a version other than
/// 0.
[[nodiscard]] Traced trace(const Scene& scene, Tracing tracing, Position start, double limit_s);

}  // namespace touchline::bench
