// Private to app/decode: the packed pixels of a BMP.
// Threads: pure functions.
#pragma once

#include "app/decode/bmp_header.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace touchline::decode {

/// Rows in the file's order. Each pixel is an index or, if the packing is runs_of_24, blue, green
/// and red; it is 0 if nothing is written to it. Returns nothing if the file ends before the
/// picture. O(pixels + bytes).
[[nodiscard]] std::optional<std::vector<std::uint8_t>> unpacked_runs(Bytes packed,
                                                                     const BmpHeader& header);

}  // namespace touchline::decode
