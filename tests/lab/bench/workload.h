// The peer workload: two curves of any size and the hand that presses on them, to measure every
// contact renderer on the same work. Deterministic; metres and seconds.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <cstdint>
#include <vector>

namespace touchline::workload {

enum class Kind { radial, fractal };

/// Returns a closed, counter-clockwise, simple curve. radial: a circle of 40 mm with octaves of
/// cosines, as many as n points can carry. fractal: a coastline of random-sided Koch edges; n = 16
/// or 32 times a power of 4.
[[nodiscard]] std::vector<Position> curve(Kind kind, std::size_t n);

/// Returns hand positions, one a millisecond: presses and slides at 0 to 0.3 m/s. The same for
/// every n.
[[nodiscard]] std::vector<Position> hand(Kind kind, std::size_t steps = 100000);

/// Returns 64-bit FNV-1a over the points rounded to 1 nm.
[[nodiscard]] std::uint64_t checksum(const std::vector<Position>& points);

[[nodiscard]] TactileMap map_of(std::vector<Position> closed_curve);

}  // namespace touchline::workload
