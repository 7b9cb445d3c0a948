// A stroke of a pen as lines that a hand can follow: smoothed, its corners kept, taken apart where
// it crosses itself. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace touchline {

inline constexpr std::size_t most_crossings = 60;  // of a stroke with itself

/// The lines of a stroke (W, metres), on the map's grid. Points beyond the area are moved to its
/// rim, and those that are not finite are left out. A stroke whose ends come within 4 mm of each
/// other is closed, if it is longer than four times that; an end within 2 mm of a line of `others`
/// is led to the nearest vertex of it, bit for bit. Loops too small for a finger are dropped. None:
/// less than 4 mm of line is left. Nothing at all: a scribble, which crosses itself more than
/// most_crossings times or lies many times over itself. O(points x points of the others), and
/// O(length) for each crossing: the stroke must be no longer than most_way_m of drawing.h.
[[nodiscard]] std::optional<std::vector<Outline>> touch_lines(std::span<const Position> stroke_W,
                                                              std::span<const Outline> others,
                                                              const Area& area);

}  // namespace touchline
