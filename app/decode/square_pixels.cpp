// Handles pixels that are not square, as in files of fax machines and old screens.
#include "app/decode/formats.h"

#include <algorithm>
#include <cmath>

namespace touchline::decode {
namespace {

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
    if (fits_a_picture(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height)))
        return stretched(picture, width, height);
    return stretched(picture, side(picture.width, std::min(1.0, 1.0 / ratio)),
                     side(picture.height, std::min(1.0, ratio)));
}

}  // namespace touchline::decode
