// Real files through the real worker.
#include "app/decode/opening.h"

#include "tests/app/decode/decoding_here.h"
#include "tests/app/decode/encoders.h"

#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

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
