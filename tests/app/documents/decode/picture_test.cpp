// Tests every format both ways: its library encodes, our reader reads back.
#include "app/documents/decode/picture.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/readers.h"
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <gtest/gtest.h>
#include <png.h>
#include <tiff.h>
#include <unistd.h>

namespace touchline {
namespace {

void expect_same(const Picture& actual, const Picture& expected) {
    EXPECT_EQ(actual.width, expected.width);
    EXPECT_EQ(actual.height, expected.height);
    EXPECT_TRUE(actual.bgr == expected.bgr);  // EXPECT_EQ would print every byte
    EXPECT_EQ(actual.scale, expected.scale);
}

int worst_difference(const Picture& a, const Picture& b) {
    EXPECT_EQ(a.bgr.size(), b.bgr.size());
    int worst = 0;
    for (std::size_t i = 0; i < std::min(a.bgr.size(), b.bgr.size()); ++i) {
        worst = std::max(worst, std::abs(int{a.bgr[i]} - int{b.bgr[i]}));
    }
    return worst;
}

/// Returns a picture with one pixel for each grey.
Picture greys(const std::vector<std::uint8_t>& values) {
    Picture picture{static_cast<int>(values.size()), 1, {}};
    for (const auto value : values) picture.bgr.insert(picture.bgr.end(), 3, value);
    return picture;
}

std::vector<std::uint8_t> every_byte_twice(const std::vector<std::uint8_t>& bytes) {
    std::vector<std::uint8_t> twice;
    for (const auto byte : bytes) twice.insert(twice.end(), 2, byte);
    return twice;
}

TEST(PngReader, ColourComesBackExactly) {
    const Picture picture = encoders::test_picture();
    expect_same(decoded(encoders::png(picture)), picture);
}

TEST(PngReader, InterlacedIsTheSame) {
    const Picture picture = encoders::test_picture();
    const auto file = encoders::png(picture.width, picture.height, {PNG_COLOR_TYPE_RGB, 8, true},
                                    encoders::rgb_of(picture));
    expect_same(decoded(file), picture);
}

TEST(PngReader, SixteenBitsAreReducedWithoutBrightening) {
    const Picture picture = encoders::test_picture();
    const auto file = encoders::png(picture.width, picture.height, {PNG_COLOR_TYPE_RGB, 16},
                                    every_byte_twice(encoders::rgb_of(picture)));
    expect_same(decoded(file), picture);
}

TEST(PngReader, GreyOfOneAndEightBitsIsExpanded) {
    expect_same(decoded(encoders::png(8, 1, {PNG_COLOR_TYPE_GRAY, 1}, {0b10110010})),
                greys({255, 0, 255, 255, 0, 0, 255, 0}));
    expect_same(decoded(encoders::png(3, 1, {PNG_COLOR_TYPE_GRAY, 8}, {7, 99, 250})),
                greys({7, 99, 250}));
}

TEST(PngReader, AlphaLiesOverWhite) {
    const std::vector<std::uint8_t> rgba{10, 20, 30, 255, 10, 20, 30, 0, 0, 0, 0, 128};
    for (const bool is_interlaced : {false, true}) {
        const Picture picture =
            decoded(encoders::png(3, 1, {PNG_COLOR_TYPE_RGB_ALPHA, 8, is_interlaced}, rgba));
        EXPECT_EQ(picture.bgr,
                  (std::vector<std::uint8_t>{30, 20, 10, 255, 255, 255, 127, 127, 127}));
    }
    expect_same(decoded(encoders::png(2, 1, {PNG_COLOR_TYPE_GRAY_ALPHA, 16},
                                      {0, 0, 0xff, 0xff, 0, 0, 0, 0})),
                greys({0, 255}));
}

TEST(PngReader, PaletteWithTransparentColoursIsExpanded) {
    const encoders::PngForm form{
        PNG_COLOR_TYPE_PALETTE, 8, false, {1, 2, 3, 50, 60, 70, 9, 9, 9}, {255, 255, 0}};
    EXPECT_EQ(decoded(encoders::png(3, 1, form, {1, 0, 2})).bgr,
              (std::vector<std::uint8_t>{70, 60, 50, 3, 2, 1, 255, 255, 255}));
}

TEST(JpegReader, ColourGreyAndProgressiveComeBackClosely) {
    const Picture picture = encoders::test_picture(64, 48);
    EXPECT_LE(worst_difference(decoded(encoders::jpeg(picture)), picture), 12);
    encoders::JpegForm progressive;
    progressive.is_progressive = true;
    EXPECT_LE(worst_difference(decoded(encoders::jpeg(picture, progressive)), picture), 12);
    encoders::JpegForm grey;
    grey.channels = 1;
    const std::vector<std::uint8_t> ramp{0, 30, 60, 90, 120, 150, 180, 210};
    EXPECT_LE(worst_difference(decoded(encoders::jpeg(8, 1, grey, ramp)), greys(ramp)), 6);
}

TEST(SquarePixels, TheCoarserSideGrows) {
    const Picture fax{4, 2, std::vector<std::uint8_t>(24, 90)};
    const Picture square = decode::with_square_pixels(fax, {204.0, 98.0});
    EXPECT_EQ(square.width, 4);
    EXPECT_EQ(square.height, 4);
    EXPECT_EQ(square.bgr, std::vector<std::uint8_t>(48, 90));
    EXPECT_EQ(decode::with_square_pixels(fax, {98.0, 204.0}).width, 8);
}

TEST(SquarePixels, WhatIsNotKnownOrBeyondBeliefChangesNothing) {
    const Picture fax{4, 2, std::vector<std::uint8_t>(24, 90)};
    for (const auto& [x, y] : {std::pair{0.0, 0.0},
                               {72.0, 0.0},
                               {0.0, 72.0},
                               {72.0, 72.0},
                               {std::nan(""), 1.0},
                               {1.0, 1000.0},
                               {-1.0, 1.0}})
        EXPECT_EQ(decode::with_square_pixels(fax, {x, y}).bgr, fax.bgr);
}

/// Every row is there: some programs omit the end mark, and some telephones append films.
TEST(JpegReader, IsWholeWithoutItsEndMarkAndWithWhatFollowsIt) {
    const Picture picture = encoders::test_picture();
    encoders::JpegForm progressive;
    progressive.is_progressive = true;
    for (const encoders::Bytes& whole :
         {encoders::jpeg(picture), encoders::jpeg(picture, progressive)}) {
        encoders::Bytes bytes = whole;
        bytes.resize(bytes.size() - 2);
        EXPECT_EQ(decoded(bytes).bgr, decoded(whole).bgr);
    }
    encoders::Bytes trailed = encoders::jpeg(picture);
    trailed.resize(trailed.size() - 2);
    for (const int byte : {0x00, 0x00, 0x30, 0x0b, 0xff, 0x4f, 0xff, 0x51, 0x7f})
        trailed.push_back(static_cast<std::byte>(byte));
    EXPECT_EQ(decoded(trailed).bgr, decoded(encoders::jpeg(picture)).bgr);
}

TEST(JpegReader, PrintingInksBecomeLightInBothConventions) {
    // Full cyan, half magenta, no yellow, a fifth of black.
    const std::vector<std::uint8_t> inks{255, 128, 0, 51};
    std::vector<std::uint8_t> plain;
    std::vector<std::uint8_t> inverted;
    for (int i = 0; i < 64; ++i) {
        for (const auto ink : inks) {
            plain.push_back(ink);
            inverted.push_back(static_cast<std::uint8_t>(255 - ink));
        }
    }
    encoders::JpegForm form;
    form.channels = 4;
    form.has_adobe_marker = false;
    const auto expected = std::vector<int>{204, 102, 0};  // blue, green, red
    for (const auto& file :
         {encoders::jpeg(8, 8, form, plain), encoders::jpeg(8, 8, {4, false, true}, inverted)}) {
        const Picture picture = decoded(file);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(picture.bgr[i], expected[i], 3);
    }
}

TEST(JpegReader, OrientationOfTheCameraIsApplied) {
    const Picture picture = encoders::test_picture(64, 48);
    encoders::JpegForm form;
    const Picture stored = decoded(encoders::jpeg(picture, form));
    for (int orientation = 1; orientation <= 8; ++orientation) {
        form.exif_orientation = orientation;
        expect_same(decoded(encoders::jpeg(picture, form)), decode::upright(stored, orientation));
    }
}

TEST(JpegReader, MoreThanTwentyFourMegapixelsAreDecodedSmaller) {
    encoders::JpegForm grey;
    grey.channels = 1;
    grey.quality = 50;
    const std::vector<std::uint8_t> pixels(std::size_t{6000} * 4200, 100);
    const Picture picture = decoded(encoders::jpeg(6000, 4200, grey, pixels));
    EXPECT_EQ(picture.width, 3000);
    EXPECT_EQ(picture.height, 2100);
    EXPECT_EQ(picture.scale, 0.5);
    EXPECT_NEAR(picture.bgr[12345], 100, 2);
}

/// Independent of the code: the eight orientations are flips and a transposition.
Picture flipped_x(const Picture& in) {
    Picture out = in;
    for (int y = 0; y < in.height; ++y) {
        for (int x = 0; x < in.width; ++x) {
            std::copy_n(&in.bgr[static_cast<std::size_t>(3 * (y * in.width + x))], 3,
                        &out.bgr[static_cast<std::size_t>(3 * (y * in.width + in.width - 1 - x))]);
        }
    }
    return out;
}

Picture transposed(const Picture& in) {
    Picture out{in.height, in.width, std::vector<std::uint8_t>(in.bgr.size())};
    for (int y = 0; y < in.height; ++y) {
        for (int x = 0; x < in.width; ++x) {
            std::copy_n(&in.bgr[static_cast<std::size_t>(3 * (y * in.width + x))], 3,
                        &out.bgr[static_cast<std::size_t>(3 * (x * in.height + y))]);
        }
    }
    return out;
}

Picture flipped_y(const Picture& in) {
    return transposed(flipped_x(transposed(in)));
}

Picture turned(const Picture& in, int orientation) {
    switch (orientation) {
        case 2:
            return flipped_x(in);
        case 3:
            return flipped_x(flipped_y(in));
        case 4:
            return flipped_y(in);
        case 5:
            return transposed(in);
        case 6:
            return flipped_x(transposed(in));
        case 7:
            return flipped_x(flipped_y(transposed(in)));
        case 8:
            return flipped_y(transposed(in));
        default:
            return in;
    }
}

TEST(TiffReader, ColourComesBackExactlyInAllOrientations) {
    const Picture picture = encoders::test_picture();
    for (int orientation = 1; orientation <= 8; ++orientation) {
        SCOPED_TRACE(orientation);
        expect_same(decoded(encoders::tiff(picture, orientation)), turned(picture, orientation));
    }
}

TEST(TiffReader, GreyPaletteSixteenBitsAndInksAreExpanded) {
    expect_same(decoded(encoders::tiff(3, 1, {PHOTOMETRIC_MINISBLACK, 1}, {7, 99, 250})),
                greys({7, 99, 250}));
    expect_same(decoded(encoders::tiff(3, 1, {PHOTOMETRIC_MINISWHITE, 1}, {7, 99, 250})),
                greys({248, 156, 5}));
    encoders::TiffForm deep{PHOTOMETRIC_MINISBLACK, 1};
    deep.bits_per_sample = 16;
    expect_same(decoded(encoders::tiff(3, 1, deep, {7, 7, 99, 99, 250, 250})), greys({7, 99, 250}));
    encoders::TiffForm palette{PHOTOMETRIC_PALETTE, 1};
    palette.palette_rgb.resize(768);
    for (std::uint16_t i = 0; i < 256; ++i) {
        for (const std::size_t plane : {0U, 256U, 512U}) {
            palette.palette_rgb[plane + i] = static_cast<std::uint16_t>((255 - i) * 257);
        }
    }
    expect_same(decoded(encoders::tiff(2, 1, palette, {0, 250})), greys({255, 5}));
    const Picture inks =
        decoded(encoders::tiff(1, 1, {PHOTOMETRIC_SEPARATED, 4}, {255, 128, 0, 51}));
    EXPECT_NEAR(inks.bgr[0], 204, 1);
    EXPECT_NEAR(inks.bgr[1], 102, 1);
    EXPECT_EQ(inks.bgr[2], 0);
}

TEST(TiffReader, AlphaLiesOverWhite) {
    encoders::TiffForm form{PHOTOMETRIC_RGB, 4};
    form.extra_sample = EXTRASAMPLE_UNASSALPHA;
    EXPECT_EQ(decoded(encoders::tiff(3, 1, form, {10, 20, 30, 255, 9, 9, 9, 0, 0, 0, 0, 128})).bgr,
              (std::vector<std::uint8_t>{30, 20, 10, 255, 255, 255, 127, 127, 127}));
}

TEST(TiffReader, TheFirstPageIsTaken) {
    const Picture picture = encoders::test_picture();
    encoders::TiffForm form{PHOTOMETRIC_RGB, 3};
    form.pages = 3;
    expect_same(
        decoded(encoders::tiff(picture.width, picture.height, form, encoders::rgb_of(picture))),
        picture);
}

encoders::TiffDirectory directory_of(const Picture& picture, std::uint32_t subfile_type) {
    encoders::TiffForm form{PHOTOMETRIC_RGB, 3};
    form.subfile_type = subfile_type;
    return {picture.width, picture.height, form, encoders::rgb_of(picture)};
}

/// Scanners and editors write a small copy or a mask before the picture.
TEST(TiffReader, APreviewOrAMaskBeforeThePictureIsNotTaken) {
    const Picture picture = encoders::test_picture(64, 48);
    const auto whole = directory_of(picture, 0);
    const auto preview = directory_of(encoders::test_picture(16, 12), FILETYPE_REDUCEDIMAGE);
    encoders::TiffForm mask_form{PHOTOMETRIC_MASK, 1, 1};
    mask_form.subfile_type = FILETYPE_MASK;
    const encoders::TiffDirectory mask{64, 48, mask_form, std::vector<std::uint8_t>(8 * 48, 0xf0)};
    expect_same(decoded(encoders::tiff({preview, whole})), picture);
    expect_same(decoded(encoders::tiff({mask, whole})), picture);
    expect_same(decoded(encoders::tiff({preview, mask, whole, preview})), picture);
    expect_same(decoded(encoders::tiff({directory_of(picture, FILETYPE_PAGE), preview})), picture);
}

TEST(TiffReader, OfPreviewsAloneTheFirstIsTaken) {
    const Picture first = encoders::test_picture(16, 12);
    expect_same(decoded(encoders::tiff(
                    {directory_of(first, FILETYPE_REDUCEDIMAGE),
                     directory_of(encoders::test_picture(64, 48), FILETYPE_REDUCEDIMAGE)})),
                first);
}

TEST(WebpReader, LosslessComesBackExactlyAndLossyClosely) {
    const Picture picture = encoders::test_picture(64, 48);
    std::vector<std::uint8_t> bgra;
    for (std::size_t i = 0; i < picture.bgr.size(); i += 3) {
        bgra.insert(bgra.end(), {picture.bgr[i], picture.bgr[i + 1], picture.bgr[i + 2], 255});
    }
    expect_same(decoded(encoders::lossless_webp(64, 48, bgra)), picture);
    EXPECT_LE(worst_difference(decoded(encoders::lossy_webp(picture)), picture), 20);
}

TEST(WebpReader, AlphaLiesOverWhite) {
    const auto file = encoders::lossless_webp(3, 1, {30, 20, 10, 255, 9, 9, 9, 0, 0, 0, 0, 128});
    EXPECT_EQ(decoded(file).bgr,
              (std::vector<std::uint8_t>{30, 20, 10, 255, 255, 255, 127, 127, 127}));
}

TEST(WebpReader, AMovingPictureIsRefused) {
    const auto picture = decode_picture(encoders::moving_webp(encoders::test_picture()));
    ASSERT_FALSE(picture);
    EXPECT_EQ(picture.error().line, "the WebP picture moves; save one frame of it as PNG or JPEG");
}

TEST(SvgPicture, IsDrawnOverWhiteInItsProportions) {
    const Picture picture = decoded(encoders::bytes_of(
        R"(<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 100">
           <rect x="100" width="100" height="100" fill="#0000ff"/></svg>)"));
    EXPECT_EQ(picture.width, svg_longer_side_px);
    EXPECT_EQ(picture.height, svg_longer_side_px / 2);
    EXPECT_EQ((std::vector<std::uint8_t>(picture.bgr.begin(), picture.bgr.begin() + 3)),
              (std::vector<std::uint8_t>{255, 255, 255}));
    EXPECT_EQ((std::vector<std::uint8_t>(picture.bgr.end() - 3, picture.bgr.end())),
              (std::vector<std::uint8_t>{255, 0, 0}));
}

TEST(SvgPicture, OpensNoOtherFile) {
    const std::string path =
        testing::TempDir() + "touchline-secret-" + std::to_string(::getpid()) + ".png";
    ASSERT_TRUE(write_png(path, Picture{1, 1, {0, 0, 0}}));
    const Picture picture = decoded(encoders::bytes_of(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 3"><image href="file://)" + path +
        R"(" width="4" height="3"/></svg>)"));
    ::unlink(path.c_str());
    EXPECT_TRUE(std::all_of(picture.bgr.begin(), picture.bgr.end(),
                            [](std::uint8_t byte) { return byte == 255; }));
}

constexpr int icon_px = 24;

bool is_ink(int x, int y) {
    return x >= 8 && x < 16 && y >= 8 && y < 16;
}

/// A square of ink on a transparent ground: `channels` of ink a pixel, then alpha.
std::vector<std::uint8_t> icon(std::uint8_t ink, std::size_t channels) {
    std::vector<std::uint8_t> samples;
    for (int y = 0; y < icon_px; ++y)
        for (int x = 0; x < icon_px; ++x) {
            samples.insert(samples.end(), channels, ink);
            samples.push_back(is_ink(x, y) ? 255 : 0);
        }
    return samples;
}

void expect_on_ground(const Picture& picture, std::uint8_t ink) {
    ASSERT_EQ(picture.width, icon_px);
    ASSERT_EQ(picture.height, icon_px);
    for (int y = 0; y < icon_px; ++y)
        for (int x = 0; x < icon_px; ++x) {
            const int wanted = is_ink(x, y) ? ink : 255 - ink;
            ASSERT_EQ(picture.bgr[static_cast<std::size_t>(3 * (y * icon_px + x))], wanted)
                << x << ' ' << y;
        }
}

TEST(TransparentPicture, LiesOnTheGroundThatShowsItsInk) {
    for (const std::uint8_t ink : {std::uint8_t{255}, std::uint8_t{0}}) {
        SCOPED_TRACE(int{ink});
        const auto rgba = icon(ink, 3);
        const auto png_of = [](const encoders::PngForm& form,
                               const std::vector<std::uint8_t>& samples) {
            return decoded(encoders::png(icon_px, icon_px, form, samples));
        };
        expect_on_ground(png_of({PNG_COLOR_TYPE_RGB_ALPHA, 8}, rgba), ink);
        expect_on_ground(png_of({PNG_COLOR_TYPE_RGB_ALPHA, 8, true}, rgba), ink);
        expect_on_ground(png_of({PNG_COLOR_TYPE_GRAY_ALPHA, 8}, icon(ink, 1)), ink);
        std::vector<std::uint8_t> indices = icon(0, 0);
        for (std::uint8_t& index : indices) index = index > 0 ? 1 : 0;
        const encoders::PngForm palette{
            PNG_COLOR_TYPE_PALETTE, 8, false, {9, 9, 9, ink, ink, ink}, {0, 255}};
        expect_on_ground(png_of(palette, indices), ink);
        expect_on_ground(decoded(encoders::lossless_webp(icon_px, icon_px, rgba)), ink);
        encoders::TiffForm form{PHOTOMETRIC_RGB, 4};
        form.extra_sample = EXTRASAMPLE_UNASSALPHA;
        expect_on_ground(decoded(encoders::tiff(icon_px, icon_px, form, rgba)), ink);
    }
}

TEST(PngWriter, WhatIsWrittenReadsBack) {
    const std::string path =
        testing::TempDir() + "touchline-written-" + std::to_string(::getpid()) + ".png";
    const Picture picture = encoders::test_picture();
    ASSERT_TRUE(write_png(path, picture));
    const auto read = read_picture(path);
    ASSERT_TRUE(read) << read.error().line;
    expect_same(*read, picture);

    const std::vector<std::uint8_t> grey{1, 50, 200};
    ASSERT_TRUE(write_png(path, GreyView{3, 1, grey}));
    expect_same(read_picture(path).value(), greys(grey));
    ::unlink(path.c_str());
}

TEST(PngWriter, APictureWithoutItsPixelsIsRefusedAndLeavesNoFile) {
    const std::string path = testing::TempDir() + "touchline-never.png";
    EXPECT_FALSE(write_png(path, Picture{}));
    EXPECT_FALSE(write_png(path, Picture{2, 2, {1, 2, 3}}));
    EXPECT_FALSE(write_png(path, GreyView{-1, 1, {}}));
    EXPECT_NE(::access(path.c_str(), F_OK), 0);
}

}  // namespace
}  // namespace touchline
