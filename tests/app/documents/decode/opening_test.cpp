// Tests real files with the real worker.
#include "app/documents/decode/opening.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"
#include "tests/config/scratch_folder.h"

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

TEST(Opening, ATextBesideThePictureTellsOfIt) {
    const ScratchFolder folder;
    const std::string fish =
        folder.write("fish.png", as_text(encoders::png(encoders::test_picture())));
    EXPECT_EQ(open_page_of(fish)->told.title, "");
    for (const char* name : {"fish.png.txt", "Fish2.txt"}) folder.write(name, "Of another\none");
    EXPECT_EQ(open_page_of(fish)->told.title, "") << "no text has its name";
    folder.write("fish.txt", "The fish\nIt swims to the left.\n");
    const auto told = open_page_of(fish);
    ASSERT_TRUE(told.has_value()) << told.error().line;
    EXPECT_EQ(told->told.title, "The fish");
    EXPECT_EQ(told->told.description, "It swims to the left.");
    EXPECT_EQ(told->picture.bgr, open_page(encoders::png(encoders::test_picture()))->picture.bgr);
    folder.write("fish.txt", std::string(max_side_car_bytes + 1, 'a'));
    EXPECT_EQ(open_page_of(fish)->told.description, "") << "too long to be read";
    const std::string alone = folder.write("text.txt", "no picture");
    EXPECT_EQ(open_page_of(alone).error().line.find(alone + ": "), 0U);
}

/// The text's words replace the file's own.
TEST(Opening, ATextBesideTheDrawingGoesBeforeItsOwnTitle) {
    const ScratchFolder folder;
    const std::string drawing = folder.write(
        "map.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><title>Plan</title>"
        "<rect width='5' height='5'/></svg>");
    EXPECT_EQ(open_page_of(drawing)->told.title, "Plan");
    folder.write("map.txt", "The square\nAt the upper left.");
    EXPECT_EQ(open_page_of(drawing)->told.title, "The square");
    EXPECT_EQ(open_page_of(drawing)->told.description, "At the upper left.");
}

/// White except for the middle ninth, which is black.
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

/// One bit a pixel: many pixels, but quick to write.
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

/// A common size of telephone pictures.
constexpr int large_width = 8'064;
constexpr int large_height = 6'048;

void expect_half_as_large(const encoders::Bytes& bytes, int width = large_width,
                          int height = large_height) {
    const auto page = open_page(bytes);
    ASSERT_TRUE(page.has_value()) << page.error().line;
    EXPECT_EQ(page->picture.width, width / 2);
    EXPECT_EQ(page->picture.height, height / 2);
    EXPECT_EQ(page->picture.scale, 0.5);
    expect_dark_middle(page->picture);
}

/// Encoding takes most of the test's time.
TEST(Opening, AHeicOfFortyEightMegapixelsIsMadeSmaller) {
    encoders::HeifForm form;
    form.quality = 40;
    expect_half_as_large(encoders::heif(with_dark_middle(large_width, large_height), form));
}

/// The picture has 48 megapixels with TOUCHLINE_EXHAUSTIVE, otherwise 27: the encoder takes a
/// quarter of a minute.
TEST(Opening, AnAvifOfManyMegapixelsIsMadeSmaller) {
    const bool is_exhaustive = std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr;
    const int width = is_exhaustive ? large_width : 6'048;
    const int height = is_exhaustive ? large_height : 4'536;
    encoders::HeifForm form;
    form.is_avif = true;
    form.quality = 40;
    expect_half_as_large(encoders::heif(with_dark_middle(width, height), form), width, height);
}

TEST(Opening, ATiffOfFortyEightMegapixelsIsMadeSmaller) {
    expect_half_as_large(encoders::tiff(with_dark_middle(large_width, large_height)));
}

TEST(Opening, AWebpOfFortyEightMegapixelsIsMadeSmaller) {
    expect_half_as_large(encoders::lossy_webp(with_dark_middle(large_width, large_height)));
}

TEST(Opening, ALosslessWebpOfFortyEightMegapixelsIsMadeSmaller) {
    const Picture picture = with_dark_middle(large_width, large_height);
    std::vector<std::uint8_t> bgra;
    bgra.reserve(picture.bgr.size() / 3 * 4);
    for (std::size_t i = 0; i < picture.bgr.size(); i += 3)
        bgra.insert(bgra.end(), {picture.bgr[i], picture.bgr[i], picture.bgr[i], 255});
    expect_half_as_large(encoders::lossless_webp(large_width, large_height, bgra));
}

/// Any renderer needs minutes for this filter. The sandbox limits the time (policy_test).
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
