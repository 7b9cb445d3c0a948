#include "tests/vision/pictures/odd_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr int longest_side_px = 200;
constexpr int size_bytes = 3;

cv::Size size_of(ByteReader& bytes) {
    const int form = bytes.choice(16);
    const int one = bytes.byte();
    const int other = bytes.byte();
    const int length_px = 1 + one % longest_side_px;
    const int strip_px = 16 + other % 8;
    switch (form) {
        case 0:
            return {1, length_px};
        case 1:
            return {length_px, 1};
        case 2:
            return {strip_px, 8 * std::max(2, one)};
        case 3:
            return {8 * std::max(2, one), strip_px};
        default:
            return {length_px, 1 + other % longest_side_px};
    }
}

cv::Scalar colour_of(ByteReader& bytes) {
    const int blue = bytes.byte();
    const int green = bytes.byte();
    return {static_cast<double>(blue), static_cast<double>(green),
            static_cast<double>(bytes.byte())};
}

/// Returns the power to which files of cameras, screens and scanners raise light.
double exponent_of(ByteReader& bytes) {
    constexpr std::array<double, 8> exponents{0.35, 0.45, 0.45, 0.55, 0.7, 1.0, 1.8, 2.5};
    return exponents[static_cast<std::size_t>(bytes.choice(8))];
}

/// Returns BGR, 0 ... 255; hue in turns.
cv::Vec3b of_hue(double hue, double saturation, double value, double exponent = 1.0) {
    const auto channel = [&](double offset) {
        const double k = std::fmod(offset + 6.0 * (hue - std::floor(hue)), 6.0);
        const double share = 1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
        return cv::saturate_cast<uchar>(255.0 * std::pow(value * share, exponent));
    };
    return {channel(1.0), channel(3.0), channel(5.0)};
}

/// Paints every pixel by its place.
template <class ColourAt>
cv::Mat3b painted(cv::Size size, ColourAt&& colour_at) {
    cv::Mat3b picture(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) picture(y, x) = colour_at(x, y);
    }
    return picture;
}

cv::Mat3b raw(cv::Size size, ByteReader& bytes) {
    const std::span<const std::uint8_t> all = bytes.rest();
    std::size_t next = 0;
    return painted(size, [&](int, int) {
        cv::Vec3b pixel;
        for (int c = 0; c < 3 && !all.empty(); ++c) pixel[c] = all[next++ % all.size()];
        return pixel;
    });
}

/// Measures the way along a direction that the bytes choose, 0 ... about 1 over the picture.
auto way_of(cv::Size size, ByteReader& bytes) {
    constexpr std::array<std::array<double, 2>, 4> directions{
        {{1, 0}, {0, 1}, {0.5, 0.5}, {0.5, -0.5}}};
    const auto [u, v] = directions[static_cast<std::size_t>(bytes.choice(4))];
    return [=](int x, int y) { return u * x / size.width + v * y / size.height; };
}

cv::Mat3b hue_ramp(cv::Size size, ByteReader& bytes) {
    const auto way = way_of(size, bytes);
    constexpr std::array<double, 8> sixths{1, 2, 3, 4, 5, 6, 12, 24};  // of a turn, as is common
    const double turns = sixths[static_cast<std::size_t>(bytes.choice(8))] / 6.0;
    const double saturation = bytes.choice(4) == 0 ? 0.5 : 1.0;
    const bool is_shaded = bytes.choice(4) == 1;
    const double exponent = exponent_of(bytes);
    return painted(size, [&](int x, int y) {
        const double value = is_shaded ? (y + 1.0) / size.height : 1.0;
        return of_hue(turns * way(x, y), saturation, value, exponent);
    });
}

cv::Mat3b stripes(cv::Size size, ByteReader& bytes) {
    const double angle = std::numbers::pi * bytes.choice(16) / 16.0;
    const double period_px = 1.0 + bytes.choice(64);
    const double duty = 0.05 + 0.9 * bytes.share();
    const cv::Scalar dark = colour_of(bytes);
    const cv::Scalar light = colour_of(bytes);
    return painted(size, [&](int x, int y) {
        const double at = (x * std::cos(angle) + y * std::sin(angle)) / period_px;
        const cv::Scalar& colour = at - std::floor(at) < duty ? dark : light;
        return cv::Vec3b(cv::saturate_cast<uchar>(colour[0]), cv::saturate_cast<uchar>(colour[1]),
                         cv::saturate_cast<uchar>(colour[2]));
    });
}

