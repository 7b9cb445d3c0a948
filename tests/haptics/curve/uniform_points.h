// Judges "no more points than a scene needs": finds how few uniform points would do, without the
// code that chooses the product's. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "haptics/curve/curve_set.h"

#include <cstddef>
#include <vector>

namespace touchline::uniform {

/// A stretch of outline between pins; a closed one repeats its first point.
struct Line {
    std::vector<Position> points;
    bool is_closed = false;
};

/// Returns the lines in the order of a CurveSet's pieces.
[[nodiscard]] std::vector<Line> lines_of(const TactileMap& map);

/// Whether ceil(length / spacing) segments of equal length on every line pass all data points
/// within the scene's tolerance. Looks at every segment.
[[nodiscard]] bool is_near(const std::vector<Line>& lines, double spacing_m);

/// Returns the segments of the fewest such points. Finds the widest spacing that is near enough by
/// trying every half per cent from wide to narrow.
[[nodiscard]] std::size_t fewest_segments(const std::vector<Line>& lines);

/// Returns the same by bisection. Whether a spacing meets the data does not change once and for
/// all, so it may end at a narrower spacing that meets them by luck.
[[nodiscard]] std::size_t bisected_segments(const std::vector<Line>& lines);

[[nodiscard]] std::size_t segments_of(const CurveSet& curves);

/// Returns how far the farthest data point lies from level 0 of its piece.
[[nodiscard]] double farthest_m(const std::vector<Line>& lines, const CurveSet& curves);

}  // namespace touchline::uniform
