// Places the level-0 points of a stretch of outline.
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace touchline {

/// Returns the sum of a polyline's edges.
[[nodiscard]] double polyline_length_m(std::span<const Position> line);

/// Splits edges longer than `spacing_m` into equal collinear parts; the shape does not change.
[[nodiscard]] std::vector<Position> split_edges(std::vector<Position> line, double spacing_m);

/// Returns `segments` + 1 points at equal arc length; the ends are the line's.
[[nodiscard]] std::vector<Position> resample(std::span<const Position> line, std::size_t segments);

/// Segments that a resampled piece can have: m 2^L with m in 4 ... 7, or fewer than 4; a closed one
/// has 8 or more. Returns the largest such count <= wanted (at least the smallest count), the
/// smallest >= wanted, or the nearer of the two. `wanted` is length / spacing; larger values count
/// as 1e15. O(log n).
[[nodiscard]] std::size_t count_below(double wanted, bool is_closed);
[[nodiscard]] std::size_t count_above(double wanted, bool is_closed);
[[nodiscard]] std::size_t nearest_count(double wanted, bool is_closed);

/// Returns the number of halvings down to 4 ... 7 segments (closed: 8 ... 15). O(log n).
[[nodiscard]] int halvings(std::size_t segments, bool is_closed);

/// Returns the largest distance from a point of `line` to the polyline `kept`; both run the same
/// way. Each point is compared with the part of `kept` at its own share of the arc length, +-1
/// segment. Stops at the first distance above `enough_m`. O(N).
[[nodiscard]] double deviation_m(std::span<const Position> line, std::span<const Position> kept,
                                 double enough_m = std::numeric_limits<double>::infinity());

/// Returns the middle value by size, the upper one of two; 0 if there are none. O(N).
[[nodiscard]] double median(std::vector<double> values);

/// Returns the median edge length of a polyline; 0 if it has no edge.
[[nodiscard]] double median_edge_m(std::span<const Position> line);

}  // namespace touchline
