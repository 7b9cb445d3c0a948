// Private to app/decode: one reader per format, and what they share. Every reader may throw
// std::bad_alloc; decode_picture catches it.
#pragma once

#include "app/decode/picture.h"

#include <cstdint>
#include <string_view>

namespace touchline::decode {

using Bytes = std::span<const std::byte>;

Result<Picture> read_png(Bytes bytes);
Result<Picture> read_jpeg(Bytes bytes);
Result<Picture> read_webp(Bytes bytes);
Result<Picture> read_tiff(Bytes bytes);
Result<Picture> read_svg(Bytes bytes);

/// What libraries would tell a terminal is told nobody.
void silence_libraries();

/// Within max_picture_pixels, and width x height x bytes_per_pixel within max_picture_bytes?
[[nodiscard]] Result<void> check_size(std::string_view format, std::uint64_t width,
                                      std::uint64_t height, std::uint64_t bytes_per_pixel);

/// "the FORMAT picture is cut short or damaged (DETAIL); ...", for what a library reports.
[[nodiscard]] tl::unexpected<Error> damaged(std::string_view format, std::string_view detail);

/// Four bytes a pixel (blue, green, red, straight alpha) become three, over white, in place.
void compose_over_white(std::vector<std::uint8_t>& bgra);

/// The picture upright, from the orientation that EXIF and TIFF share (1 ... 8; else as it is).
[[nodiscard]] Picture upright(Picture picture, int orientation);

/// The orientation in an APP1 segment of a JPEG, 1 where there is none.
[[nodiscard]] int exif_orientation(Bytes app1);

}  // namespace touchline::decode
