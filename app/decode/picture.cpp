#include "app/decode/picture.h"

#include "app/decode/files.h"
#include "app/decode/formats.h"
#include "app/decode/one_line.h"

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

bool starts_with(Bytes bytes, std::string_view magic, std::size_t offset = 0) {
    if (bytes.size() < offset + magic.size()) return false;
    return std::equal(magic.begin(), magic.end(), bytes.begin() + static_cast<long>(offset),
                      [](char c, std::byte b) { return static_cast<std::byte>(c) == b; });
}

bool is_svg(Bytes bytes) {
    constexpr std::size_t prologue_bytes = 4096;  // declaration, DOCTYPE, comments
    const auto head = bytes.first(std::min(bytes.size(), prologue_bytes));
    std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text[first] != '<') return false;
    return text.find("<svg") != std::string_view::npos ||
           text.find(":svg") != std::string_view::npos;
}

Result<Picture> read_by_signature(Bytes bytes) {
    using namespace std::string_view_literals;
    if (bytes.empty()) return failure("the file is empty; copy it again");
    if (starts_with(bytes, "\x89PNG\r\n\x1a\n"sv)) return read_png(bytes);
    if (starts_with(bytes, "\xff\xd8\xff"sv)) return read_jpeg(bytes);
    if (starts_with(bytes, "RIFF"sv) && starts_with(bytes, "WEBP"sv, 8)) return read_webp(bytes);
    for (const auto magic : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}) {
        if (starts_with(bytes, magic)) return read_tiff(bytes);
    }
    if (is_svg(bytes)) return read_svg(bytes);
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
