// Measures whether a hand can tell the lines of a map apart: where they come near without meeting,
// how many there are, and how long they are. Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

inline constexpr double least_gap_m = 0.003;  // 1/8 inch: the least gap that a finger can feel
inline constexpr double least_rim_m = 0.003;

struct NearLines {
    std::size_t one = 0;  // indices of the map's outlines; equal: two places of one
    std::size_t other = 0;
    double gap_m = 0.0;
};

/// Every pair of outlines that come nearer than least_gap_m without meeting there, and every
/// outline that comes so near to itself; nearest first, at most `most`. Lines that meet may be near
/// each other within 8 mm of the meeting. Near-linear in the lines' length for a map with room;
/// examines at most 200 000 places.
[[nodiscard]] std::vector<NearLines> near_lines(const TactileMap& map, std::size_t most);

/// The number of parts. Outlines of the same label, and of the same id except for its suffix -2,
/// -3, ..., are one part. O(n log n).
[[nodiscard]] std::size_t part_count(const TactileMap& map);

/// The length of all outlines together.
[[nodiscard]] double line_length_m(const TactileMap& map);

/// The most parts that a picture of this difficulty (1 ... 5) should have
/// (app/documents/gallery/README.md).
[[nodiscard]] int most_parts(int difficulty);

[[nodiscard]] bool is_near_rim(const Outline& outline, const Area& area);

}  // namespace touchline
