// Tests pictures with more pixels than are kept: each kept pixel is the mean of those it replaces,
// whatever order they come in.

#include "app/documents/decode/readers.h"
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

namespace touchline {
namespace {

using decode::reduced_side;
using decode::reduction_for;

TEST(Reduction, IsTheLeastThatFits) {
    EXPECT_EQ(reduction_for(6000, 4000), 1U);  // 24 megapixels
    EXPECT_EQ(reduction_for(6001, 4000), 2U);
    EXPECT_EQ(reduction_for(8064, 6048), 2U);
    EXPECT_EQ(reduction_for(12000, 9000), 4U);
    EXPECT_EQ(reduction_for(10000, 1), 1U);
    EXPECT_EQ(reduction_for(12000, 800), 2U);
    EXPECT_EQ(reduction_for(max_file_side_px, 1), 8U);
}

TEST(Reduction, LeavesAPictureWithinTheLimits) {
    std::mt19937 random(3);
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t width = 1 + random() % max_file_side_px;
        const std::uint64_t height =
            1 + random() % std::min(max_file_side_px, max_jpeg_pixels / width);
        const unsigned by = reduction_for(width, height);
        ASSERT_TRUE(fits_a_picture(reduced_side(width, by), reduced_side(height, by)))
            << width << ' ' << height;
    }
}

/// Rows of noise, the same for the same seed.
std::vector<std::uint8_t> noise_bytes(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(count);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() % 256);
    return bytes;
}

constexpr std::size_t long_side = 10'013;  // the last kept pixel replaces only one column
constexpr std::size_t short_side = 5;

/// The mean of the pixels, in floating point, over white.
double mean_of(const std::vector<std::uint8_t>& pixels, std::size_t channels, std::size_t x,
               std::size_t y, std::size_t part) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t row = 2 * y; row < std::min(2 * y + 2, short_side); ++row)
        for (std::size_t column = 2 * x; column < std::min(2 * x + 2, long_side); ++column) {
            const std::uint8_t* pixel = &pixels[channels * (row * long_side + column)];
            const double alpha = channels == 4 ? pixel[3] / 255.0 : 1.0;
            sum += alpha * pixel[part] + (1.0 - alpha) * 255.0;
            ++count;
        }
    return sum / count;
}

TEST(Shrinking, KeepsTheMeans) {
    for (const std::size_t channels : {3U, 4U}) {
        const auto pixels = noise_bytes(channels * long_side * short_side, 5);
        decode::Shrinking shrinking(long_side, short_side, channels);
        for (std::size_t y = short_side; y-- > 0;) {
            const std::span row =
                std::span(pixels).subspan(channels * long_side * y, channels * long_side);
            // The row's odd pixels, then its even pixels.
            for (const std::size_t first : {1U, 0U}) {
                std::vector<std::uint8_t> part;
                for (std::size_t x = first; x < long_side; x += 2)
                    part.insert(part.end(), &row[channels * x], &row[channels * x] + channels);
                shrinking.add_row(y, part, {first, 2});
            }
        }
        const Picture picture = std::move(shrinking).picture();
        ASSERT_EQ(picture.width, 5007);
        ASSERT_EQ(picture.height, 3);
        EXPECT_EQ(picture.scale, 0.5);
        ASSERT_EQ(picture.bgr.size(), 3U * 5007 * 3);
        for (std::size_t i = 0; i < picture.bgr.size(); ++i) {
            const std::size_t x = i / 3 % 5007;
            const std::size_t y = i / 3 / 5007;
            ASSERT_NEAR(picture.bgr[i], mean_of(pixels, channels, x, y, i % 3),
                        channels == 4 ? 2.0 : 0.51);
        }
    }
}

TEST(Shrinking, WhatLiesBesideThePictureIsLeftOut) {
    decode::Shrinking shrinking(2, 1, 3);
    const std::vector<std::uint8_t> row(30, 7);
    shrinking.add_row(0, row);
    shrinking.add_row(1, row);
    shrinking.add_row(0, row, {2, 1});
    EXPECT_EQ(std::move(shrinking).picture().bgr, std::vector<std::uint8_t>(6, 7));
}

/// A picture 12000 wide; its columns are light and dark in turn, 40 pixels each.
constexpr int panorama_width = 12'000;
constexpr int panorama_height = 64;

std::uint8_t panorama_level(int x) {
    return x / 40 % 2 == 0 ? 255 : 20;
}

Picture panorama() {
    Picture picture{panorama_width, panorama_height, {}};
    for (int i = 0; i < panorama_width * panorama_height; ++i)
        picture.bgr.insert(picture.bgr.end(), 3, panorama_level(i % panorama_width));
    return picture;
}

void expect_panorama(const encoders::Bytes& bytes, int most) {
    const Picture picture = decoded(bytes);
    ASSERT_EQ(picture.width, panorama_width / 2);
    ASSERT_EQ(picture.height, panorama_height / 2);
    EXPECT_EQ(picture.scale, 0.5);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            ASSERT_NEAR(picture.bgr[3 * static_cast<std::size_t>(y * picture.width + x)],
                        panorama_level(2 * x), most);
}

TEST(Shrinking, APanoramaOfEveryFormat) {
    const Picture picture = panorama();
    const std::vector<std::uint8_t> rgb = encoders::rgb_of(picture);
    std::vector<std::uint8_t> bgra;
    for (const std::uint8_t byte : picture.bgr) {
        bgra.push_back(byte);
        if (bgra.size() % 4 == 3) bgra.push_back(255);
    }
    {
        SCOPED_TRACE("PNG");
        expect_panorama(encoders::png(picture), 0);
    }
    {
        SCOPED_TRACE("interlaced PNG");
        expect_panorama(
            encoders::png(panorama_width, panorama_height, {PNG_COLOR_TYPE_RGB, 8, true}, rgb), 0);
    }
    {
        SCOPED_TRACE("TIFF");
        expect_panorama(encoders::tiff(picture), 0);
    }
    {
        SCOPED_TRACE("WebP");
        expect_panorama(encoders::lossless_webp(panorama_width, panorama_height, bgra), 1);
        expect_panorama(encoders::lossy_webp(picture), 30);
    }
    {
        SCOPED_TRACE("JPEG");
        expect_panorama(encoders::jpeg(picture), 30);
    }
    {
        SCOPED_TRACE("PPM");
        encoders::Bytes ppm = encoders::bytes_of("P6 12000 64 255\n");
        const auto pixels = std::as_bytes(std::span(rgb));
        ppm.insert(ppm.end(), pixels.begin(), pixels.end());
        expect_panorama(ppm, 0);
    }
    for (const bool is_avif : {false, true}) {
        SCOPED_TRACE(is_avif ? "AVIF" : "HEIC");
        encoders::HeifForm form;
        form.is_avif = is_avif;
        expect_panorama(encoders::heif(picture, form), 30);
    }
}

}  // namespace
}  // namespace touchline
