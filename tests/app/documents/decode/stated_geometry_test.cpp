// Tests what a file states about its pixels: which way is up, and their width over height. Each
// format states it in its own place.
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"
#include "tests/app/documents/decode/plain_tiff.h"
#include "tests/app/documents/decode/with_metadata.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>

namespace touchline {
namespace {

using encoders::Bytes;

constexpr int across_px = 64;
constexpr int down_px = 32;

/// White except for the upper left quarter, which is black: each of the eight orientations differs
/// in its dark corner or its longer side.
Picture dark_corner() {
    Picture picture{across_px, down_px, {}};
    for (int y = 0; y < down_px; ++y)
        for (int x = 0; x < across_px; ++x)
            picture.bgr.insert(
                picture.bgr.end(), 3,
                x < across_px / 2 && y < down_px / 2 ? std::uint8_t{0} : std::uint8_t{255});
    return picture;
}

bool is_dark(const Picture& picture, bool is_right, bool is_low) {
    const int x = (is_right ? 3 : 1) * picture.width / 4;
    const int y = (is_low ? 3 : 1) * picture.height / 4;
    return picture.bgr.at(3 * static_cast<std::size_t>(y * picture.width + x)) < 128;
}

/// Expects the upper left corner where EXIF 2.3, table 6 puts it.
void expect_turned(const Picture& picture, int orientation) {
    SCOPED_TRACE(orientation);
    const bool is_turned = orientation >= 5;
    EXPECT_EQ(picture.width, is_turned ? down_px : across_px);
    EXPECT_EQ(picture.height, is_turned ? across_px : down_px);
    const bool is_right =
        orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    const bool is_low =
        orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    for (const bool right : {false, true})
        for (const bool low : {false, true})
            EXPECT_EQ(is_dark(picture, right, low), right == is_right && low == is_low)
                << right << low;
}

void add_big_endian(Bytes& bytes, std::uint32_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::byte>(value >> (8 * (count - 1 - i)) & 0xffU));
}

/// Inserts the chunk after the header of a PNG.
Bytes with_chunk(Bytes png, const std::string& name, const Bytes& content) {
    Bytes named = encoders::bytes_of(name);
    named.insert(named.end(), content.begin(), content.end());
    Bytes chunk;
    add_big_endian(chunk, static_cast<std::uint32_t>(content.size()), 4);
    chunk.insert(chunk.end(), named.begin(), named.end());
    const auto sum =
        ::crc32(0, reinterpret_cast<const Bytef*>(named.data()), static_cast<uInt>(named.size()));
    add_big_endian(chunk, static_cast<std::uint32_t>(sum), 4);
    constexpr std::ptrdiff_t header_end = 8 + 25;
    png.insert(png.begin() + header_end, chunk.begin(), chunk.end());
    return png;
}

Bytes with_orientation(const Bytes& bytes, int orientation) {
    return with_metadata(bytes, [orientation](Exiv2::Image& image) {
        image.exifData()["Exif.Image.Orientation"] = static_cast<std::uint16_t>(orientation);
    });
}

/// An EXIF block in TIFF's form with one entry.
Bytes exif_of(int orientation) {
    Bytes exif =
        encoders::bytes_of(std::string("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01", 18));
    add_big_endian(exif, static_cast<std::uint32_t>(orientation) << 16U, 4);
    add_big_endian(exif, 0, 4);
    return exif;
}

Bytes lossless_webp() {
    std::vector<std::uint8_t> bgra;
    const Picture picture = dark_corner();
    for (std::size_t i = 0; i < picture.bgr.size(); i += 3)
        bgra.insert(bgra.end(), {picture.bgr[i], picture.bgr[i], picture.bgr[i], 255});
    return encoders::lossless_webp(across_px, down_px, bgra);
}

TEST(StatedOrientation, OfExifInEveryFormatThatHasIt) {
    for (int orientation = 1; orientation <= 8; ++orientation) {
        {
            SCOPED_TRACE("JPEG");
            encoders::JpegForm form;
            form.exif_orientation = orientation;
            expect_turned(decoded(encoders::jpeg(dark_corner(), form)), orientation);
        }
        {
            SCOPED_TRACE("PNG, eXIf");
            expect_turned(
                decoded(with_chunk(encoders::png(dark_corner()), "eXIf", exif_of(orientation))),
                orientation);
        }
        {
            SCOPED_TRACE("PNG, profile in a text");
            expect_turned(decoded(with_orientation(encoders::png(dark_corner()), orientation)),
                          orientation);
        }
        {
            SCOPED_TRACE("WebP");
            expect_turned(decoded(with_orientation(lossless_webp(), orientation)), orientation);
        }
        {
            SCOPED_TRACE("TIFF");
            expect_turned(decoded(encoders::tiff(dark_corner(), orientation)), orientation);
        }
    }
}

TEST(StatedOrientation, OfHeicAndAvif) {
    for (const bool is_avif : {false, true}) {
        for (int orientation = 1; orientation <= 8; ++orientation) {
            SCOPED_TRACE(is_avif ? "AVIF" : "HEIC");
            encoders::HeifForm form;
            form.is_avif = is_avif;
            form.orientation = orientation;
            expect_turned(decoded(encoders::heif(dark_corner(), form)), orientation);
        }
    }
}

/// Expects 64 x 32 pixels that are twice as high as wide to become 64 x 64, and pixels twice as
/// wide as high to become 128 x 32.
void expect_square(const Bytes& twice_across, const Bytes& twice_down) {
    const Picture high = decoded(twice_across);
    EXPECT_EQ(high.width, across_px);
    EXPECT_EQ(high.height, 2 * down_px);
    EXPECT_TRUE(is_dark(high, false, false));
    EXPECT_FALSE(is_dark(high, false, true));
    const Picture wide = decoded(twice_down);
    EXPECT_EQ(wide.width, 2 * across_px);
    EXPECT_EQ(wide.height, down_px);
}

Bytes png_of_pixels(std::uint32_t across, std::uint32_t down, unsigned unit) {
    Bytes content;
    add_big_endian(content, across, 4);
    add_big_endian(content, down, 4);
    add_big_endian(content, unit, 1);
    return with_chunk(encoders::png(dark_corner()), "pHYs", content);
}

TEST(StatedResolution, OfAPngByTheMetreOrAsAShape) {
    expect_square(png_of_pixels(4000, 2000, 1), png_of_pixels(2000, 4000, 1));
    expect_square(png_of_pixels(2, 1, 0), png_of_pixels(1, 2, 0));
    EXPECT_EQ(decoded(png_of_pixels(0, 0, 1)).height, down_px);
    EXPECT_EQ(decoded(png_of_pixels(0xffffffff, 1, 1)).height, down_px);
}

/// JFIF's segment comes first: mark 2, length 2, name 5, version 2, unit 1, densities 2 each.
Bytes jpeg_of_density(unsigned across, unsigned down, unsigned unit) {
    Bytes bytes = encoders::jpeg(dark_corner());
    Bytes told;
    add_big_endian(told, unit, 1);
    add_big_endian(told, across, 2);
    add_big_endian(told, down, 2);
    constexpr std::ptrdiff_t unit_at = 2 + 2 + 2 + 5 + 2;
    std::copy(told.begin(), told.end(), bytes.begin() + unit_at);
    return bytes;
}

Bytes with_exif_resolution(const Bytes& bytes, int across, int down) {
    return with_metadata(bytes, [across, down](Exiv2::Image& image) {
        image.exifData()["Exif.Image.XResolution"] = Exiv2::Rational(across, 1);
        image.exifData()["Exif.Image.YResolution"] = Exiv2::Rational(down, 1);
    });
}

TEST(StatedResolution, OfAJpegByJfifInEachUnit) {
    for (const unsigned unit : {0U, 1U, 2U})
        expect_square(jpeg_of_density(144, 72, unit), jpeg_of_density(72, 144, unit));
    EXPECT_EQ(decoded(jpeg_of_density(0, 0, 1)).height, down_px);
}

/// JFIF states an unknown density as 1 to 1 without a unit.
TEST(StatedResolution, OfExifWhereTheFormatKnowsNothing) {
    const Bytes jpeg = jpeg_of_density(1, 1, 0);
    expect_square(with_exif_resolution(jpeg, 144, 72), with_exif_resolution(jpeg, 72, 144));
    expect_square(with_exif_resolution(lossless_webp(), 144, 72),
                  with_exif_resolution(lossless_webp(), 72, 144));
    const Bytes png = encoders::png(dark_corner());
    expect_square(with_exif_resolution(png, 144, 72), with_exif_resolution(png, 72, 144));
    EXPECT_EQ(decoded(with_exif_resolution(jpeg_of_density(72, 72, 1), 144, 72)).height, down_px);
}

TEST(StatedResolution, OfATiff) {
    encoders::PlainTiff form;
    form.width = across_px;
    form.height = down_px;
    std::vector<std::uint64_t> samples;
    const Picture picture = dark_corner();
    for (std::size_t i = 0; i < picture.bgr.size(); i += 3) samples.push_back(picture.bgr[i]);
    form.x_resolution = 200;
    form.y_resolution = 100;
    const Bytes twice_across = plain_tiff(form, samples);
    form.x_resolution = 50;
    expect_square(twice_across, plain_tiff(form, samples));
}

/// libheif 1.15 writes the turned picture's size. The standard wants the stored picture's size,
/// which telephones write.
Bytes with_stored_size(Bytes bytes) {
    const std::string name = "ispe";
    Bytes turned = encoders::bytes_of(name);
    add_big_endian(turned, 0, 4);
    add_big_endian(turned, down_px, 4);
    add_big_endian(turned, across_px, 4);
    const auto found = std::search(bytes.begin(), bytes.end(), turned.begin(), turned.end());
    if (found != bytes.end()) std::swap_ranges(found + 8, found + 12, found + 12);
    return bytes;
}

TEST(StatedResolution, OfHeicAndAvifAlsoTurned) {
    for (const bool is_avif : {false, true}) {
        SCOPED_TRACE(is_avif ? "AVIF" : "HEIC");
        encoders::HeifForm high;
        high.is_avif = is_avif;
        high.pixel_height = 2;
        encoders::HeifForm wide;
        wide.is_avif = is_avif;
        wide.pixel_width = 2;
        expect_square(encoders::heif(dark_corner(), high), encoders::heif(dark_corner(), wide));
        wide.orientation = 6;  // turned, so 64 x 32 pixels of 2 x 1 become 32 x 128
        const Picture turned = decoded(with_stored_size(encoders::heif(dark_corner(), wide)));
        EXPECT_EQ(turned.width, down_px);
        EXPECT_EQ(turned.height, 2 * across_px);
    }
}

}  // namespace
}  // namespace touchline
