// Coulomb friction of a proxy on a line: on a straight edge, and round a corner in closed form.
// Threads: pure functions.
#pragma once

#include <cmath>
#include <limits>

namespace touchline {

/// The cone: how far along a line a pull may reach and not move what it presses on the line to this
/// depth, in the unit of the depth. For one depth or four.
template <class Number, class Depth>
[[nodiscard]] Depth held_by_friction(Number friction, Depth depth) {
    return friction * depth;
}

/// The same on an arc of radius `offset_m` round a vertex from which a pull, inside the arc, is
/// `distance_m` away: where the proxy stops, as the angle from there to the pull's direction.
/// Infinite where the cone holds it anywhere. `friction` > 0.
[[nodiscard]] inline double angle_held_by_friction_rad(double friction, double offset_m,
                                                       double distance_m) {
    // The angle b before the pull's direction obeys
    // distance sin b = friction (offset - distance cos b).
    const double lean_rad = std::atan(friction);
    const double sine = offset_m * std::sin(lean_rad) / distance_m;
    return sine < 1.0 ? std::asin(sine) - lean_rad : std::numeric_limits<double>::infinity();
}

}  // namespace touchline
