// Whether a hand can tell the lines of a map apart: where they come near without meeting, how many
// there are, and how long. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

inline constexpr double least_gap_m = 0.003;  // 1/8 inch: the least that a finger separates
inline constexpr double least_rim_m = 0.003;

struct NearLines {
    std::size_t one = 0;  // outlines of the map; the same twice: two places of one
    std::size_t other = 0;
    double gap_m = 0.0;
};

/// Every pair of outlines that come nearer than least_gap_m without meeting there, and every
/// outline that so comes near itself; nearest first, at most `most`. Lines that meet may be near 8
/// mm around where they do. Near-linear in the lines' length for a map with room; looks at no more
/// than 200 000 places.
[[nodiscard]] std::vector<NearLines> near_lines(const TactileMap& map, std::size_t most);

/// Outlines of one id but for its suffix -2, -3, ... and of one label are one part. O(n log n).
[[nodiscard]] std::size_t part_count(const TactileMap& map);

/// Of all outlines together.
[[nodiscard]] double line_length_m(const TactileMap& map);

/// Parts a picture of this difficulty (1 ... 5) should have at most (app/gallery/README.md).
[[nodiscard]] int most_parts(int difficulty);

[[nodiscard]] bool is_near_rim(const Outline& outline, const Area& area);

}  // namespace touchline
