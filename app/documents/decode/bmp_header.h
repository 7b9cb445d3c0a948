// Private to app/documents/decode: everything before the pixels of a BMP, in all forms since OS/2.
// Threads: pure functions.
#pragma once

#include "app/documents/decode/readers.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace touchline::decode {

/// The size of the file header, which precedes the picture's header.
inline constexpr std::size_t file_header_bytes = 14;

enum class BmpPacking : std::uint8_t { none, runs_of_4, runs_of_8, runs_of_24, fields };

struct BmpHeader {
    int width = 0;   // within check_file_size()
    int height = 0;  // the same
    bool is_top_down = false;
    int bits = 0;  // per pixel: 1, 4, 8, 16, 24, 32
    BmpPacking packing = BmpPacking::none;
    std::size_t pixels_at = 0;                         // offset in the file
    std::vector<std::array<std::uint8_t, 3>> palette;  // blue, green, red
    std::array<std::uint32_t, 4> fields{};             // blue, green, red, alpha
    std::size_t end = 0;                               // the end of the header and its palette
    Resolution resolution{};
};

/// Reads a number of 2 or 4 bytes, lowest first; 0 beyond the end.
[[nodiscard]] std::uint32_t little_endian(Bytes bytes, std::size_t at, std::size_t count);

/// Reads the file header at `at` and what follows it. Fails with one line if it is no header, or is
/// beyond the limits. O(palette).
[[nodiscard]] Result<BmpHeader> read_bmp_header(Bytes bytes, std::size_t at);

}  // namespace touchline::decode
