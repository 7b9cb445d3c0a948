// Pictures in memory from the formats that visitors bring: PNG, JPEG, WebP, TIFF and SVG, through
// libpng, libjpeg-turbo, libwebp, libtiff and librsvg. Bytes in, a plain value out, so that exactly
// this code can move into a sandboxed worker. Threads: any; no state is kept.
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace touchline {

/// 8-bit BGR, rows from the top, tightly packed: the pixel (x, y) starts at 3 (y width + x).
struct Picture {
    int width = 0;   // >= 1 in every decoded picture
    int height = 0;  // >= 1
    std::vector<std::uint8_t> bgr;
    double scale = 1.0;  // pixels here per pixel of the file; < 1: a large JPEG, decoded smaller
};

/// A header that claims more is refused before anything is allocated for it.
constexpr std::uint64_t max_picture_pixels = 100'000'000;

/// The pixel buffer of a decoder, and what libjpeg and libtiff may take beside it, each.
constexpr std::uint64_t max_picture_bytes = std::uint64_t{256} << 20U;

/// A JPEG with more pixels is decoded at 1/2, 1/4 or 1/8 of its size: outlines for touch need one
/// megapixel, and the reduced transform costs less time and memory.
constexpr std::uint64_t max_full_jpeg_pixels = 24'000'000;

/// An SVG read as a picture is drawn with its longer side this many pixels long.
constexpr int svg_longer_side_px = 1600;

/// The picture in these bytes; the format is told by the first bytes, never by a name. Transparency
/// lies over white, 16 bits become 8, grey, palettes and CMYK become BGR, an orientation in EXIF or
/// TIFF is applied, a TIFF gives its first page. Fails with one line for anything empty, unknown,
/// animated, cut short, damaged or too large. O(bytes + pixels).
[[nodiscard]] Result<Picture> decode_picture(std::span<const std::byte> bytes);

/// read_file and decode_picture; errors start with the path.
[[nodiscard]] Result<Picture> read_picture(const std::string& path);

}  // namespace touchline
