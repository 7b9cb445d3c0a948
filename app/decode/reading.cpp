// What all readers share: limits, and the messages for refused files.
#include "app/decode/formats.h"
#include "app/decode/one_line.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

#include <fmt/format.h>

namespace touchline::decode {
namespace {

/// `most` and `most_side_px`: pixels in all and on a side; the sentence tells the megapixels.
Result<void> check(std::string_view format, std::int64_t width, std::int64_t height,
                   std::uint64_t most, std::uint64_t most_side_px, std::uint64_t megapixel) {
    if (width < 1 || height < 1) return damaged(format, "it has no pixels");
    const auto across = static_cast<std::uint64_t>(width);
    const auto down = static_cast<std::uint64_t>(height);
    if (across <= most_side_px && down <= most_side_px && across * down <= most) return {};
    return failure(
        fmt::format("the {} picture has {} x {} pixels, more than {} megapixels or {} on a side; "
                    "save it smaller",
                    format, width, height, most / megapixel, most_side_px));
}

}  // namespace

Result<void> check_size(std::string_view format, std::int64_t width, std::int64_t height) {
    return check(format, width, height, max_picture_pixels, max_picture_side_px, 1U << 20U);
}

Result<void> check_file_size(std::string_view format, std::int64_t width, std::int64_t height,
                             std::uint64_t most_pixels) {
    return check(format, width, height, most_pixels, max_file_side_px, 1'000'000);
}

tl::unexpected<Error> damaged(std::string_view format, std::string_view detail) {
    return failure(
        fmt::format("the {} {} is cut short or damaged ({}); copy it again or save it anew", format,
                    format == "PDF" ? "document" : "picture",
                    detail.empty() ? "its data make no sense" : one_line(detail)));
}

tl::unexpected<Error> not_a_picture(FileFormat format) {
    switch (format) {
        case FileFormat::office:
            return failure(
                "the file is an office document, which cannot be opened here; save it as PDF");
        case FileFormat::archive:
            return failure(
                "the file is an archive of other files; unpack it on your computer and copy "
                "the pictures");
        default:
            return failure(
                "the file is no picture that is known here, by its first bytes; "
                "save it as PNG, JPEG or PDF");
    }
}

Area told_area(const Picture& picture) {
    return {told_m_per_px * picture.width, told_m_per_px * picture.height};
}

std::optional<WordBox> pixels_within(const TextBox& box_px, const Picture& picture) {
    if (!std::isfinite(box_px.left + box_px.top + box_px.right + box_px.bottom))
        return std::nullopt;
    const auto pixel = [](double value, int most) {
        return static_cast<std::uint16_t>(std::clamp(value, 0.0, static_cast<double>(most)));
    };
    const WordBox found{pixel(std::floor(box_px.left), picture.width),
                        pixel(std::floor(box_px.top), picture.height),
                        pixel(std::ceil(box_px.right), picture.width),
                        pixel(std::ceil(box_px.bottom), picture.height)};
    if (found.left < found.right && found.top < found.bottom) return found;
    return std::nullopt;
}

Position told_place(const Picture& picture, double x_px, double y_px) {
    return {told_m_per_px * (x_px - picture.width / 2.0),
            told_m_per_px * (picture.height / 2.0 - y_px)};
}

Result<Page> without_exceptions(Result<Page> (*read)(Bytes bytes, const PageOrder& order),
                                Bytes bytes, const PageOrder& order) {
    try {
        if (bytes.empty()) return failure("the file is empty; copy it again");
        return read(bytes, order);
    } catch (const std::bad_alloc&) {
        return failure("not enough memory for the file; save it smaller");
    } catch (const std::exception& problem) {
        return failure("the file cannot be read: " + one_line(problem.what()));
    }
}

}  // namespace touchline::decode
