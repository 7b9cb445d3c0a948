// What a sound map may hold, for both the giver and the taker of a map.
// Threads: pure functions.
#pragma once

#include "config/types/tactile_map.h"

#include <cstddef>
#include <string_view>

namespace touchline {

struct MapLimits {
    static constexpr std::size_t outlines = 50'000;
    static constexpr std::size_t labels = 10'000;
    static constexpr std::size_t points = 1'000'000;      // of all outlines together
    static constexpr std::size_t text_bytes = 4'000'000;  // of all texts together
    static constexpr double area_m = 1.0;                 // either side, > 0
    static constexpr double place_m = 1.0;                // either coordinate, +-
    static constexpr double least_weight = 1e-9;
    static constexpr double most_weight = 1e9;
    static constexpr int most_detail = 5;  // from 1
};

/// Returns the number of points of all outlines. O(outlines).
[[nodiscard]] std::size_t point_count(const TactileMap& map);

/// Returns the number of bytes of all texts. O(outlines + labels).
[[nodiscard]] std::size_t text_bytes(const TactileMap& map);

/// Returns in a few words how the map breaks config/types/tactile_map.h or a limit; empty if it is
/// sound. Does not look into texts. O(n log n) for the ids.
[[nodiscard]] std::string_view fault_of(const TactileMap& map);

}  // namespace touchline
