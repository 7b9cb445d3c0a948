// Scenes of few or many outlines with the same edges in the same places, so that only the number of
// outlines differs. Deterministic; metres and seconds. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <cstddef>
#include <vector>

namespace touchline::bench {

/// Returns a spiral from 38 mm radius inward to 8 mm with 1.5 mm between its turns and a ripple of
/// 0.06 mm, cut into `outlines` open ones of `edges` / `outlines` equal edges each. The cuts
/// overlap like roof tiles: the next outline begins 5 um farther in and 3 edges back (1 if there
/// are no more), so that a hand that follows the spiral inward slides from one to the next. edges
/// >= 2 * outlines.
[[nodiscard]] TactileMap tiled_spiral(std::size_t edges, std::size_t outlines);

/// Returns a hand that follows the spiral inward at 0 to 0.3 m/s, one position a millisecond. It
/// starts 0.4 mm outside the spiral and presses to 1 mm inside it 2.5 times a second. Ends with the
/// spiral or after `steps`.
[[nodiscard]] std::vector<Position> hand_on_spiral(std::size_t steps);

}  // namespace touchline::bench
