// Real files through the real worker.
#include "app/decode/opening.h"

#include "tests/app/decode/decoding_here.h"
#include "tests/app/decode/encoders.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

namespace touchline {
namespace {

int open_descriptors() {
    int count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
        ++count;
    return count;
}

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST(Opening, GivesThePixelsThatTheDecoderGives) {
    for (const encoders::Bytes& file :
         {encoders::png(encoders::test_picture()), encoders::jpeg(encoders::test_picture()),
          encoders::lossy_webp(encoders::test_picture())}) {
        const auto page = open_page(file);
        ASSERT_TRUE(page.has_value()) << page.error().line;
        EXPECT_EQ(page->picture.bgr, decode_picture(file)->bgr);
        EXPECT_EQ(page->count, 1);
    }
}

TEST(Opening, DrawsASvgWithItsText) {
    const auto svg = bytes_of(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="400" height="200">)"
        R"(<rect width="100" height="100"/><text x="150" y="150" font-size="80">Fish</text></svg>)");
    EXPECT_EQ(kind_of(svg), WorkerKind::document);
    const auto page = open_page(svg);
    ASSERT_TRUE(page.has_value()) << page.error().line;
    EXPECT_EQ(page->picture.bgr, decode_picture(svg)->bgr);
}

TEST(Opening, ARefusalIsTheDecodersOwnLine) {
    const auto text = bytes_of("no picture at all");
    const auto page = open_page(text);
    ASSERT_FALSE(page.has_value());
    EXPECT_EQ(page.error().line, decode_picture(text).error().line);
    EXPECT_FALSE(open_page({}).has_value());
    EXPECT_FALSE(open_page(encoders::png(encoders::test_picture()), {2}).has_value());
}

TEST(Opening, LeavesNothingBehind) {
    const auto file = encoders::png(encoders::test_picture());
    (void)open_page(file);
    const int before = open_descriptors();
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(open_page(file).has_value());
    EXPECT_EQ(open_descriptors(), before);
}

TEST(Opening, WithoutTheProgramItSaysSo) {
    const std::string programs = std::getenv("TOUCHLINE_PROGRAMS");
    setenv("TOUCHLINE_PROGRAMS", "/nowhere", 1);
    const auto page = open_page(encoders::png(encoders::test_picture()));
    setenv("TOUCHLINE_PROGRAMS", programs.c_str(), 1);
    ASSERT_FALSE(page.has_value());
    EXPECT_NE(page.error().line.find("installed anew"), std::string::npos);
}

/// White, but for the middle ninth, which is black.
bool is_dark_at(int x, int y, int width, int height) {
    return x >= width / 3 && x < 2 * width / 3 && y >= height / 3 && y < 2 * height / 3;
}

void expect_dark_middle(const Picture& picture) {
    for (const int part : {1, 3, 5}) {
        const int x = part * picture.width / 6;
        const auto level = [&picture](int column, int row) {
            return picture.bgr.at(3 * static_cast<std::size_t>(row * picture.width + column));
        };
        EXPECT_NEAR(level(x, picture.height / 2), part == 3 ? 0 : 255, 6);
        EXPECT_NEAR(level(x, picture.height / 6), 255, 6);
    }
}

/// One bit a pixel: many pixels, and yet written fast.
encoders::Bytes large_png(int width, int height, bool is_interlaced) {
    std::vector<std::uint8_t> rows;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; x += 8)
            rows.push_back(is_dark_at(x, y, width, height) ? 0x00 : 0xff);
    return encoders::png(width, height, {PNG_COLOR_TYPE_GRAY, 1, is_interlaced}, rows);
}

TEST(Opening, APngOfAHundredMegapixelsIsMadeSmaller) {
    for (const bool is_interlaced : {false, true}) {
        const auto page = open_page(large_png(12'000, 9'000, is_interlaced));
        ASSERT_TRUE(page.has_value()) << page.error().line;
        EXPECT_EQ(page->picture.width, 3'000);
        EXPECT_EQ(page->picture.height, 2'250);
        EXPECT_EQ(page->picture.scale, 0.25);
        expect_dark_middle(page->picture);
    }
    const auto refused = open_page(large_png(12'000, 10'008, false));
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().line,
              "the PNG picture has 12000 x 10008 pixels, more than 120 megapixels or 80000 on a "
              "side; save it smaller");
}

Picture with_dark_middle(int width, int height) {
    Picture picture{width, height, {}};
    picture.bgr.resize(std::size_t{3} * static_cast<std::size_t>(width) *
                       static_cast<std::size_t>(height));
    std::uint8_t* to = picture.bgr.data();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x, to += 3)
            std::fill_n(to, 3,
                        static_cast<std::uint8_t>(is_dark_at(x, y, width, height) ? 0 : 255));
    return picture;
}

/// As telephones make them; encoding takes most of the time.
TEST(Opening, AHeicOfFortyEightMegapixelsIsMadeSmaller) {
    encoders::HeifForm form;
    form.quality = 40;
    const auto page = open_page(encoders::heif(with_dark_middle(8'064, 6'048), form));
    ASSERT_TRUE(page.has_value()) << page.error().line;
    EXPECT_EQ(page->picture.width, 4'032);
    EXPECT_EQ(page->picture.height, 3'024);
    expect_dark_middle(page->picture);
}

/// A filter that any renderer works at for minutes. How long is the sandbox's business
/// (policy_test).
TEST(Opening, ADrawingThatTakesForEverIsOneSentence) {
    const auto page = open_page(bytes_of(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1600 1600'><filter id='f' x='0' "
        "y='0' width='1' height='1'><feTurbulence baseFrequency='0.01' numOctaves='9'/>"
        "<feMorphology operator='dilate' radius='90'/><feMorphology operator='erode' "
        "radius='90'/></filter><rect width='1600' height='1600' "
        "filter='url(#f)'/></svg>"));
    ASSERT_FALSE(page.has_value());
    EXPECT_NE(page.error().line.find("takes too long"), std::string::npos) << page.error().line;
}

}  // namespace
}  // namespace touchline
