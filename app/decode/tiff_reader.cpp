#include "app/decode/formats.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>

#include <tiffio.h>

namespace touchline::decode {
namespace {

/// What libtiff reads from, and the first error it told.
struct Source {
    Bytes bytes;
    std::size_t offset = 0;
    std::string error;
};

Source& source_of(thandle_t handle) {
    return *static_cast<Source*>(handle);
}

tmsize_t read_some(thandle_t handle, void* to, tmsize_t wanted) {
    Source& source = source_of(handle);
    if (wanted <= 0 || source.offset >= source.bytes.size()) return 0;
    const std::size_t count =
        std::min(static_cast<std::size_t>(wanted), source.bytes.size() - source.offset);
    std::memcpy(to, source.bytes.data() + source.offset, count);
    source.offset += count;
    return static_cast<tmsize_t>(count);
}

tmsize_t refuse_write(thandle_t /*handle*/, void* /*from*/, tmsize_t /*size*/) {
    return 0;
}

toff_t seek(thandle_t handle, toff_t offset, int from) {
    Source& source = source_of(handle);
    if (from == SEEK_CUR) offset += source.offset;
    if (from == SEEK_END) offset += source.bytes.size();
    source.offset = static_cast<std::size_t>(offset);
    return offset;
}

int close_nothing(thandle_t /*handle*/) {
    return 0;
}

toff_t size_of(thandle_t handle) {
    return source_of(handle).bytes.size();
}

[[gnu::format(printf, 4, 0)]] int keep_first_error(TIFF* /*tiff*/, void* user,
                                                   const char* /*module*/, const char* format,
                                                   std::va_list arguments) {
    std::string& error = static_cast<Source*>(user)->error;
    if (error.empty()) {
        std::array<char, 256> text{};
        const int length = std::vsnprintf(text.data(), text.size(), format, arguments);
        error = length > 0 ? text.data() : "libtiff gives no reason";
    }
    return 1;  // handled: nothing goes to the process-wide handler and stderr
}

int drop_warning(TIFF* /*tiff*/, void* /*user*/, const char* /*module*/, const char* /*format*/,
                 std::va_list /*arguments*/) {
    return 1;
}

struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }

    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

std::unique_ptr<TIFF, Close> open(Source& source) {
    const std::unique_ptr<TIFFOpenOptions, Close> options(TIFFOpenOptionsAlloc());
    if (options == nullptr) return nullptr;
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(max_library_bytes));
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_first_error, &source);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), drop_warning, nullptr);
    return std::unique_ptr<TIFF, Close>(
        TIFFClientOpenExt("picture", "r", &source, read_some, refuse_write, seek, close_nothing,
                          size_of, nullptr, nullptr, options.get()));
}

/// libtiff packs a pixel into one number, red lowest, colours multiplied by alpha.
void raster_to_bgr(std::vector<std::uint8_t>& raster) {
    for (std::size_t i = 0; i < raster.size(); i += 4) {
        std::uint32_t pixel = 0;
        std::memcpy(&pixel, &raster[i], 4);
        const std::array bgra{TIFFGetB(pixel), TIFFGetG(pixel), TIFFGetR(pixel), TIFFGetA(pixel)};
        std::ranges::transform(
            bgra, raster.begin() + static_cast<std::ptrdiff_t>(i),
            [](std::uint32_t value) { return static_cast<std::uint8_t>(value); });
        unmultiply(&raster[i]);
    }
    compose(raster);
}

/// The first directory that is a picture, and no small copy of one nor a mask; the first, if there
/// is none.
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

/// Pixels on the same length, across and down; 0 where the file does not say.
std::array<float, 2> resolution_of(TIFF* tiff) {
    std::array<float, 2> resolution{};
    TIFFGetField(tiff, TIFFTAG_XRESOLUTION, &resolution[0]);
    TIFFGetField(tiff, TIFFTAG_YRESOLUTION, &resolution[1]);
    return resolution;
}

}  // namespace

Result<Picture> read_tiff(Bytes bytes) {
    Source source{bytes, 0, {}};
    const auto tiff = open(source);
    if (tiff == nullptr) return damaged("TIFF", source.error);
    choose_directory(tiff.get());
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
    if (auto fits = check_size("TIFF", width, height); !fits) {
        return tl::unexpected(fits.error());
    }
    std::uint16_t orientation = ORIENTATION_TOPLEFT;
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_ORIENTATION, &orientation);

    Picture picture{static_cast<int>(width), static_cast<int>(height), {}};
    picture.bgr.resize(std::size_t{4} * width * height);
    // Rows and columns as they are stored: libtiff turns only four of the eight orientations.
    // A byte vector's memory is aligned for any number.
    auto* raster = reinterpret_cast<std::uint32_t*>(picture.bgr.data());
    const int stop_on_error = 1;
    if (TIFFReadRGBAImageOriented(tiff.get(), width, height, raster, orientation, stop_on_error) ==
        0) {
        return damaged("TIFF", source.error);
    }
    raster_to_bgr(picture.bgr);
    const auto [across, down] = resolution_of(tiff.get());
    return upright(with_square_pixels(std::move(picture), static_cast<double>(across),
                                      static_cast<double>(down)),
                   orientation);
}

}  // namespace touchline::decode
