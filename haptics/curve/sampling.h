// Placing the level-0 points of a stretch of outline.
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

/// Sum of the edges of a polyline.
[[nodiscard]] double polyline_length_m(std::span<const Position> line);

/// The polyline with edges longer than `spacing_m` split into equal collinear parts: no shape
/// changes.
[[nodiscard]] std::vector<Position> split_edges(std::span<const Position> line, double spacing_m);

/// `segments` + 1 points at equal arc length; the ends are those of the line.
[[nodiscard]] std::vector<Position> resample(std::span<const Position> line, std::size_t segments);

/// Segments of a resampled piece: the smallest m 2^L >= length / spacing with m in 4 ... 7, fewer
/// than 4 as they are; a closed piece has at least 8.
[[nodiscard]] std::size_t resampled_count(double length_m, double spacing_m, bool is_closed);

/// Halvings down to 4 ... 7 segments (closed: 8 ... 15). O(log n).
[[nodiscard]] int halvings(std::size_t segments, bool is_closed);

/// Largest distance from a point of `line` to the polyline `kept`, both running the same way: each
/// point is compared with the part of `kept` at its own share of the arc length, +-1 segment. O(N).
[[nodiscard]] double deviation_m(std::span<const Position> line, std::span<const Position> kept);

/// Median edge length of the outlines given. 0 where there is no edge.
[[nodiscard]] double median_edge_m(std::span<const Position> line);

}  // namespace touchline
