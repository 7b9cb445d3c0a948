// PNG, row by row. Uses the lower of libpng's two interfaces, because the simpler one holds the
// whole picture.
#include "app/documents/decode/readers.h"
#include "config/types/pinned.h"

#include <array>
#include <csetjmp>
#include <cstring>
#include <utility>

#include <png.h>

namespace touchline::decode {
namespace {

/// libpng reports an error by a call that must not return, so the call jumps out of the library.
struct PngSource {
    Bytes left;
    std::jmp_buf way_out;
    std::array<char, 200> message;
};

[[noreturn]] void leave(png_structp reader, png_const_charp message) {
    auto& source = *static_cast<PngSource*>(png_get_error_ptr(reader));
    std::strncpy(source.message.data(), message, source.message.size() - 1);
    std::longjmp(source.way_out, 1);  // NOLINT(cert-err52-cpp): libpng's interface
}

void drop_warning(png_structp /*reader*/, png_const_charp /*message*/) {}

void read_some(png_structp reader, png_bytep to, std::size_t wanted) {
    auto& source = *static_cast<PngSource*>(png_get_io_ptr(reader));
    if (wanted > source.left.size()) png_error(reader, "the file ends before the picture");
    std::memcpy(to, source.left.data(), wanted);
    source.left = source.left.subspan(wanted);
}

/// Runs one step of the reader; false if libpng gave up in it. The jump ends here, so neither this
/// function nor a step may hold an object with a destructor.
template <class Step>
bool run(PngSource& source, const Step& step) {
    if (setjmp(source.way_out) != 0) return false;  // NOLINT(cert-err52-cpp): libpng's interface
    step();
    return true;
}

class Reader : private Pinned {
  public:
    explicit Reader(Bytes bytes)
        : source{bytes, {}, {}},
          png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, leave, drop_warning)),
          info(png != nullptr ? png_create_info_struct(png) : nullptr) {
        if (info == nullptr) {
            png_destroy_read_struct(&png, nullptr, nullptr);
            throw std::bad_alloc();
        }
    }

    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }

    /// Reads up to the pixels, which will come as blue, green, red and perhaps alpha, of 8 bits.
    void open() {
        png_set_read_fn(png, &source, read_some);
        png_set_benign_errors(png, 1);
        png_read_info(png, info);
        png_set_expand(png);
        png_set_scale_16(png);
        png_set_gray_to_rgb(png);
        png_set_bgr(png);
        // If the file states no gamma, 16 bits do not mean linear light.
        png_set_alpha_mode(png, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);
        png_read_update_info(png, info);
    }

    PngSource source;
    png_structp png;
    png_infop info;
};

/// Adam7: seven passes, each over some of the columns and rows.
struct Pass {
    Columns columns;
    std::size_t first_row;
    std::size_t row_step;
};

constexpr std::array<Pass, 7> interlaced{{{{0, 8}, 0, 8},
                                          {{4, 8}, 0, 8},
                                          {{0, 4}, 4, 8},
                                          {{2, 4}, 0, 4},
                                          {{0, 2}, 2, 4},
                                          {{1, 2}, 0, 2},
                                          {{0, 1}, 1, 2}}};
constexpr std::array<Pass, 1> plain{{{{0, 1}, 0, 1}}};

/// Gives all rows in the file's order. A pass without pixels has none.
void read_rows(const Reader& reader, std::span<const Pass> passes, std::span<std::uint8_t> row,
               Shrinking& shrinking) {
    const std::size_t width = png_get_image_width(reader.png, reader.info);
    const std::size_t height = png_get_image_height(reader.png, reader.info);
    const std::size_t channels = png_get_channels(reader.png, reader.info);
    for (const Pass& pass : passes) {
        const Columns& columns = pass.columns;
        if (columns.first >= width) continue;
        const std::size_t count = (width - columns.first + columns.step - 1) / columns.step;
        for (std::size_t y = pass.first_row; y < height; y += pass.row_step) {
            png_read_row(reader.png, row.data(), nullptr);
            shrinking.add_row(y, row.first(channels * count), columns);
        }
    }
}

/// The resolution in pHYs. Only the ratio counts, not the unit.
Resolution resolution_of(const Reader& reader) {
    png_uint_32 across = 0;
    png_uint_32 down = 0;
    int unit = 0;
    png_get_pHYs(reader.png, reader.info, &across, &down, &unit);
    return {static_cast<double>(across), static_cast<double>(down)};
}

std::uint32_t big_endian_32(Bytes bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8U | std::to_integer<std::uint32_t>(bytes[offset + i]);
    return value;
}

}  // namespace

Result<Stored> read_png(Bytes bytes) {
    constexpr std::size_t header_end = 24;  // signature 8, IHDR's length and name 8, two sides 8
    if (bytes.size() < header_end) return damaged("PNG", "the header is missing");
    // Checked here because libpng calls a large header merely invalid.
    if (auto fits = check_file_size("PNG", big_endian_32(bytes, 16), big_endian_32(bytes, 20));
        !fits)
        return tl::unexpected(fits.error());

    Reader reader(bytes);
    const auto given_up = [&reader] { return damaged("PNG", reader.source.message.data()); };
    if (!run(reader.source, [&reader] { reader.open(); })) return given_up();
    Shrinking shrinking(png_get_image_width(reader.png, reader.info),
                        png_get_image_height(reader.png, reader.info),
                        png_get_channels(reader.png, reader.info));
    std::vector<std::uint8_t> row(png_get_rowbytes(reader.png, reader.info));
    const bool is_plain = png_get_interlace_type(reader.png, reader.info) == PNG_INTERLACE_NONE;
    const std::span<const Pass> passes = is_plain ? std::span<const Pass>(plain) : interlaced;
    if (!run(reader.source, [&] { read_rows(reader, passes, row, shrinking); })) return given_up();
    return Stored{std::move(shrinking).picture(), resolution_of(reader)};
}

}  // namespace touchline::decode
