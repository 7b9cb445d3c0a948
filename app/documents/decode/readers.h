// Private to app/documents/decode: one reader per format, and what they share. Every reader may
// throw std::bad_alloc; without_exceptions() catches it. Threads: pure functions; one Shrinking,
// one thread.
#pragma once

#include "app/documents/decode/file_format.h"
#include "app/documents/decode/page.h"
#include "app/documents/decode/picture.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline::decode {

using Bytes = std::span<const std::byte>;

/// The most memory that libjpeg and libtiff may each take beside the pixels.
constexpr std::uint64_t max_library_bytes = std::uint64_t{512} << 20U;

/// Pixels per equal length, across and down; 0: the file does not say.
struct Resolution {
    double across = 0.0;
    double down = 0.0;
};

/// Pixels in the file's order, and what the format says about showing them.
struct Stored {
    Picture picture;
    Resolution resolution{};
    int orientation = 0;  // an EXIF number, 1 ... 8; 0: the file's EXIF tells it
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

/// Checks a picture's size, before anything is allocated. Fails beyond the limits of picture.h:
/// "the FORMAT picture has W x H pixels, more than ...; save it smaller".
[[nodiscard]] Result<void> check_size(std::string_view format, std::int64_t width,
                                      std::int64_t height);

/// The same for a file whose picture may be made smaller (Shrinking).
[[nodiscard]] Result<void> check_file_size(std::string_view format, std::int64_t width,
                                           std::int64_t height,
                                           std::uint64_t most_pixels = max_file_pixels);

/// "the FORMAT picture is cut short or damaged (DETAIL); ...", for an error that a library reports.
[[nodiscard]] tl::unexpected<Error> damaged(std::string_view format, std::string_view detail);

/// The same for a file that ends before its picture does.
[[nodiscard]] inline tl::unexpected<Error> cut_short(std::string_view format) {
    return damaged(format, "the file ends before the picture");
}

/// What to do with a file of none of the formats.
[[nodiscard]] tl::unexpected<Error> not_a_picture(FileFormat format);

/// Returns what `read` returns. Fails with one line if it throws, or if there are no bytes.
[[nodiscard]] Result<Page> without_exceptions(Result<Page> (*read)(Bytes bytes,
                                                                   const PageOrder& order),
                                              Bytes bytes, const PageOrder& order);

/// A box in any unit, y downwards.
struct TextBox {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;
};

[[nodiscard]] constexpr TextBox around(const TextBox& a, const TextBox& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

/// Returns whether two boxes (left, top, right, bottom) have points in common.
template <class Box>
[[nodiscard]] constexpr bool meet(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// Metres of a page's `told` map per pixel of its picture. Any page then has an area below a metre.
constexpr double told_m_per_px = 1e-4;

/// The area of `told` for a picture of this size.
[[nodiscard]] Area told_area(const Picture& picture);

/// The place in `told` of a point in pixels from the upper left corner.
[[nodiscard]] Position told_place(const Picture& picture, double x_px, double y_px);

/// The pixels of a picture that a box touches; nothing if it touches none.
[[nodiscard]] std::optional<WordBox> pixels_within(const TextBox& box_px, const Picture& picture);

/// How bright the eye sees a pixel, 0 ... 255.
[[nodiscard]] inline int lightness_of(const std::uint8_t* bgr) {
    return (29 * bgr[0] + 150 * bgr[1] + 77 * bgr[2]) / 256;
}

/// Turns four bytes per pixel (blue, green, red, straight alpha) into three, in place, over the
/// background that shows them: white, or black if almost everything painted is white itself.
void compose(std::vector<std::uint8_t>& bgra);

/// Turns a pixel whose colours were multiplied by its alpha back to straight alpha.
void unmultiply(std::uint8_t* bgra);

/// Makes the pixels square. Changes nothing if they are square, if the resolution is unknown (0,
/// NaN), or if it is beyond belief. O(pixels).
[[nodiscard]] Picture with_square_pixels(Picture picture, const Resolution& resolution);

/// Turns the picture upright by the orientation of EXIF and TIFF (1 ... 8; anything else changes
/// nothing).
[[nodiscard]] Picture upright(Picture picture, int orientation);

using PixelReader = Result<Stored> (*)(Bytes bytes);

/// The picture of a file of pixels, upright, with square pixels, in sRGB, and what the file says
/// about it. Fails as the reader does, or for a page other than 1.
[[nodiscard]] Result<Page> page_by(PixelReader read, Bytes bytes, const PageOrder& order);

/// True for texts such as "OLYMPUS DIGITAL CAMERA", "oznor", "filter: 0; jpegRotation: 0;",
/// "Created with Sketch.", "untitled", "Microsoft Word - Doc1.docx", "Slice 1". Nobody is told
/// them, because a file's own name says more. O(text).
[[nodiscard]] bool is_of_a_machine(std::string_view text);

/// The text; empty if a machine wrote it.
[[nodiscard]] inline std::string of_a_person(std::string text) {
    return is_of_a_machine(text) ? std::string() : text;
}

/// Pictures with too many pixels are made smaller while they are read. Pixels of the file per kept
/// pixel, along each side: 1, 2, 4 or 8. Sides from 1 to
/// max_file_side_px.
[[nodiscard]] unsigned reduction_for(std::uint64_t width, std::uint64_t height);

/// The kept length of a file's side. The last pixel may stand for fewer pixels than the others.
[[nodiscard]] constexpr std::uint64_t reduced_side(std::uint64_t side, unsigned reduction) {
    return (side + reduction - 1) / reduction;
}

/// The columns of a stretch of pixels in its row: every `step`th from `first`.
struct Columns {
    std::size_t first = 0;
    std::size_t step = 1;
};

/// Takes rows of the file in any order, and never holds all of them at once: each kept pixel is the
/// mean of a square of the file's pixels.
class Shrinking {
  public:
    /// Three channels (blue, green, red), or four with straight alpha. Sides within
    /// check_file_size(). Throws std::bad_alloc.
    Shrinking(std::size_t width, std::size_t height, std::size_t channels);

    /// Adds pixels of the row `y`, each given once. Leaves out those beyond the right side.
    void add_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns = {});

    /// The picture, over the background that shows it if there is alpha. Pixels that were not given
    /// are black or, with alpha, clear.
    [[nodiscard]] Picture picture() &&;

  private:
    template <std::size_t channels>
    void sum_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns);
    void keep_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns);
    [[nodiscard]] unsigned pixels_in(std::size_t x, std::size_t y) const;
    void take_means();

    std::size_t width_;
    std::size_t height_;
    std::size_t channels_;
    unsigned by_;
    unsigned shift_;  // by_ is 1 << shift_
    Picture picture_;
    std::vector<std::uint16_t> sums_;  // over at most 64 pixels; colours weighted with their alpha
};

}  // namespace touchline::decode
