// Placing the level-0 points of a stretch of outline.
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace touchline {

/// Sum of the edges of a polyline.
[[nodiscard]] double polyline_length_m(std::span<const Position> line);

/// The polyline with edges longer than `spacing_m` split into equal collinear parts: no shape
/// changes.
[[nodiscard]] std::vector<Position> split_edges(std::vector<Position> line, double spacing_m);

/// `segments` + 1 points at equal arc length; the ends are those of the line.
[[nodiscard]] std::vector<Position> resample(std::span<const Position> line, std::size_t segments);

/// Segments that a resampled piece can have: m 2^L with m in 4 ... 7, or fewer than 4; 8 or more
/// where it is closed. The largest such count <= wanted (at least the least there is), the smallest
/// >= wanted, and the nearer of the two. `wanted` is length / spacing; taken as 1e15 beyond. O(log
/// n).
[[nodiscard]] std::size_t count_below(double wanted, bool is_closed);
[[nodiscard]] std::size_t count_above(double wanted, bool is_closed);
[[nodiscard]] std::size_t nearest_count(double wanted, bool is_closed);

/// Halvings down to 4 ... 7 segments (closed: 8 ... 15). O(log n).
[[nodiscard]] int halvings(std::size_t segments, bool is_closed);

/// Largest distance from a point of `line` to the polyline `kept`, both running the same way: each
/// point is compared with the part of `kept` at its own share of the arc length, +-1 segment. Ends
/// with the first distance above `enough_m`. O(N).
[[nodiscard]] double deviation_m(std::span<const Position> line, std::span<const Position> kept,
                                 double enough_m = std::numeric_limits<double>::infinity());

/// The middle one of the values by size, the upper of two. 0 where there is none. O(N).
[[nodiscard]] double median(std::vector<double> values);

/// Median edge length of a polyline. 0 where there is no edge.
[[nodiscard]] double median_edge_m(std::span<const Position> line);

}  // namespace touchline
