// Two devices, and the reachable poses of one on a grid, for tests that must hold everywhere.
#pragma once

#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"

namespace touchline {

inline constexpr double mm = 1e-3;
inline constexpr Geometry gen3{0.070, 0.090, 0.038};
inline constexpr Geometry gen2{0.070, 0.090, 0.0};

/// Calls visit(p_DH, angles, pose) at every reachable point with y > 0, `step_m` apart. Returns the
/// number of points.
template <class Visit>
int visit_workspace(const Geometry& geometry, double step_m, Visit&& visit) {
    const double reach_m = geometry.proximal_m + geometry.distal_m;
    const double margin_m = 1e-4;  // away from the singular edge
    int count = 0;
    for (double x = -reach_m + margin_m; x < reach_m + geometry.base_m; x += step_m) {
        for (double y = margin_m; y < reach_m; y += step_m) {
            const Position p{x, y};
            const auto angles = inverse(geometry, p);
            if (!angles) continue;
            const auto pose = forward(geometry, *angles);
            if (!pose) continue;
            visit(p, *angles, *pose);
            ++count;
        }
    }
    return count;
}

/// Does the same inside the profile's drawing area, edges included.
template <class Visit>
int visit_area(const DeviceProfile& profile, double step_m, Visit&& visit) {
    int count = 0;
    for (double x = -0.5 * profile.area.width_m; x <= 0.5 * profile.area.width_m + 1e-9;
         x += step_m) {
        for (double y = -0.5 * profile.area.height_m; y <= 0.5 * profile.area.height_m + 1e-9;
             y += step_m) {
            const Position p = device_from_picture(profile, {x, y});
            const JointAngles angles = inverse(profile.geometry, p).value();
            visit(p, angles, forward(profile.geometry, angles).value());
            ++count;
        }
    }
    return count;
}

}  // namespace touchline
