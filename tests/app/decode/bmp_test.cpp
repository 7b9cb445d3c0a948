// The reader of BMP, which is ours: what no other program writes for us.
#include "tests/app/decode/decoding_here.h"
#include "tests/app/decode/encoders.h"

#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using encoders::Bytes;

void add(Bytes& bytes, std::uint64_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::byte>(value >> (8 * i) & 0xffU));
}

/// A header of 40 bytes, two colours where there are indices, then `pixels`.
Bytes bmp(int width, int height, std::uint32_t bits, std::uint32_t packing,
          const std::vector<int>& pixels) {
    Bytes bytes = encoders::bytes_of("BM");
    const std::uint32_t colours = bits <= 8 ? 8 : 0;
    add(bytes, 0, 8);
    add(bytes, 54 + colours, 4);
    add(bytes, 40, 4);
    add(bytes, static_cast<std::uint32_t>(width), 4);
    add(bytes, static_cast<std::uint32_t>(height), 4);
    add(bytes, 1, 2);
    add(bytes, bits, 2);
    add(bytes, packing, 4);
    for (int i = 0; i < 3; ++i) add(bytes, 0, 4);
    add(bytes, colours / 4, 4);
    add(bytes, 0, 4);
    if (colours > 0) {
        add(bytes, 0x00000000, 4);
        add(bytes, 0x00102030, 4);
    }
    for (const int byte : pixels) bytes.push_back(static_cast<std::byte>(byte));
    return bytes;
}

constexpr std::array<std::uint8_t, 3> lit{0x30, 0x20, 0x10};

bool is_lit(const Picture& picture, int x, int y) {
    return std::equal(lit.begin(), lit.end(),
                      &picture.bgr[3 * static_cast<std::size_t>(y * picture.width + x)]);
}

TEST(BmpReader, RowsGoUpUnlessTheHeightIsNegative) {
    const std::vector<int> rows{1, 0, 0, 0, 0, 0, 0, 0};  // one byte a pixel, rows of four
    EXPECT_TRUE(is_lit(decode_picture(bmp(1, 2, 8, 0, rows)).value(), 0, 1));
    EXPECT_TRUE(is_lit(decode_picture(bmp(1, -2, 8, 0, rows)).value(), 0, 0));
}

TEST(BmpReader, RunsStretchesAndJumps) {
    // Two lit, a jump of one to the right and one up, a stretch of three with its filling byte.
    const auto picture =
        decode_picture(bmp(6, 2, 8, 1, {2, 1, 0, 2, 1, 1, 0, 3, 1, 0, 1, 0, 0, 1}));
    ASSERT_TRUE(picture.has_value()) << picture.error().line;
    for (int x = 0; x < 6; ++x) {
        EXPECT_EQ(is_lit(*picture, x, 1), x < 2) << x;
        EXPECT_EQ(is_lit(*picture, x, 0), x == 3 || x == 5) << x;
    }
}

TEST(BmpReader, RunsOutsideThePictureAreNotDrawn) {
    EXPECT_TRUE(
        decode_picture(bmp(2, 1, 8, 1, {200, 1, 0, 0, 200, 1, 0, 0, 9, 1, 0, 1})).has_value());
    EXPECT_TRUE(decode_picture(bmp(2, 1, 8, 1, {0, 2, 255, 255, 9, 1, 0, 1})).has_value());
}

TEST(BmpReader, WhatIsCutShortOrUnknownIsOneLine) {
    EXPECT_FALSE(decode_picture(bmp(5, 5, 24, 0, {1, 2, 3})).has_value());
    EXPECT_FALSE(decode_picture(bmp(5, 5, 8, 1, {1, 2, 3})).has_value());
    EXPECT_FALSE(decode_picture(bmp(5, 5, 24, 4, {})).has_value());  // a JPEG within
    EXPECT_FALSE(decode_picture(bmp(5, 5, 7, 0, {})).has_value());
    EXPECT_FALSE(decode_picture(bmp(-5, 5, 8, 0, {})).has_value());
    EXPECT_FALSE(decode_picture(bmp(5, 0, 8, 0, {})).has_value());
    EXPECT_FALSE(decode_picture(bmp(5, static_cast<int>(0x80000000U), 8, 0, {})).has_value());
}

}  // namespace
}  // namespace touchline
