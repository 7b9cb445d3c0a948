// Finds pins: the vertices that coincide at every level, so that corners stay sharp and linked
// pieces never come apart. Done once, when a map is built. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"

#include <cstddef>
#include <vector>

namespace touchline {

struct PinRule {
    double reach_m = 0.002;  // a turn is measured between chords of this length on both sides
    double turn_rad = 0.785398163397448;  // 45 degrees: weaker corners are not pinned
    double apart_m = 0.004;               // least distance along the outline between two corners
    double noise_m = 0.0;  // standard deviation per coordinate, taken out before turns are measured
};

/// Returns the pins of every outline of a map, as ascending vertex indices: the ends of open
/// outlines, vertices where the end of another outline lies (junctions), and corners, strongest
/// first. A closed outline may have none. O(N log N).
[[nodiscard]] std::vector<std::vector<std::size_t>> find_pins(const std::vector<Outline>& outlines,
                                                              const PinRule& rule);

}  // namespace touchline
