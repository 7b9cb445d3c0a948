// What all readers share: limits, the messages for refused files, and how stored pixels are shown:
// over which ground, which way up (EXIF and TIFF use the same numbers for the eight ways of holding
// a camera: TIFF 6.0, tag 274), and with pixels made square, which those of fax machines and old
// screens are not.
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/readers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <new>
#include <utility>

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

// Grey levels: a smaller difference from the background is invisible.
constexpr int unseen_difference = 40;
// If more of what is painted is near white, nothing would be seen.
constexpr double unseen_share = 0.97;

/// White, as paper is; black if nearly everything painted is white, and something shows through.
unsigned ground_for(const std::vector<std::uint8_t>& bgra) {
    std::uint64_t painted = 0;
    std::uint64_t unseen = 0;
    std::size_t open = 0;
    for (std::size_t i = 0; i + 3 < bgra.size(); i += 4) {
        const unsigned alpha = bgra[i + 3];
        painted += alpha;
        if (255 - lightness_of(&bgra[i]) < unseen_difference) unseen += alpha;
        if (alpha < 255 - unseen_difference) ++open;
    }
    const bool is_unseen =
        open > 0 && static_cast<double>(unseen) >
                        unseen_share * static_cast<double>(std::max<std::uint64_t>(painted, 1));
    return is_unseen ? 0U : 255U;
}

constexpr double least_difference = 0.02;
constexpr double most_difference = 5.0;  // anything more is nonsense

/// Two neighbours in a line of pixels, and the share of the second.
struct Between {
    std::size_t first;
    std::size_t second;
    unsigned part;  // of 256
};

Between between(std::size_t at, std::size_t count, std::size_t of) {
    const double place =
        (static_cast<double>(at) + 0.5) * static_cast<double>(of) / static_cast<double>(count) -
        0.5;
    const double clamped = std::clamp(place, 0.0, static_cast<double>(of - 1));
    const auto first = static_cast<std::size_t>(clamped);
    return {first, std::min(first + 1, of - 1),
            static_cast<unsigned>(256.0 * (clamped - static_cast<double>(first)))};
}

Picture stretched(const Picture& from, int width, int height) {
    Picture to{width, height, {}, from.scale};
    const auto columns = static_cast<std::size_t>(width);
    const auto from_columns = static_cast<std::size_t>(from.width);
    to.bgr.resize(3 * columns * static_cast<std::size_t>(height));
    std::uint8_t* out = to.bgr.data();
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        const Between rows =
            between(y, static_cast<std::size_t>(height), static_cast<std::size_t>(from.height));
        for (std::size_t x = 0; x < columns; ++x) {
            const Between sides = between(x, columns, from_columns);
            for (std::size_t channel = 0; channel < 3; ++channel, ++out) {
                const auto level = [&](std::size_t row) {
                    const std::uint8_t* pixels = from.bgr.data() + 3 * row * from_columns + channel;
                    return (256 - sides.part) * pixels[3 * sides.first] +
                           sides.part * pixels[3 * sides.second];
                };
                *out = static_cast<std::uint8_t>(
                    ((256 - rows.part) * level(rows.first) + rows.part * level(rows.second)) >>
                    16U);
            }
        }
    }
    return to;
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

void compose(std::vector<std::uint8_t>& bgra) {
    const unsigned ground = ground_for(bgra);
    const std::size_t pixels = bgra.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        const unsigned alpha = bgra[4 * i + 3];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const unsigned sum = bgra[4 * i + channel] * alpha + ground * (255U - alpha) + 127U;
            bgra[3 * i + channel] = static_cast<std::uint8_t>(sum / 255U);
        }
    }
    bgra.resize(3 * pixels);
}

void unmultiply(std::uint8_t* bgra) {
    const unsigned alpha = bgra[3];
    for (std::size_t channel = 0; alpha > 0 && channel < 3; ++channel)
        bgra[channel] =
            static_cast<std::uint8_t>(std::min(255U, (bgra[channel] * 255U + alpha / 2U) / alpha));
}

Picture upright(Picture picture, int orientation) {
    if (orientation < 2 || orientation > 8) return picture;
    const bool is_turned = orientation >= 5;  // rows of the file are columns of the picture
    const bool is_x_mirrored =
        orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool is_y_mirrored =
        orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Picture out{picture.width, picture.height, {}, picture.scale};
    if (is_turned) std::swap(out.width, out.height);
    out.bgr.resize(picture.bgr.size());
    const auto width = static_cast<std::size_t>(picture.width);
    const auto height = static_cast<std::size_t>(picture.height);
    std::uint8_t* to = out.bgr.data();
    for (std::size_t y = 0; y < static_cast<std::size_t>(out.height); ++y) {
        for (std::size_t x = 0; x < static_cast<std::size_t>(out.width); ++x, to += 3) {
            // The source's column and row, before the mirroring along the file's own axes.
            const std::size_t column = is_turned ? y : x;
            const std::size_t row = is_turned ? x : y;
            const std::size_t from_x = is_x_mirrored ? width - 1 - column : column;
            const std::size_t from_y = is_y_mirrored ? height - 1 - row : row;
            std::copy_n(&picture.bgr[3 * (from_y * width + from_x)], 3, to);
        }
    }
    return out;
}

Picture with_square_pixels(Picture picture, const Resolution& resolution) {
    const double ratio = resolution.across / resolution.down;
    if (!(ratio > 1.0 / most_difference && ratio < most_difference) ||
        std::abs(ratio - 1.0) < least_difference)
        return picture;
    // Enlarges the coarser side; if the picture would be too large, shrinks the finer one.
    const auto side = [](int pixels, double by) {
        return std::max(1, static_cast<int>(std::lround(pixels * by)));
    };
    const int width = side(picture.width, std::max(1.0, 1.0 / ratio));
    const int height = side(picture.height, std::max(1.0, ratio));
    if (fits_a_picture(width, height)) return stretched(picture, width, height);
    return stretched(picture, side(picture.width, std::min(1.0, 1.0 / ratio)),
                     side(picture.height, std::min(1.0, ratio)));
}

}  // namespace touchline::decode
