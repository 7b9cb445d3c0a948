// Chooses how far apart the level-0 points of a picture lie: no more of them than the scene, the
// device and the data need. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"
#include "haptics/curve/curve_set.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace touchline {

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
