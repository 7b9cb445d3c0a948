// The lines found in a picture as flat bytes, for another worker that makes a map of them. Both
// workers are the same program. The kiosk keeps the bytes in between and does not look into them.
// They hold what was found, then each chain with its points. Little-endian. Threads: pure
// functions.
#pragma once

#include "config/types/result.h"
#include "vision/simplify/trace.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

/// Holds what trace_lines() needs, and the report; leaves out the edges' strengths and the features
/// of the class. O(points).
[[nodiscard]] std::vector<std::byte> bytes_of(const Found& found);

/// Restores what bytes_of() got, bit for bit. Fails unless the sizes add up, every number is finite
/// and no size of a picture is empty. O(points).
[[nodiscard]] Result<Found> found_of(std::span<const std::byte> bytes);

}  // namespace touchline
