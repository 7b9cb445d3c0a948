// Tests our own BMP reader with files that no other program writes for us.
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"

#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using encoders::Bytes;

void add(Bytes& bytes, std::uint64_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::byte>(value >> (8 * i) & 0xffU));
}

/// A 40-byte header, two colours if the pixels are indices, then `pixels`.
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
    // Two lit pixels, a jump of one right and one up, then a literal run of three with its padding
    // byte.
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

/// An OS/2 file header: two letters, its size, a hot spot, and where the pixels are.
void add_file_header(Bytes& bytes, const std::string& kind, std::size_t pixels_at) {
    for (const char letter : kind) bytes.push_back(static_cast<std::byte>(letter));
    add(bytes, 26, 4);
    add(bytes, 3, 2);
    add(bytes, 5, 2);
    add(bytes, pixels_at, 4);
}

/// The 12-byte header and as many 3-byte colours as there can be; all are lit but the first.
void add_oldest_header(Bytes& bytes, int width, int height, unsigned bits) {
    add(bytes, 12, 4);
    add(bytes, static_cast<std::uint64_t>(width), 2);
    add(bytes, static_cast<std::uint64_t>(height), 2);
    add(bytes, 1, 2);
    add(bytes, bits, 2);
    if (bits > 8) return;
    add(bytes, 0, 3);
    for (unsigned i = 1; i < (1U << bits); ++i) add(bytes, 0x102030, 3);
}

void add_pixels(Bytes& bytes, const std::vector<int>& pixels) {
    for (const int byte : pixels) bytes.push_back(static_cast<std::byte>(byte));
}

TEST(BmpReader, AHotSpotIsNoReasonToRefuse) {
    for (const unsigned bits : {1U, 4U, 8U}) {
        Bytes bytes;
        const std::size_t header = 26 + 3 * (std::size_t{1} << bits);
        add_file_header(bytes, "BM", header);
        add_oldest_header(bytes, 2, 1, bits);
        add_pixels(bytes, {bits == 1 ? 0x40 : bits == 4 ? 0x01 : 0, bits == 8 ? 1 : 0, 0, 0});
        const auto picture = decode_picture(bytes);
        ASSERT_TRUE(picture) << picture.error().line;
        EXPECT_FALSE(is_lit(*picture, 0, 0));
        EXPECT_TRUE(is_lit(*picture, 1, 0));
    }
}

/// OS/2's 64-byte header may end after any of its fields; missing fields are 0.
TEST(BmpReader, HeadersOfOs2OfEveryLength) {
    for (std::size_t size = 16; size <= 64; size += 2) {
        if (size == 40 || size == 52 || size == 56) continue;  // these sizes are Windows headers
        SCOPED_TRACE(size);
        Bytes header;
        add(header, size, 4);
        add(header, 2, 4);
        add(header, 1, 4);
        add(header, 1, 2);
        add(header, 24, 2);
        header.resize(size);
        Bytes bytes;
        add_file_header(bytes, "BM", 14 + size);
        bytes.insert(bytes.end(), header.begin(), header.end());
        add_pixels(bytes, {9, 9, 9, 0x30, 0x20, 0x10, 0, 0});
        const auto picture = decode_picture(bytes);
        ASSERT_TRUE(picture) << picture.error().line;
        EXPECT_EQ(picture->width, 2);
        EXPECT_TRUE(is_lit(*picture, 1, 0));
    }
}

TEST(BmpReader, RunsOfThreeBytesAreOs2s) {
    Bytes bytes;
    add_file_header(bytes, "BM", 14 + 64);
    add(bytes, 64, 4);
    add(bytes, 4, 4);
    add(bytes, 1, 4);
    add(bytes, 1, 2);
    add(bytes, 24, 2);
    add(bytes, 4, 4);
    bytes.resize(14 + 64);
    // A run of two, a literal run of three whose last pixel lies beyond the side, a padding byte,
    // the end.
    add_pixels(bytes, {2, 0x30, 0x20, 0x10, 0, 3, 1, 1, 1, 0x30, 0x20, 0x10, 5, 5, 5, 0, 0, 1});
    const auto picture = decode_picture(bytes);
    ASSERT_TRUE(picture) << picture.error().line;
    for (int x = 0; x < 4; ++x) EXPECT_EQ(is_lit(*picture, x, 0), x != 2) << x;
}

