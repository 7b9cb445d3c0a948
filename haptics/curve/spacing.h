// Places the level-0 points of a stretch of outline, and chooses how far apart those of a picture
// lie: no more of them than the scene, the device and the data need. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <cstddef>
#include <limits>
#include <span>
#include <string>
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

/// Returns the middle value by size, the upper one of two; 0 if there are none. Changes the values'
/// order. O(N).
[[nodiscard]] double median(std::span<double> values);

/// Returns the median edge length of a polyline; 0 if it has no edge.
[[nodiscard]] double median_edge_m(std::span<const Position> line);

/// A resampled curve passes this near to every point of its data: a fifth of what a finger finds on
/// a 4 mm bump (0.039 mm amplitude at half that width). Only the device's step may widen it.
inline constexpr double scene_tolerance_m = 5e-5;

/// A stretch of outline that becomes a piece, including both its ends (a closed one repeats its
/// first point at the end).
struct SpacedLine {
    std::span<const Position> points;
    int outline = 0;
    bool is_closed = false;
};

struct OutlineSpacing {
    double spacing_m = 0.0;
    std::string reason;
};

struct SpacingChoice {
    std::vector<OutlineSpacing> outlines;
    std::vector<std::size_t> segments;  // per line; empty if the map is not resampled
};

/// Chooses the spacing of every outline. `lines` are all the stretches of `outlines`, in any order.
/// Not resampled: the spacing asked for, else the outline's median edge, at least 0.1 mm.
/// Resampled: the spacing asked for, else the one spacing for the whole picture that takes the
/// fewest points while every data point stays within scene_tolerance_m, never below the device's
/// step. Each line gets the count m 2^L (m in 4 ... 7) next below its length / spacing, or next
/// above if that one strays too far. So spacings within a picture differ by a quarter at most. O(N
/// log(4 mm / step)).
[[nodiscard]] SpacingChoice choose_spacing(std::span<const SpacedLine> lines,
                                           std::span<const Outline> outlines,
                                           const CurveOptions& options);

}  // namespace touchline
