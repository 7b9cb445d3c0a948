// TIFF. libtiff reads rows or tiles; this file interprets them, because libtiff's own pictures
// allow only whole numbers of 1 to 8 and 16 bits. A few kinds that only libtiff knows are left to
// it.
#include "app/decode/shrinking.h"
#include "app/decode/tiff_colours.h"
#include "app/decode/tiff_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace touchline::decode {
namespace {

/// True for fewer colour than brightness samples, logarithms of light, and codecs without rows.
bool is_libtiffs_own(const TiffFile& file) {
    const auto compression = file.number(TIFFTAG_COMPRESSION);
    switch (file.number(TIFFTAG_PHOTOMETRIC)) {
        case PHOTOMETRIC_YCBCR:
            return compression != COMPRESSION_JPEG || file.is_planar();
        case PHOTOMETRIC_LOGL:
        case PHOTOMETRIC_LOGLUV:
            return true;
        default:
            return compression == COMPRESSION_JBIG || compression == COMPRESSION_OJPEG;
    }
}

/// libtiff packs a pixel into one number, red lowest, colours multiplied by alpha.
void unpack_pixels(std::span<const std::uint32_t> packed, std::span<std::uint8_t> bgra) {
    std::uint8_t* to = bgra.data();
    for (const std::uint32_t pixel : packed) {
        const std::array parts{TIFFGetB(pixel), TIFFGetG(pixel), TIFFGetR(pixel), TIFFGetA(pixel)};
        std::ranges::transform(
            parts, to, [](std::uint32_t value) { return static_cast<std::uint8_t>(value); });
        unmultiply(to);
        to += 4;
    }
}

/// Reads a strip or a tile at a time, each with its last row first.
Result<Picture> read_by_libtiff(const TiffFile& file, std::uint32_t width, std::uint32_t height) {
    TIFF* const tiff = file.get();
    std::array<char, 1024> reason{};
    if (TIFFRGBAImageOK(tiff, reason.data()) == 0) return damaged("TIFF", reason.data());
    TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);  // stored order
    const bool is_tiled = TIFFIsTiled(tiff) != 0;
    const std::uint32_t across = is_tiled ? file.number(TIFFTAG_TILEWIDTH) : width;
    const std::uint32_t down =
        is_tiled ? file.number(TIFFTAG_TILELENGTH)
                 : std::min(std::max(file.number(TIFFTAG_ROWSPERSTRIP), 1U), height);
    if (across == 0 || down == 0 || std::uint64_t{4} * across * down > max_library_bytes)
        return failure("the TIFF picture is stored in one piece that is too large; save it as PNG");
    std::vector<std::uint32_t> packed(std::size_t{across} * down);
    std::vector<std::uint8_t> bgra(std::size_t{4} * across);
    Shrinking shrinking(width, height, 4);
    const int stop_on_error = 1;
    for (std::uint32_t top = 0; top < height; top += down) {
        for (std::uint32_t left = 0; left < width; left += across) {
            const int is_read =
                is_tiled ? TIFFReadRGBATileExt(tiff, left, top, packed.data(), stop_on_error)
                         : TIFFReadRGBAStripExt(tiff, top, packed.data(), stop_on_error);
            if (is_read == 0) return file.broken();
            const std::uint32_t rows = std::min(down, height - top);
            const std::uint32_t last = is_tiled ? down - 1 : rows - 1;
            for (std::uint32_t y = 0; y < rows; ++y) {
                unpack_pixels(std::span(packed).subspan(std::size_t{last - y} * across, across),
                              bgra);
                shrinking.add_row(top + y, bgra, {left, 1});
            }
        }
    }
    return std::move(shrinking).picture();
}

/// The range of the file's numbers if they may be measurements; it takes a first pass over them.
Result<Range> range_of(const TiffFile& file, const TiffForm& form) {
    const bool is_fixed = form.samples.kind == NumberKind::whole && form.samples.bits <= 8;
    const bool is_light = form.colours == TiffColours::grey || form.colours == TiffColours::rgb ||
                          form.colours == TiffColours::white_is_zero;
    if (is_fixed || !is_light) return own_range(form.samples);
    const auto looked_at = file.again();
    if (!looked_at) return tl::unexpected(looked_at.error());
    TiffPixels pixels(form, {});
    Seen seen;
    const auto done = looked_at->read(pixels.planes(),
                                      [&](const Stretch& stretch) { pixels.look(stretch, seen); });
    if (!done) return tl::unexpected(done.error());
    return seen.range(form.samples);
}

Result<Picture> read_by_rows(const TiffFile& file, std::uint32_t width, std::uint32_t height) {
    if (file.number(TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_YCBCR)
        TIFFSetField(file.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    const auto form = form_of(file);
    if (!form) return tl::unexpected(form.error());
    const auto range = range_of(file, *form);
    if (!range) return tl::unexpected(range.error());
    TiffPixels pixels(*form, *range);
    Shrinking shrinking(width, height, pixels.channels());
    const auto done = file.read(pixels.planes(), [&](const Stretch& stretch) {
        shrinking.add_row(stretch.y, pixels.pixels_of(stretch), {stretch.x, 1});
    });
    if (!done) return tl::unexpected(done.error());
    return std::move(shrinking).picture();
}

/// Pixels per length, in any unit; 0 if the file does not say.
Resolution resolution_of(const TiffFile& file) {
    float across = 0.0F;
    float down = 0.0F;
    TIFFGetField(file.get(), TIFFTAG_XRESOLUTION, &across);
    TIFFGetField(file.get(), TIFFTAG_YRESOLUTION, &down);
    return {static_cast<double>(across), static_cast<double>(down)};
}

}  // namespace

Result<Stored> read_tiff(Bytes bytes) {
    const auto file = TiffFile::open(bytes);
    if (!file) return tl::unexpected(file.error());
    const std::uint32_t width = file->number(TIFFTAG_IMAGEWIDTH);
    const std::uint32_t height = file->number(TIFFTAG_IMAGELENGTH);
    if (auto fits = check_file_size("TIFF", width, height); !fits)
        return tl::unexpected(fits.error());
    const auto orientation = static_cast<int>(file->number(TIFFTAG_ORIENTATION));
    auto picture = is_libtiffs_own(*file) ? read_by_libtiff(*file, width, height)
                                          : read_by_rows(*file, width, height);
    if (!picture) return tl::unexpected(picture.error());
    return Stored{std::move(*picture), resolution_of(*file), orientation};
}

}  // namespace touchline::decode
