// A TactileMap as flat bytes, which cross between processes in sealed memory. Their reader must not
// trust them.
//
//   header    magic u32, layout u32, area f64 f64, version u64, title, description
//   outlines  how many u32; each: closed u8, weight f64, detail i32, id, label, and its points: how
//             many u32, then f64 f64 each
//   labels    how many u32; each: place f64 f64, text
//
// A text is its byte count u32 and the bytes. Little-endian. There are no offsets, so nothing can
// overlap or point outside. Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace touchline {

/// What a sound map may hold, for both its giver and its taker.
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

/// Fails, with one line, for a map beyond its limits: with a number that is not
/// finite, an outline of fewer than two points, or an id that appears twice. Bytes of a text that
/// are not UTF-8 become '?'. O(n log n) for the ids.
[[nodiscard]] Result<std::vector<std::byte>> bytes_of(const TactileMap& map);

/// Returns the map. Fails, with one line, unless the bytes are exactly what bytes_of() returns for
/// some map. `bytes` may be anything. Allocates at most what a map within the limits needs.
/// O(n log n).
[[nodiscard]] Result<TactileMap> map_of(std::span<const std::byte> bytes);

}  // namespace touchline
