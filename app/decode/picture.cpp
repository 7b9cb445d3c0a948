#include "app/decode/picture.h"

#include "app/decode/files.h"
#include "app/decode/formats.h"
#include "app/decode/one_line.h"
#include "app/decode/signature.h"

#include <algorithm>
#include <array>
#include <exception>
#include <new>
#include <string_view>

#include <fmt/format.h>

namespace touchline {
namespace decode {

Result<void> check_size(std::string_view format, std::uint64_t width, std::uint64_t height,
                        std::uint64_t bytes_per_pixel) {
    if (width == 0 || height == 0) return damaged(format, "it has no pixels");
    // Both sides fit in 32 bits in every format, so the products fit in 64.
    const std::uint64_t pixels = width * height;
    if (pixels <= max_picture_pixels && pixels * bytes_per_pixel <= max_picture_bytes) return {};
    return failure(fmt::format(
        "the {} picture has {} x {} pixels, more than fits in {} megapixels and {} MiB; "
        "save it smaller",
        format, width, height, max_picture_pixels / 1'000'000, max_picture_bytes >> 20U));
}

tl::unexpected<Error> damaged(std::string_view format, std::string_view detail) {
    return failure(
        fmt::format("the {} picture is cut short or damaged ({}); copy it again or save it anew",
                    format, detail.empty() ? "its data make no sense" : one_line(detail)));
}

namespace {

Result<Picture> read_by_signature(Bytes bytes) {
    if (bytes.empty()) return failure("the file is empty; copy it again");
    switch (format_of(bytes)) {
        case FileFormat::png:
            return read_png(bytes);
        case FileFormat::jpeg:
            return read_jpeg(bytes);
        case FileFormat::webp:
            return read_webp(bytes);
        case FileFormat::tiff:
            return read_tiff(bytes);
        case FileFormat::svg:
            return read_svg(bytes);
        case FileFormat::unknown:
            break;
    }
    return failure(
        "the file is none of PNG, JPEG, WebP, TIFF and SVG, by its first bytes; "
        "save the picture as PNG or JPEG");
}

}  // namespace
}  // namespace decode

Result<Picture> decode_picture(std::span<const std::byte> bytes) {
    try {
        return decode::read_by_signature(bytes);
    } catch (const std::bad_alloc&) {
        return failure("not enough memory for the picture; save it smaller");
    } catch (const std::exception& problem) {
        return failure("the picture cannot be decoded: " + one_line(problem.what()));
    }
}

Result<Picture> read_picture(const std::string& path) {
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto picture = decode_picture(*bytes);
    if (!picture) return failure(one_line(path) + ": " + picture.error().line);
    return picture;
}

}  // namespace touchline
