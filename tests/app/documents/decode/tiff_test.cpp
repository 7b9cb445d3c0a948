// Tests TIFFs of every depth and kind, which the tests write themselves: each pixel is what the
// file says.
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/plain_tiff.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using encoders::plain_tiff;
using encoders::PlainTiff;

constexpr std::uint32_t tiff_columns = 37;  // no byte, tile or strip ends at it
constexpr std::uint32_t tiff_rows = 21;

/// A value from 0 to 1, both included, for each of a pixel's parts; it differs from its neighbours.
double brightness(std::uint32_t x, std::uint32_t y, unsigned part) {
    const std::uint32_t i = (y * tiff_columns + x) * 4 + part;
    if (i == 0) return 0.0;
    if (i == 1) return 1.0;
    return static_cast<double>(i * 7919U % 1009U) / 1008.0;
}

std::uint64_t most_of(unsigned bits) {
    return bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

std::uint64_t whole_bits(double part, unsigned bits) {
    return static_cast<std::uint64_t>(
               std::llround(part * std::ldexp(1.0, static_cast<int>(std::min(bits, 40U))) - part))
           << (bits > 40 ? bits - 40 : 0);
}

std::vector<std::uint64_t> samples_of(const PlainTiff& form) {
    std::vector<std::uint64_t> stored;
    for (std::uint32_t y = 0; y < form.height; ++y)
        for (std::uint32_t x = 0; x < form.width; ++x)
            for (unsigned part = 0; part < form.samples; ++part)
                stored.push_back(whole_bits(brightness(x, y, part), form.bits));
    return stored;
}

int part_at(const Picture& picture, std::uint32_t x, std::uint32_t y, std::size_t part) {
    return picture.bgr.at(3 * (std::size_t{y} * static_cast<std::size_t>(picture.width) + x) +
                          part);
}

PlainTiff form_of(unsigned bits, unsigned samples, unsigned photometric) {
    PlainTiff form;
    form.width = tiff_columns;
    form.height = tiff_rows;
    form.bits = bits;
    form.samples = samples;
    form.photometric = photometric;
    return form;
}

/// Expects grey or colour within one level plus what the depth cannot tell apart.
void expect_brightness(const PlainTiff& form, const Picture& picture) {
    ASSERT_EQ(picture.width, static_cast<int>(form.width));
    ASSERT_EQ(picture.height, static_cast<int>(form.height));
    const double coarse = 255.0 / static_cast<double>(most_of(form.bits));
    for (std::uint32_t y = 0; y < form.height; ++y) {
        for (std::uint32_t x = 0; x < form.width; ++x) {
            for (unsigned part = 0; part < 3; ++part) {
                double told = brightness(x, y, form.samples == 1 ? 0 : 2 - part);
                if (form.photometric == 0) told = 1.0 - told;
                ASSERT_NEAR(part_at(picture, x, y, part), 255.0 * told, 1.0 + coarse / 2.0)
                    << x << ' ' << y << ' ' << part;
            }
        }
    }
}

TEST(TiffForms, WholeNumbersOfOneToThirtyTwoBits) {
    for (unsigned bits = 1; bits <= 32; ++bits) {
        for (const unsigned photometric : {0U, 1U, 2U}) {
            SCOPED_TRACE(std::to_string(bits) + " bits, " + std::to_string(photometric));
            PlainTiff form = form_of(bits, photometric == 2 ? 3 : 1, photometric);
            expect_brightness(form, decoded(plain_tiff(form, samples_of(form))));
            form.is_big_endian = true;
            expect_brightness(form, decoded(plain_tiff(form, samples_of(form))));
        }
    }
    const PlainTiff widest = form_of(64, 1, 1);
    expect_brightness(widest, decoded(plain_tiff(widest, samples_of(widest))));
}

TEST(TiffForms, StripsAndTilesOfPixelsAndOfPlanes) {
    for (const unsigned bits : {1U, 4U, 8U, 12U, 16U}) {
        for (const bool is_planar : {false, true}) {
            for (const std::uint32_t tile : {0U, 16U, 48U}) {
                for (const std::uint32_t strip : {0U, 1U, 5U}) {
                    SCOPED_TRACE(std::to_string(bits) + " bits, tile " + std::to_string(tile) +
                                 ", strip " + std::to_string(strip));
                    PlainTiff form = form_of(bits, 3, 2);
                    form.is_planar = is_planar;
                    form.tile = tile;
                    form.strip_rows = strip;
                    expect_brightness(form, decoded(plain_tiff(form, samples_of(form))));
                }
            }
        }
    }
}

TEST(TiffForms, SignedNumbersAreBlackAtTheirLeast) {
    for (const unsigned bits : {8U, 12U, 16U, 32U}) {
        PlainTiff form = form_of(bits, 1, 1);
        form.sample_format = 2;
        std::vector<std::uint64_t> stored = samples_of(form);
        for (std::uint64_t& sample : stored) sample ^= std::uint64_t{1} << (bits - 1);
        expect_brightness(form, decoded(plain_tiff(form, stored)));
    }
}

std::uint64_t half(double number) {
    if (number == 0.0) return 0;
    int exponent = 0;
    const double fraction = std::frexp(number, &exponent);  // 0.5 ... 1
    if (exponent + 14 < 1) return static_cast<std::uint64_t>(std::llround(number * 0x1p24));
    return static_cast<std::uint64_t>(exponent + 14) << 10U |
           static_cast<std::uint64_t>((fraction * 2.0 - 1.0) * 1024.0);
}

std::uint64_t floating_bits(double number, unsigned bits) {
    if (bits == 64) return std::bit_cast<std::uint64_t>(number);
    if (bits == 32) return std::bit_cast<std::uint32_t>(static_cast<float>(number));
    return half(number);
}

PlainTiff floating_form(unsigned bits) {
    PlainTiff form = form_of(bits, 1, 1);
    form.sample_format = 3;
    return form;
}

TEST(TiffForms, FloatingNumbersFromNoughtToOne) {
    for (const unsigned bits : {16U, 32U, 64U}) {
        for (const bool is_big_endian : {false, true}) {
            PlainTiff form = floating_form(bits);
            form.is_big_endian = is_big_endian;
            std::vector<std::uint64_t> stored;
            for (std::uint32_t i = 0; i < tiff_columns * tiff_rows; ++i)
                stored.push_back(
                    floating_bits(brightness(i % tiff_columns, i / tiff_columns, 0), bits));
            expect_brightness(form, decoded(plain_tiff(form, stored)));
        }
    }
}

/// Heights of a landscape; NaN where none was measured.
TEST(TiffForms, MeasurementsAreStretchedOverAllLevels) {
    PlainTiff form = floating_form(32);
    form.width = 4;
    form.height = 1;
    const auto bits = [](float number) { return std::bit_cast<std::uint32_t>(number); };
    const Picture picture =
        decoded(plain_tiff(form, {bits(150.0F), bits(250.0F), bits(200.0F),
                                  bits(std::numeric_limits<float>::quiet_NaN())}));
    EXPECT_EQ(part_at(picture, 0, 0, 0), 0);
    EXPECT_EQ(part_at(picture, 1, 0, 0), 255);
    EXPECT_NEAR(part_at(picture, 2, 0, 0), 127.5, 1.0);
    EXPECT_EQ(part_at(picture, 3, 0, 0), 0);

    PlainTiff low = form_of(16, 1, 1);  // 12 bits in 16
    low.width = 3;
    low.height = 1;
    const Picture stretched = decoded(plain_tiff(low, {0, 4095, 1024}));
    EXPECT_EQ(part_at(stretched, 1, 0, 0), 255);
    EXPECT_NEAR(part_at(stretched, 2, 0, 0), 64, 1);
    low.sample_format = 2;
    const Picture depths = decoded(plain_tiff(low, {0xffff - 99, 100, 0}));  // -100, 100, 0
    EXPECT_EQ(part_at(depths, 0, 0, 0), 0);
    EXPECT_EQ(part_at(depths, 1, 0, 0), 255);
    EXPECT_NEAR(part_at(depths, 2, 0, 0), 127, 1);
}

TEST(TiffForms, PalettesOfOneToSixteenBitsWideAndNarrow) {
    for (const unsigned bits : {1U, 2U, 4U, 8U, 16U}) {
        for (const unsigned scale : {257U, 1U}) {
            PlainTiff form = form_of(bits, 1, 3);
            const std::size_t count = std::size_t{1} << bits;
            for (std::size_t part = 0; part < 3; ++part)
                for (std::size_t i = 0; i < count; ++i)
                    form.palette.push_back(
                        static_cast<std::uint16_t>((i * 37 + 50 * part) % 256 * scale));
            std::vector<std::uint64_t> stored;
            for (std::uint64_t i = 0; i < tiff_columns * tiff_rows; ++i)
                stored.push_back(i * 11 % count);
            const Picture picture = decoded(plain_tiff(form, stored));
            for (std::uint32_t i = 0; i < tiff_columns * tiff_rows; ++i)
                for (std::size_t part = 0; part < 3; ++part)
                    ASSERT_EQ(part_at(picture, i % tiff_columns, i / tiff_columns, 2 - part),
                              static_cast<int>((stored[i] * 37 + 50 * part) % 256))
                        << bits;
        }
    }
}

TEST(TiffForms, InksOfEightAndSixteenBits) {
    for (const unsigned bits : {8U, 16U}) {
        for (const bool is_planar : {false, true}) {
            PlainTiff form = form_of(bits, 4, 5);
            form.is_planar = is_planar;
            const Picture picture = decoded(plain_tiff(form, samples_of(form)));
            for (std::uint32_t i = 0; i < tiff_columns * tiff_rows; ++i) {
                const auto light = [i](unsigned ink) {
                    return 1.0 - brightness(i % tiff_columns, i / tiff_columns, ink);
                };
                for (unsigned part = 0; part < 3; ++part)
                    ASSERT_NEAR(part_at(picture, i % tiff_columns, i / tiff_columns, 2 - part),
                                255.0 * light(part) * light(3), 1.5);
            }
        }
    }
}

/// White, black, a grey by CIE's formula, and clear red and blue.
TEST(TiffForms, LabOfBothEncodingsAndDepths) {
    struct Colour {
        double lightness, a, b;
    };

    const std::vector<Colour> colours{
        {100, 0, 0}, {0, 0, 0}, {53.585, 0, 0}, {53.24, 80.09, 67.2}, {32.3, 79.19, -107.86}};
    for (const unsigned bits : {8U, 16U}) {
        for (const unsigned photometric : {8U, 9U}) {
            SCOPED_TRACE(std::to_string(bits) + " bits, " + std::to_string(photometric));
            PlainTiff form = form_of(bits, 3, photometric);
            form.width = 5;
            form.height = 1;
            const double unit = bits == 16 ? 256.0 : 1.0;
            const auto mask = static_cast<std::int64_t>(most_of(bits));
            std::vector<std::uint64_t> stored;
            for (const Colour& colour : colours) {
                const double whole =
                    bits == 16 && photometric == 9 ? 65280.0 : static_cast<double>(mask);
                stored.push_back(
                    static_cast<std::uint64_t>(std::llround(whole * colour.lightness / 100.0)));
                for (const double part : {colour.a, colour.b}) {
                    const double offset = photometric == 9 ? 128.0 : 0.0;
                    stored.push_back(
                        static_cast<std::uint64_t>(std::llround(unit * (part + offset)) & mask));
                }
            }
            const Picture picture = decoded(plain_tiff(form, stored));
            for (std::size_t part = 0; part < 3; ++part) {
                EXPECT_NEAR(part_at(picture, 0, 0, part), 255, 3);
                EXPECT_NEAR(part_at(picture, 1, 0, part), 0, 3);
                EXPECT_NEAR(part_at(picture, 2, 0, part), 128, 4);
            }
            EXPECT_GT(part_at(picture, 3, 0, 2), 220);
            EXPECT_LT(part_at(picture, 3, 0, 0), 60);
            EXPECT_GT(part_at(picture, 4, 0, 0), 220);
            EXPECT_LT(part_at(picture, 4, 0, 1), 60);
        }
    }
}

/// By the formula of ITU-R BT.601 over all levels, as in the specification.
TEST(TiffForms, BrightnessAndColourApartInStripsAndTiles) {
    for (const std::uint32_t tile : {0U, 16U}) {
        for (const std::uint32_t strip : {0U, 5U}) {
            PlainTiff form = form_of(8, 3, 6);
            form.tile = tile;
            form.strip_rows = strip;
            const std::vector<std::uint64_t> stored = samples_of(form);
            const Picture picture = decoded(plain_tiff(form, stored));
            ASSERT_EQ(picture.width, static_cast<int>(tiff_columns));
            for (std::uint32_t i = 0; i < tiff_columns * tiff_rows; ++i) {
                const auto part = [&](std::size_t k) {
                    return static_cast<double>(stored[3 * i + k]);
                };
                const double blue = part(1) - 128.0;
                const double red = part(2) - 128.0;
                const std::array<double, 3> told{part(0) + 1.772 * blue,
                                                 part(0) - 0.344136 * blue - 0.714136 * red,
                                                 part(0) + 1.402 * red};
                for (std::size_t k = 0; k < 3; ++k)
                    ASSERT_NEAR(part_at(picture, i % tiff_columns, i / tiff_columns, k),
                                std::clamp(told[k], 0.0, 255.0), 2.0)
                        << i;
            }
        }
    }
}

TEST(TiffForms, AlphaOfSixteenBitsStraightAndMultiplied) {
    for (const int kind : {1, 2}) {
        for (const bool is_planar : {false, true}) {
            PlainTiff form = form_of(16, 4, 2);
            form.width = 2;
            form.height = 1;
            form.extra_sample = kind;
            form.is_planar = is_planar;
            const std::uint64_t red = kind == 1 ? 0x8000 : 0xffff;  // half of the red shows
            const Picture picture = decoded(plain_tiff(form, {red, 0, 0, 0x8000, 0, 0, 0, 0xffff}));
            EXPECT_NEAR(part_at(picture, 0, 0, 2), 255, 1);
            EXPECT_NEAR(part_at(picture, 0, 0, 0), 127, 2);
            EXPECT_EQ(part_at(picture, 1, 0, 2), 0);
        }
    }
}

TEST(TiffForms, SamplesThatAreNotToldAreNoAlpha) {
    PlainTiff form = form_of(8, 2, 1);
    form.width = 2;
    form.height = 1;
    form.extra_sample = 0;
    const Picture picture = decoded(plain_tiff(form, {10, 0, 200, 0}));
    EXPECT_EQ(part_at(picture, 0, 0, 0), 10);
    EXPECT_EQ(part_at(picture, 1, 0, 0), 200);
}

/// The dark corner lies where TIFF 6.0 says, and the sides swap from orientation 5 on.
TEST(TiffForms, AllOrientationsOfTilesAndStrips) {
    struct Corner {
        bool is_right, is_low;
    };

    constexpr std::array<Corner, 8> corners{{{false, false},
                                             {true, false},
                                             {true, true},
                                             {false, true},
                                             {false, false},
                                             {true, false},
                                             {true, true},
                                             {false, true}}};
    for (unsigned orientation = 1; orientation <= 8; ++orientation) {
        for (const std::uint32_t tile : {0U, 16U}) {
            SCOPED_TRACE(orientation);
            PlainTiff form = form_of(8, 1, 1);
            form.orientation = orientation;
            form.tile = tile;
            std::vector<std::uint64_t> stored(tiff_columns * tiff_rows, 255);
            stored[0] = 0;
            const Picture picture = decoded(plain_tiff(form, stored));
            const bool is_turned = orientation >= 5;
            ASSERT_EQ(picture.width, static_cast<int>(is_turned ? tiff_rows : tiff_columns));
            ASSERT_EQ(picture.height, static_cast<int>(is_turned ? tiff_columns : tiff_rows));
            const Corner& corner = corners.at(orientation - 1);
            const auto x = static_cast<std::uint32_t>(corner.is_right ? picture.width - 1 : 0);
            const auto y = static_cast<std::uint32_t>(corner.is_low ? picture.height - 1 : 0);
            EXPECT_EQ(part_at(picture, x, y, 0), 0);
        }
    }
}

TEST(TiffForms, ComplexNumbersAreOneLineThatSaysWhatToDo) {
    PlainTiff form = form_of(32, 1, 1);
    form.sample_format = 6;
    const auto picture = decode_picture(plain_tiff(form, samples_of(form)));
    ASSERT_FALSE(picture);
    EXPECT_NE(picture.error().line.find("save it as PNG"), std::string::npos)
        << picture.error().line;
}

}  // namespace
}  // namespace touchline
