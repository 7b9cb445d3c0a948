// Private to app/decode: the packed pixels of a BMP.
// Threads: pure functions.
#pragma once

#include "app/decode/bmp_header.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace touchline::decode {

/// Rows in the file's order, of an index or, where the packing is runs_of_24, of blue, green and
/// red a pixel; 0 where nothing is written. Nothing where the file ends before the picture.
/// O(pixels + bytes).
[[nodiscard]] std::optional<std::vector<std::uint8_t>> unpacked_runs(Bytes packed,
                                                                     const BmpHeader& header);

}  // namespace touchline::decode
