// Private to app/decode: one reader per format, and what they share. Every reader may throw
// std::bad_alloc; without_exceptions() catches it.
#pragma once

#include "app/decode/page.h"
#include "app/decode/page_order.h"
#include "app/decode/signature.h"
#include "app/decode/text_line.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace touchline::decode {

using Bytes = std::span<const std::byte>;

/// What libjpeg and libtiff may take beside the pixels, each.
constexpr std::uint64_t max_library_bytes = std::uint64_t{512} << 20U;

/// Pixels on the same length, across and down; 0: the file does not say.
struct Resolution {
    double across = 0.0;
    double down = 0.0;
};

/// Pixels in the order in which the file has them, and what its format says of how they are meant.
struct Stored {
    Picture picture;
    Resolution resolution{};
    int orientation = 0;  // as EXIF numbers them, 1 ... 8; 0: what the file's EXIF says
};

Result<Stored> read_png(Bytes bytes);
Result<Stored> read_jpeg(Bytes bytes);
Result<Stored> read_webp(Bytes bytes);
Result<Stored> read_tiff(Bytes bytes);
Result<Stored> read_gif(Bytes bytes);
Result<Stored> read_bmp(Bytes bytes);
Result<Stored> read_pnm(Bytes bytes);
Result<Page> read_svg(Bytes bytes, const PageOrder& order);
Result<Page> read_pdf(Bytes bytes, const PageOrder& order);

/// A picture of this size; fails beyond the limits of picture.h, before anything is allocated.
[[nodiscard]] Result<void> check_size(std::string_view format, std::uint64_t width,
                                      std::uint64_t height);

/// A file of this size, whose picture may be made smaller (shrinking.h); fails likewise: "the
/// FORMAT picture has W x H pixels, more than ...; save it smaller".
[[nodiscard]] Result<void> check_file_size(std::string_view format, std::uint64_t width,
                                           std::uint64_t height,
                                           std::uint64_t most_pixels = max_file_pixels);

/// "the FORMAT picture is cut short or damaged (DETAIL); ...", for what a library reports.
[[nodiscard]] tl::unexpected<Error> damaged(std::string_view format, std::string_view detail);

/// What to do with a file that is none of the formats.
[[nodiscard]] tl::unexpected<Error> not_a_picture(FileFormat format);

/// What `read` gives; a line where it throws, or where there are no bytes.
[[nodiscard]] Result<Page> without_exceptions(Result<Page> (*read)(Bytes bytes,
                                                                   const PageOrder& order),
                                              Bytes bytes, const PageOrder& order);

/// Metres of a page's `told` map a pixel of its picture: any page then has an area below a metre.
constexpr double told_m_per_px = 1e-4;

/// The area of `told` for a picture of this size.
[[nodiscard]] Area told_area(const Picture& picture);

/// A place in pixels from the upper left corner, in `told`.
[[nodiscard]] Position told_place(const Picture& picture, double x_px, double y_px);

/// The pixels of a picture that a box touches; nothing where there are none.
[[nodiscard]] std::optional<WordBox> pixels_within(const TextBox& box_px, const Picture& picture);

/// Four bytes a pixel (blue, green, red, straight alpha) become three, in place, over the ground
/// that shows them: white, or black where next to all that is painted is white itself.
void compose(std::vector<std::uint8_t>& bgra);

/// One pixel whose colours were multiplied by its alpha, back to straight alpha.
void unmultiply(std::uint8_t* bgra);

/// The picture with square pixels; as it is where they are, where that is not known (0, NaN) or
/// beyond belief. O(pixels).
[[nodiscard]] Picture with_square_pixels(Picture picture, const Resolution& resolution);

/// The picture upright, from the orientation that EXIF and TIFF share (1 ... 8; else as it is).
[[nodiscard]] Picture upright(Picture picture, int orientation);

}  // namespace touchline::decode
