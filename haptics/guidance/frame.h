// The frame of the drawing area: pushes the hand back beyond the edge, so that there is always a
// place to begin from. Threads: a pure function.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <algorithm>
#include <cmath>

namespace touchline {

struct FramePush {
    Force force;
    double stored_J = 0.0;
};

inline constexpr double frame_N_per_m = 500.0;
inline constexpr double most_frame_N = 1.5;  // per side: a hand that wants out comes out

/// A spring beyond each side of the area, no stiffer than stiffness_N_per_m > 0. O(1).
[[nodiscard]] inline FramePush frame_push(const Area& area, Position handle,
                                          double stiffness_N_per_m) {
    const double k_N_per_m = std::min(stiffness_N_per_m, frame_N_per_m);
    FramePush push;
    const auto side = [&](double at_m, double half_m) {
        const double depth_m = std::max(0.0, std::abs(at_m) - half_m);
        const double force_N = std::min(k_N_per_m * depth_m, most_frame_N);
        push.stored_J += force_N * (depth_m - 0.5 * force_N / k_N_per_m);
        return -std::copysign(force_N, at_m);
    };
    push.force.x = side(handle.x, 0.5 * area.width_m);
    push.force.y = side(handle.y, 0.5 * area.height_m);
    return push;
}

/// Returns the place in the area that is nearest to p.
[[nodiscard]] inline Position within(const Area& area, Position p) {
    return {std::clamp(p.x, -0.5 * area.width_m, 0.5 * area.width_m),
            std::clamp(p.y, -0.5 * area.height_m, 0.5 * area.height_m)};
}

}  // namespace touchline
