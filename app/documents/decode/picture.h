// A picture in memory, the limits of its size, and as a file.
// Threads: a value; any thread may read and write files.
#pragma once

#include "config/types/result.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// 8-bit BGR, rows from the top, tightly packed: the pixel (x, y) starts at 3 (y width + x).
struct Picture {
    int width = 0;   // >= 1 in every decoded picture
    int height = 0;  // >= 1
    std::vector<std::uint8_t> bgr;
    double scale = 1.0;  // pixels here per pixel of the file; < 1: a large one, made smaller
};

/// One byte per pixel, rows from the top; without pixels there is no picture.
struct GreyPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> grey;
};

/// The bytes as samples, copied. O(bytes).
[[nodiscard]] inline std::vector<std::uint8_t> samples_of(std::span<const std::byte> bytes) {
    const auto* const first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    return {first, first + bytes.size()};
}

/// A header that claims more is refused before anything is allocated.
constexpr std::uint64_t max_picture_pixels = std::uint64_t{40} << 20U;
constexpr std::uint64_t max_picture_side_px = 10'000;

/// True if the size is within these two limits, with at least one pixel.
[[nodiscard]] constexpr bool fits_a_picture(std::integral auto width, std::integral auto height) {
    const auto is_side = [](auto side) {
        return std::cmp_greater(side, 0) && std::cmp_less_equal(side, max_picture_side_px);
    };
    return is_side(width) && is_side(height) &&
           static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) <=
               max_picture_pixels;
}

/// A file may have more pixels: reading makes them fewer. A JPEG may have the most, because its
/// codec saves the most work that way.
constexpr std::uint64_t max_file_pixels = 120'000'000;
constexpr std::uint64_t max_jpeg_pixels = 200'000'000;
constexpr std::uint64_t max_file_side_px = 8 * max_picture_side_px;

/// A picture of a file with more pixels is kept at 1/2, 1/4 or 1/8 of its sides; outlines for touch
/// need one megapixel.
constexpr std::uint64_t max_full_pixels = 24'000'000;

/// An SVG read as a picture is drawn with its longer side this many pixels long.
constexpr int svg_longer_side_px = 1600;

/// The first page of a file as a picture, opened by a worker (opening.h). Errors start with the
/// path.
[[nodiscard]] Result<Picture> read_picture(const std::string& path);

/// Pictures that the program makes (edge strength, tours, screenshots) are written as PNG. This is
/// a view of an 8-bit grey one, rows from the top, tightly packed.
struct GreyView {
    int width = 0;
    int height = 0;
    std::span<const std::uint8_t> pixels;  // width x height
};

/// Writes the file whole or not at all (app/documents/decode/files.h). Fails if the pixels do not
/// fill width x height >= 1, or the file cannot be written. O(pixels).
[[nodiscard]] Result<void> write_png(const std::string& path, const Picture& picture);
[[nodiscard]] Result<void> write_png(const std::string& path, const GreyView& picture);

}  // namespace touchline
