// Small scenes for the tests of the haptic core.
#pragma once

#include "config/types/tactile_map.h"
#include "haptics/curve/curve_set.h"

#include <vector>

namespace touchline::scenes {

[[nodiscard]] Outline outline(std::vector<Position> points, bool is_closed);

[[nodiscard]] TactileMap map_of(std::vector<Outline> outlines);

/// Returns a circle counter-clockwise about the origin.
[[nodiscard]] Outline circle(double radius_m, int points);

/// Returns a square counter-clockwise about the origin, `per_side` edges a side, the first vertex a
/// corner.
[[nodiscard]] Outline square(double side_m, int per_side);

/// Returns one closed outline of 512 points, 26 to 34 mm from the origin, that wanders by up to
/// `roughness_m` a point: detail at every scale.
[[nodiscard]] TactileMap rough_ring(unsigned seed, double roughness_m);

/// Returns wobbly closed curves and open walks of 8 to 80 points within +-50 mm, which may cross
/// themselves and each other; every third open one ends on a vertex of the outline before it.
[[nodiscard]] TactileMap random_map(unsigned seed, int outlines);

[[nodiscard]] double distance_m(Position p, const Segment& segment);

}  // namespace touchline::scenes
