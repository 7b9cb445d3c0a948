// The lines that were found in a picture as flat bytes, for another worker that makes a map of
// them. Both are the same program; the kiosk keeps the bytes between the two and does not look into
// them: what was found, then each chain with its points. Little-endian. Threads: pure functions.
#pragma once

#include "config/types/result.h"
#include "vision/simplify/trace.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

/// What trace_lines() needs, and what a report tells; without the edges' strengths and the features
/// of the class. O(points).
[[nodiscard]] std::vector<std::byte> bytes_of(const Found& found);

/// Bit for bit what bytes_of() was given. Fails unless the sizes add up, every number is finite and
/// no size of a picture is empty. O(points).
[[nodiscard]] Result<Found> found_of(std::span<const std::byte> bytes);

}  // namespace touchline