/// Returns a level, 0 ... 1, in those of blue, green and red whose bit is set.
cv::Vec3b in_channels(int channels, double level) {
    cv::Vec3b pixel;
    for (int c = 0; c < 3; ++c) {
        pixel[c] = (channels >> c & 1) != 0 ? cv::saturate_cast<uchar>(255.0 * level) : uchar{0};
    }
    return pixel;
}

/// Ramps of light as files with their own gamma hold them, in one channel or all.
cv::Mat3b gamma_ramp(cv::Size size, ByteReader& bytes) {
    const double exponent = exponent_of(bytes);
    const auto way = way_of(size, bytes);
    const int channels = 1 + bytes.choice(7);
    const double periods = 1.0 + bytes.choice(4);
    const bool is_round = bytes.choice(4) == 0;
    return painted(size, [&](int x, int y) {
        const double radius =
            std::hypot((x + 0.5) / size.width - 0.5, (y + 0.5) / size.height - 0.5);
        const double at = periods * (is_round ? radius : way(x, y));
        return in_channels(channels, std::pow(at - std::floor(at), exponent));
    });
}

/// Bands, each a ramp of some of the channels, there or back, as on a test card.
cv::Mat3b ramps_in_bands(cv::Size size, ByteReader& bytes) {
    const int band_px = std::max(1, size.height / (1 + bytes.choice(8)));
    const bool is_turned = bytes.choice(4) == 0;  // every other band runs back
    const double exponent = exponent_of(bytes);
    std::array<int, 8> channels{};
    for (int& of_band : channels) of_band = 1 + bytes.choice(7);
    return painted(size, [&](int x, int y) {
        const int band = y / band_px;
        const double along = (x + 0.5) / size.width;
        const double at = is_turned && band % 2 == 1 ? 1.0 - along : along;
        return in_channels(channels[static_cast<std::size_t>(band % 8)], std::pow(at, exponent));
    });
}

cv::Mat3b checkers(cv::Size size, ByteReader& bytes) {
    const int cell_px = 1 + bytes.choice(24);
    const bool is_coloured = bytes.choice(2) == 1;
    const int step = 1 + bytes.choice(61);
    return painted(size, [&](int x, int y) {
        const int column = x / cell_px;
        const int row = y / cell_px;
        if (is_coloured) return of_hue(step * (column + 7 * row) / 61.0, 1.0, 1.0);
        return cv::Vec3b::all((column + row) % 2 == 0 ? uchar{0} : uchar{255});
    });
}

cv::Mat3b noise(cv::Size size, ByteReader& bytes) {
    SplitMix random(static_cast<std::uint64_t>(bytes.byte()));
    const int levels = 2 + bytes.choice(254);
    const bool is_grey = bytes.choice(2) == 1;
    return painted(size, [&](int, int) {
        cv::Vec3b pixel = cv::Vec3b::all(cv::saturate_cast<uchar>(random.below(levels)));
        for (int c = 1; c < 3 && !is_grey; ++c) pixel[c] = static_cast<uchar>(random.below(levels));
        return pixel;
    });
}

cv::Mat3b dots(cv::Size size, ByteReader& bytes) {
    cv::Mat3b picture(size, cv::Vec3b::all(255));
    const int count = 1 + bytes.choice(40);
    SplitMix random(static_cast<std::uint64_t>(bytes.byte()));
    for (int i = 0; i < count; ++i) {
        picture(random.below(size.height), random.below(size.width)) =
            cv::Vec3b::all(static_cast<uchar>(random.below(128)));
    }
    return picture;
}

cv::Mat3b discs(cv::Size size, ByteReader& bytes) {
    cv::Mat3b picture(size, cv::Vec3b::all(240));
    const int count = 1 + bytes.choice(6);
    SplitMix random(static_cast<std::uint64_t>(bytes.byte()));
    const int greatest_px = 1 + std::max(size.width, size.height) / 2;
    for (int i = 0; i < count; ++i) {
        const cv::Point centre(random.below(size.width), random.below(size.height));
        const int radius_px = random.below(greatest_px);
        const bool is_ring = random.below(2) == 0;
        const cv::Scalar colour(random.below(256), random.below(256), random.below(256));
        cv::circle(picture, centre, radius_px, colour, is_ring ? 1 + random.below(4) : cv::FILLED,
                   random.below(2) == 0 ? cv::LINE_8 : cv::LINE_AA);
    }
    return picture;
}

/// Rows of small blocks that look like letters.
cv::Mat3b text_blocks(cv::Size size, ByteReader& bytes) {
    cv::Mat3b picture(size, cv::Vec3b::all(255));
    const int height_px = 2 + bytes.choice(10);
    const int lean_px = bytes.choice(3);
    SplitMix random(static_cast<std::uint64_t>(bytes.byte()));
    for (int y = 2; y + height_px < size.height; y += 2 * height_px + 1) {
        for (int x = 1; x < size.width; x += height_px + random.below(3)) {
            const int top = y + lean_px * x / 32;
            const cv::Rect block(x, top, 1 + random.below(height_px), height_px);
            picture(block & cv::Rect({}, size)) =
                cv::Vec3b::all(static_cast<uchar>(random.below(90)));
        }
    }
    return picture;
}

