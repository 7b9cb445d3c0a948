// A TactileMap as flat bytes, to cross between processes in sealed memory. Nobody who reads them
// trusts them.
//
//   header    72 bytes: magic, layout, bytes in all, area, version, the counts and sizes below
//   outlines  32 bytes each: points, closed, weight, detail, bytes of id and label
//   labels    24 bytes each: place, bytes of text
//   points    16 bytes each, of the first outline, of the second, ...
//   text      title, description, id and label of each outline, text of each label
//
// Little-endian. There are no offsets: every place follows from the counts before it, so nothing
// can overlap or point outside, and one size fits a given header. Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

/// Fails, with one line, for a map beyond its limits (map_limits.h): with a number that is not
/// finite, an outline of fewer than two points or an id given twice. Bytes of a text that are no
/// UTF-8 become '?'. O(n log n) for the ids.
[[nodiscard]] Result<std::vector<std::byte>> bytes_of(const TactileMap& map);

/// The map; fails, with one line, unless the bytes are exactly what bytes_of() gives for some map.
/// Any bytes may be given. Allocates at most what a map of this many bytes needs. O(n log n).
[[nodiscard]] Result<TactileMap> map_of(std::span<const std::byte> bytes);

}  // namespace touchline
