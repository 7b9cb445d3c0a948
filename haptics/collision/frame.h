// A node's box as geometry: its frame, and how motions, points and other boxes lie to it.
// Threads: pure functions, no allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <array>
#include <optional>

namespace touchline {

/// A rectangle aligned to a segment.
struct AlignedBox {
    Position origin;  // the segment's first point
    Direction along;  // of the segment
    double along_low = 0.0, along_high = 0.0, across_low = 0.0, across_high = 0.0;  // metres
};

[[nodiscard]] std::array<Position, 4> corners_of(const AlignedBox& box);

[[nodiscard]] AlignedBox grown(AlignedBox box, double by_m);

/// The share of the way from `from` to `to` at which the box is entered; nothing if it is not.
[[nodiscard]] std::optional<double> entry(const AlignedBox& box, Position from, Position to);

/// 0 inside.
[[nodiscard]] double distance_m(const AlignedBox& box, Position p);

/// True when the boxes have a point in common (separating axes).
[[nodiscard]] bool overlap(const AlignedBox& a, const AlignedBox& b);

}  // namespace touchline
