// TIFF. libtiff reads rows or tiles; this file interprets them, because libtiff's own pictures
// allow only whole numbers of 1 to 8 and 16 bits. A few kinds that only libtiff knows are left to
// it.
#include "app/documents/decode/readers.h"
#include "app/documents/decode/tiff.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <utility>

namespace touchline::decode {
namespace {

int drop_warning(TIFF* /*tiff*/, void* /*user*/, const char* /*module*/, const char* /*format*/,
                 std::va_list /*arguments*/) {
    return 1;
}

void choose_directory(TIFF* tiff) {
    constexpr int most_directories = 100;
    for (int i = 0; i < most_directories; ++i) {
        std::uint32_t type = 0;
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SUBFILETYPE, &type);
        if ((type & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) == 0) return;
        if (TIFFReadDirectory(tiff) == 0) break;
    }
    TIFFSetDirectory(tiff, 0);
}

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

tmsize_t TiffFile::read_some(thandle_t handle, void* to, tmsize_t wanted) {
    auto& source = *static_cast<Source*>(handle);
    if (wanted <= 0 || source.offset >= source.bytes.size()) return 0;
    const std::size_t count =
        std::min(static_cast<std::size_t>(wanted), source.bytes.size() - source.offset);
    std::memcpy(to, source.bytes.data() + source.offset, count);
    source.offset += count;
    return static_cast<tmsize_t>(count);
}

toff_t TiffFile::seek(thandle_t handle, toff_t offset, int from) {
    auto& source = *static_cast<Source*>(handle);
    if (from == SEEK_CUR) offset += source.offset;
    if (from == SEEK_END) offset += source.bytes.size();
    source.offset = static_cast<std::size_t>(offset);
    return offset;
}

[[gnu::format(printf, 4, 0)]] int TiffFile::keep_first_error(TIFF* /*tiff*/, void* user,
                                                             const char* /*module*/,
                                                             const char* format,
                                                             std::va_list arguments) {
    std::string& error = static_cast<Source*>(user)->error;
    if (error.empty()) {
        std::array<char, 256> text{};
        const int length = std::vsnprintf(text.data(), text.size(), format, arguments);
        error = length > 0 ? text.data() : "libtiff gives no reason";
    }
    return 1;  // handled: nothing goes to the process-wide handler or stderr
}

Result<TiffFile> TiffFile::opened(Bytes bytes) {
    TiffFile file;
    file.source_ = std::make_unique<Source>(Source{bytes, 0, {}});
    const Owned<TIFFOpenOptions, TIFFOpenOptionsFree> options(TIFFOpenOptionsAlloc());
    if (options == nullptr) throw std::bad_alloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(max_library_bytes));
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_first_error, file.source_.get());
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), drop_warning, nullptr);
    // The file is in memory, so libtiff need not copy what it unpacks.
    const auto map = [](thandle_t handle, void** base, toff_t* size) {
        const Bytes all = static_cast<Source*>(handle)->bytes;
        *base = const_cast<std::byte*>(all.data());  // NOLINT: libtiff only reads it
        *size = all.size();
        return 1;
    };
    const auto refuse_write = [](thandle_t, void*, tmsize_t) { return tmsize_t{0}; };
    const auto close_nothing = [](thandle_t) { return 0; };
    const auto unmap_nothing = [](thandle_t, void*, toff_t) {};
    const auto size_of = [](thandle_t handle) {
        return static_cast<toff_t>(static_cast<Source*>(handle)->bytes.size());
    };
    file.tiff_.reset(TIFFClientOpenExt("picture", "r", file.source_.get(), read_some, refuse_write,
                                       seek, close_nothing, size_of, map, unmap_nothing,
                                       options.get()));
    if (file.tiff_ == nullptr) return file.broken();
    return file;
}

Result<TiffFile> TiffFile::open(Bytes bytes) {
    auto file = opened(bytes);
    if (file) choose_directory(file->get());
    return file;
}

Result<TiffFile> TiffFile::again() const {
    auto file = opened(source_->bytes);
    if (file && TIFFSetSubDirectory(file->get(), TIFFCurrentDirOffset(get())) == 0)
        return file->broken();
    return file;
}