cv::Mat3b pen_strokes(cv::Size size, ByteReader& bytes) {
    cv::Mat3b picture(size, cv::Vec3b::all(250));
    const int count = 1 + bytes.choice(8);
    const int width_px = 1 + bytes.choice(4);
    SplitMix random(static_cast<std::uint64_t>(bytes.byte()));
    for (int i = 0; i < count; ++i) {
        std::vector<cv::Point> points;
        for (int k = 0; k < 2 + random.below(5); ++k) {
            points.emplace_back(random.below(size.width), random.below(size.height));
        }
        cv::polylines(picture, points, random.below(3) == 0, cv::Scalar::all(random.below(100)),
                      width_px, random.below(2) == 0 ? cv::LINE_8 : cv::LINE_AA);
    }
    return picture;
}

cv::Mat3b one_colour(cv::Size size, ByteReader& bytes) {
    cv::Mat3b picture(size);
    picture.setTo(colour_of(bytes));
    return picture;
}

using Maker = cv::Mat3b (*)(cv::Size, ByteReader&);
constexpr int kinds = 14;

cv::Mat3b of_a_kind(int kind, cv::Size size, ByteReader& bytes) {
    constexpr std::array<Maker, kinds> makers{
        hue_ramp, hue_ramp, hue_ramp,    stripes, gamma_ramp,  checkers,   noise,
        dots,     discs,    text_blocks, raw,     pen_strokes, one_colour, ramps_in_bands};
    return makers[static_cast<std::size_t>(kind) % makers.size()](size, bytes);
}

/// Does what is often done to a picture on its way to a file.
void change(cv::Mat3b& picture, ByteReader& bytes) {
    const int what = bytes.choice(8);
    const int amount = bytes.byte();
    if (what == 1) {
        cv::bitwise_not(picture, picture);
    } else if (what == 2) {
        cv::GaussianBlur(picture, picture, cv::Size(), 0.3 + amount / 100.0);
    } else if (what == 3) {
        const int step = 2 + amount / 2;
        for (cv::Vec3b& p : picture) {
            for (int c = 0; c < 3; ++c) p[c] = static_cast<uchar>(p[c] / step * step);
        }
    } else if (what == 4) {
        SplitMix random(static_cast<std::uint64_t>(amount));
        for (cv::Vec3b& p : picture) {
            for (int c = 0; c < 3; ++c)
                p[c] = cv::saturate_cast<uchar>(p[c] + random.below(25) - 12);
        }
    }
}

}  // namespace

cv::Mat odd_picture(ByteReader& bytes) {
    const cv::Size size = size_of(bytes);
    const int kind = bytes.choice(kinds);
    const int beside = bytes.choice(3 * kinds);  // another in the right half, one time in three
    const bool is_grey = bytes.choice(4) == 0;
    // Reads the changes first: raw pixels take all remaining bytes.
    std::array<std::uint8_t, 2> ways{};
    for (std::uint8_t& way : ways) way = static_cast<std::uint8_t>(bytes.byte());
    cv::Mat3b picture = of_a_kind(kind, size, bytes);
    if (beside < kinds && size.width > 1) {
        const cv::Rect half(size.width / 2, 0, size.width - size.width / 2, size.height);
        of_a_kind(beside, half.size(), bytes).copyTo(picture(half));
    }
    ByteReader done(ways);
    change(picture, done);
    if (!is_grey) return picture;
    cv::Mat grey;
    cv::extractChannel(picture, grey, 1);
    return grey;
}

std::vector<std::uint8_t> random_picture_bytes(std::uint64_t seed, int n, int before) {
    constexpr int after = 60;
    SplitMix random(seed + 0x10001U * static_cast<std::uint64_t>(n));
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < before + size_bytes + after; ++i) {
        bytes.push_back(static_cast<std::uint8_t>(random.below(256)));
    }
    // Each size is the least of three, so that half of the sides are below 42 pixels.
    for (int i = 1; i < size_bytes; ++i) {
        std::uint8_t& side = bytes[static_cast<std::size_t>(before + i)];
        for (int more = 0; more < 2; ++more) {
            side = std::min(side, static_cast<std::uint8_t>(random.below(longest_side_px)));
        }
    }
    return bytes;
}

}  // namespace touchline::testing