/// An array holds the same picture for several kinds of screens.
TEST(BmpReader, OfAnArrayTheLargestIsTaken) {
    Bytes bytes;
    const std::size_t second = 14 + 26 + 6 + 4;
    add_file_header(bytes, "BA", 0);
    bytes.resize(6);
    add(bytes, second, 4);
    add(bytes, 0, 4);
    add_file_header(bytes, "BM", 14 + 26 + 6);
    add_oldest_header(bytes, 1, 1, 1);
    add_pixels(bytes, {0, 0, 0, 0});
    Bytes other;
    add_file_header(other, "BA", 0);
    other.resize(6);
    add(other, 0, 4);
    add(other, 0, 4);
    add_file_header(other, "BM", second + 14 + 26 + 6);
    add_oldest_header(other, 3, 1, 1);
    add_pixels(other, {0x60, 0, 0, 0});
    bytes.insert(bytes.end(), other.begin(), other.end());
    const auto picture = decode_picture(bytes);
    ASSERT_TRUE(picture) << picture.error().line;
    EXPECT_EQ(picture->width, 3);
    EXPECT_EQ(picture->height, 1);
    for (int x = 0; x < 3; ++x) EXPECT_EQ(is_lit(*picture, x, 0), x > 0) << x;
}

/// The bitmap is twice as high as the icon: the upper half masks what is not drawn; in the lower
/// half black becomes white.
TEST(BmpReader, IconsAndPointersOfOs2) {
    for (const auto* kind : {"IC", "PT"}) {
        Bytes bytes;
        add_file_header(bytes, kind, 26 + 6);
        add_oldest_header(bytes, 3, 2, 1);
        add_pixels(bytes, {0x40, 0, 0, 0, 0x20, 0, 0, 0});  // the last row comes first
        const auto picture = decode_picture(bytes);
        ASSERT_TRUE(picture) << picture.error().line;
        ASSERT_EQ(picture->height, 1);
        EXPECT_EQ(picture->bgr, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 255, 255, 255}));
    }
    for (const auto* kind : {"CI", "CP"}) {
        Bytes bytes;
        const std::size_t masks_at = 26 + 6 + 26;
        add_file_header(bytes, kind, masks_at);
        add_oldest_header(bytes, 3, 2, 1);
        add_file_header(bytes, kind, masks_at + 8);
        add_oldest_header(bytes, 3, 1, 24);
        add_pixels(bytes, {0, 0, 0, 0, 0x20, 0, 0, 0});
        add_pixels(bytes, {0x30, 0x20, 0x10, 1, 2, 3, 4, 5, 6, 0, 0, 0});
        const auto picture = decode_picture(bytes);
        ASSERT_TRUE(picture) << picture.error().line;
        ASSERT_EQ(picture->height, 1);
        EXPECT_EQ(picture->bgr,
                  (std::vector<std::uint8_t>{0x30, 0x20, 0x10, 1, 2, 3, 255, 255, 255}));
    }
}

TEST(BmpReader, PixelsAMetreMakeThemSquare) {
    Bytes bytes = bmp(4, 2, 24, 0, std::vector<int>(24, 90));
    const auto set = [&bytes](std::size_t at, unsigned value) {
        for (std::size_t i = 0; i < 4; ++i)
            bytes[at + i] = static_cast<std::byte>(value >> (8 * i) & 0xffU);
    };
    set(38, 8000);
    set(42, 4000);
    const auto picture = decode_picture(bytes);
    ASSERT_TRUE(picture) << picture.error().line;
    EXPECT_EQ(picture->width, 4);
    EXPECT_EQ(picture->height, 4);
    set(42, 0x80000000U);  // negative
    EXPECT_EQ(decode_picture(bytes)->height, 2);
}

TEST(BmpReader, WhatIsCutShortOrUnknownIsOneLine) {
    EXPECT_FALSE(decode_picture(bmp(5, 5, 24, 0, {1, 2, 3})).has_value());
    EXPECT_FALSE(decode_picture(bmp(5, 5, 8, 1, {1, 2, 3})).has_value());
    EXPECT_FALSE(decode_picture(bmp(5, 5, 24, 4, {})).has_value());  // a JPEG inside
    EXPECT_FALSE(decode_picture(bmp(5, 5, 7, 0, {})).has_value());
    EXPECT_FALSE(decode_picture(bmp(-5, 5, 8, 0, {})).has_value());
    EXPECT_FALSE(decode_picture(bmp(5, 0, 8, 0, {})).has_value());
    EXPECT_FALSE(decode_picture(bmp(5, static_cast<int>(0x80000000U), 8, 0, {})).has_value());
}

}  // namespace
}  // namespace touchline