std::uint32_t TiffFile::number(std::uint32_t tag) const {
    const TIFFField* const field = TIFFFindField(get(), tag, TIFF_ANY);
    const bool is_short = field != nullptr && TIFFFieldDataType(field) == TIFF_SHORT;
    std::uint32_t wide = 0;
    std::uint16_t narrow = 0;
    const int is_there = is_short ? TIFFGetFieldDefaulted(get(), tag, &narrow)
                                  : TIFFGetFieldDefaulted(get(), tag, &wide);
    if (is_there == 0) return 0;
    return is_short ? narrow : wide;
}

tl::unexpected<Error> TiffFile::broken() const {
    return damaged("TIFF", source_->error);
}

Result<void> TiffFile::read(const std::vector<std::uint16_t>& planes,
                            const TakeStretch& take) const {
    const std::vector<std::uint16_t> one{0};
    const auto& wanted = is_planar() ? planes : one;
    return TIFFIsTiled(get()) != 0 ? read_tiles(wanted, take) : read_rows(wanted, take);
}

/// Opens a handle for each further plane: a strip is unpacked from its beginning, and one may hold
/// the whole plane.
Result<void> TiffFile::read_rows(const std::vector<std::uint16_t>& planes,
                                 const TakeStretch& take) const {
    std::vector<TiffFile> others;
    for (std::size_t i = 1; i < planes.size(); ++i) {
        auto other = again();
        if (!other) return tl::unexpected(other.error());
        others.push_back(std::move(*other));
    }
    const std::size_t row_bytes = TIFFScanlineSize64(get());
    if (row_bytes == 0 || row_bytes > max_library_bytes) return broken();
    std::vector<std::byte> row(row_bytes * planes.size());
    Stretch stretch;
    stretch.count = number(TIFFTAG_IMAGEWIDTH);
    for (std::size_t i = 0; i < planes.size(); ++i)
        stretch.planes.push_back(std::span(row).subspan(i * row_bytes, row_bytes));
    const std::uint32_t height = number(TIFFTAG_IMAGELENGTH);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const TiffFile& file = i == 0 ? *this : others[i - 1];
            if (TIFFReadScanline(file.get(), &row[i * row_bytes], y, planes[i]) < 0)
                return file.broken();
        }
        stretch.y = y;
        take(stretch);
    }
    return {};
}

Result<void> TiffFile::read_tiles(const std::vector<std::uint16_t>& planes,
                                  const TakeStretch& take) const {
    const std::uint32_t width = number(TIFFTAG_IMAGEWIDTH);
    const std::uint32_t height = number(TIFFTAG_IMAGELENGTH);
    const std::uint32_t tile_width = number(TIFFTAG_TILEWIDTH);
    const std::uint32_t tile_height = number(TIFFTAG_TILELENGTH);
    const std::size_t row_bytes = TIFFTileRowSize64(get());
    const std::size_t tile_bytes = TIFFTileSize64(get());
    if (tile_width == 0 || tile_height == 0 || row_bytes == 0 || tile_bytes > max_library_bytes ||
        tile_bytes / tile_height < row_bytes)
        return broken();
    std::vector<std::byte> tile(tile_bytes * planes.size());
    Stretch stretch;
    stretch.planes.resize(planes.size());
    for (std::uint32_t top = 0; top < height; top += tile_height) {
        for (std::uint32_t left = 0; left < width; left += tile_width) {
            for (std::size_t i = 0; i < planes.size(); ++i)
                if (TIFFReadTile(get(), &tile[i * tile_bytes], left, top, 0, planes[i]) < 0)
                    return broken();
            stretch.x = left;
            stretch.count = std::min(tile_width, width - left);
            for (std::uint32_t y = 0; y < std::min(tile_height, height - top); ++y) {
                for (std::size_t i = 0; i < planes.size(); ++i)
                    stretch.planes[i] =
                        std::span(tile).subspan(i * tile_bytes + y * row_bytes, row_bytes);
                stretch.y = top + y;
                take(stretch);
            }
        }
    }
    return {};
}

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
