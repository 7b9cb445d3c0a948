// Tests that any SVG is a picture, however it is written, and that our own maps are maps.
#include "app/documents/decode/files.h"
#include "app/documents/decode/map_svg.h"
#include "app/documents/gallery/gallery.h"
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

namespace touchline {
namespace {

using encoders::bytes_of;

constexpr auto circle_and_box =
    R"(<circle cx="120" cy="150" r="70" fill="none" stroke="black" stroke-width="3"/>)"
    R"(<rect x="230" y="70" width="120" height="160"/>)";

std::string svg(const std::string& attributes, const std::string& inside = circle_and_box) {
    return fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" {}>{}</svg>)", attributes,
                       inside);
}

std::string at_size(const std::string& inside) {
    return svg(R"(width="400" height="300" viewBox="0 0 400 300")", inside);
}

Page page_of(const std::string& text) {
    auto page = decode_page(bytes_of(text));
    EXPECT_TRUE(page.has_value()) << page.error().line;
    return page ? std::move(*page) : Page{};
}

/// Returns true if a place of the drawing, in its own units, is dark.
bool is_dark(const Page& page, double x, double y, double width = 400.0) {
    const double px = page.picture.width / width;
    const auto at = static_cast<std::size_t>(std::lround(y * px)) *
                        static_cast<std::size_t>(page.picture.width) +
                    static_cast<std::size_t>(std::lround(x * px));
    return page.picture.bgr.at(3 * at) < 128;
}

void expect_circle_and_box(const Page& page) {
    EXPECT_TRUE(is_dark(page, 300, 150));   // inside the box
    EXPECT_TRUE(is_dark(page, 50, 150));    // on the circle
    EXPECT_FALSE(is_dark(page, 120, 150));  // inside the circle
}

std::string in_utf16(const std::string& text, bool is_big_endian) {
    std::string made = is_big_endian ? "\xfe\xff" : "\xff\xfe";
    for (const char c : text) made += is_big_endian ? std::string{'\0', c} : std::string{c, '\0'};
    return made;
}

std::string packed(const std::string& text) {
    z_stream stream{};
    deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY);
    std::string made(deflateBound(&stream, text.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(made.data());
    stream.avail_out = static_cast<uInt>(made.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    made.resize(stream.total_out);
    deflateEnd(&stream);
    return made;
}

TEST(Svg, IsKnownHoweverItIsWritten) {
    const std::string plain = at_size(circle_and_box);
    const std::string utf16 = "<?xml version=\"1.0\" encoding=\"UTF-16\"?>" + plain;
    const std::string comment(5000, 'c');
    const std::string entity =
        R"(<!DOCTYPE svg [<!ENTITY black "fill:#000">]>)" +
        at_size(R"(<circle cx="120" cy="150" r="70" style="fill:none;stroke:#000;stroke-width:3"/>)"
                R"(<rect x="230" y="70" width="120" height="160" style="&black;"/>)");
    // A public name, an address, and entities that the document itself declares.
    const std::string of_an_old_editor =
        R"(<?xml version="1.0" encoding="utf-8"?><!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.0//EN" )"
        R"("http://www.w3.org/TR/2001/REC-SVG-20010904/DTD/svg10.dtd" [)"
        R"(<!ENTITY ns_svg "http://www.w3.org/2000/svg"><!ENTITY black "fill:#000">]>)"
        R"(<svg xmlns="&ns_svg;" width="400" height="300" viewBox="0 0 400 300">)"
        R"(<circle cx="120" cy="150" r="70" style="fill:none;stroke:#000;stroke-width:3"/>)"
        R"(<rect x="230" y="70" width="120" height="160" style="&black;"/></svg>)";
    for (const std::string& text :
         {plain, "\xef\xbb\xbf" + plain, "<!-- " + comment + " -->\n" + plain,
          in_utf16(utf16, false), in_utf16(utf16, true), packed(plain), entity, of_an_old_editor})
        expect_circle_and_box(page_of(text));
}

TEST(Svg, APackedFileOfSomethingElseIsRefused) {
    for (const std::string& text : {packed("no picture"), packed(packed(at_size(circle_and_box))),
                                    packed(at_size(circle_and_box)).substr(0, 40)}) {
        const auto page = decode_page(bytes_of(text));
        ASSERT_FALSE(page.has_value());
        EXPECT_EQ(page.error().line.find('\n'), std::string::npos);
    }
}

TEST(Svg, AsLargeAsItsDrawingWhereItNamesNoSize) {
    const Page unsized = page_of(svg(""));
    EXPECT_EQ(unsized.picture.width, svg_longer_side_px);
    EXPECT_NEAR(unsized.picture.width / static_cast<double>(unsized.picture.height), 301.5 / 161.0,
                0.2);
    expect_circle_and_box(page_of(svg(R"(width="100%" height="100%" viewBox="0 0 400 300")")));
    const Page moved = page_of(
        svg(R"(width="100%" viewBox="-200 -150 400 300")",
            fmt::format(R"x(<g transform="translate(-200,-150)">{}</g>)x", circle_and_box)));
    expect_circle_and_box(moved);
    const Page wide =
        page_of(svg(R"(width="400" height="200" viewBox="0 0 100 100" preserveAspectRatio="none")",
                    R"(<rect x="20" y="20" width="60" height="60"/>)"));
    EXPECT_EQ(wide.picture.width, 2 * wide.picture.height);
    EXPECT_TRUE(is_dark(wide, 100, 50));
}

TEST(Svg, APixelIsANinetySixthOfAnInch) {
    const Page page = page_of(svg(R"(width="100mm" height="75mm")",
                                  R"(<rect x="0" y="0" width="188.98" height="283.46"/>)"));
    EXPECT_TRUE(is_dark(page, 45, 40, 100.0));
    EXPECT_FALSE(is_dark(page, 55, 40, 100.0));
}

TEST(Svg, TextsAreLabelsWhereTheyArePainted) {
    const std::string texts =
        R"(<text x="90" y="260" font-size="24">Circle</text>)"
        R"x(<g transform="translate(250 260)"><text class="l" id="b">Box</text></g>)x"
        R"(<text x="9" y="9" display="none">Hidden</text>)"
        R"(<defs><text id="d" x="9" y="90">Never</text></defs>)";
    const Page page = page_of(at_size("<style>.l{font-size:24px}</style>" + texts));
    ASSERT_EQ(page.told.labels.size(), 2U);
    EXPECT_EQ(page.told.labels[0].text, "Circle");
    EXPECT_EQ(page.told.labels[1].text, "Box");
    ASSERT_EQ(page.words.size(), 2U);
    const double px = page.picture.width / 400.0;
    EXPECT_NEAR(page.words[1].left, 250 * px, 4 * px);
    EXPECT_NEAR(page.words[1].bottom, 260 * px, 4 * px);
    EXPECT_GT(page.told.labels[1].place.x, 0.0);
    EXPECT_LT(page.told.labels[1].place.y, 0.0);
}

struct PlacedText {
    const char* text;
    double x, y;
};

/// Plotting programs label their axes like this: strokes of two or three screen pixels.
TEST(Svg, TinyTextsBesideAStyleSheetAreLabelsWhereTheyArePainted) {
    const Page page = page_of(at_size(
        "<style>.tick{font-size:8px;fill:#333} path{stroke:#000}</style><path d='M40 20V250H380'/>"
        "<text class='tick' x='20' y='60'>0.8</text><text x='20' y='160' font-size='8'>0.4</text>"
        "<text class='tick' x='200' y='262'>day</text>"));
    ASSERT_EQ(page.told.labels.size(), 3U);
    ASSERT_EQ(page.words.size(), 3U);
    const double px = page.picture.width / 400.0;
    const std::array<PlacedText, 3> wanted{{{"0.8", 20, 60}, {"0.4", 20, 160}, {"day", 200, 262}}};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto& [text, x, y] = wanted[i];
        EXPECT_EQ(page.told.labels[i].text, text);
        EXPECT_NEAR(page.words[i].left, x * px, 2 * px) << text;
        EXPECT_NEAR(page.words[i].bottom, y * px, 2 * px) << text;
    }
}

TEST(Svg, WhiteOnNothingHasADarkGround) {
    const Page white =
        page_of(at_size(R"(<rect x="100" y="100" width="200" height="100" fill="#fff"/>)"));
    EXPECT_FALSE(is_dark(white, 200, 150));
    EXPECT_TRUE(is_dark(white, 50, 50));
    const Page black = page_of(at_size(R"(<rect x="100" y="100" width="200" height="100"/>)"));
    EXPECT_TRUE(is_dark(black, 200, 150));
    EXPECT_FALSE(is_dark(black, 50, 50));
}

TEST(Svg, OnlyAMapOfOurOwnIsReadAsLines) {
    const std::string size = R"(width="116mm" height="84mm" viewBox="0 0 116 84")";
    const std::string line = R"(<path d="M10 10 L50 50" stroke="black" fill="none"/>)";
    EXPECT_FALSE(parse_own_map(svg(size, line), Area{}).has_value());
    EXPECT_TRUE(parse_own_map(svg(size + R"( data-difficulty="1")", line), Area{}).has_value());
    EXPECT_TRUE(parse_own_map(svg(size, R"(<path data-detail="1" d="M10 10 L50 50"/>)"), Area{})
                    .has_value());
    EXPECT_FALSE(parse_own_map(svg(R"(width="300mm" height="84mm" viewBox="0 0 300 84")",
                                   R"(<path data-detail="1" d="M10 10 L50 50"/>)"),
                               Area{})
                     .has_value());
}

TEST(Svg, EveryPictureOfTheGalleryComesThroughTheWorkerAsItsMap) {
    const std::vector<GalleryEntry> gallery = list_gallery(gallery_folder()).value();
    for (const GalleryEntry& entry : gallery) {
        const auto page = decode_page(read_file(entry.path).value());
        ASSERT_TRUE(page.has_value()) << page.error().line;
        const TactileMap map = read_map_svg(entry.path).value();
        EXPECT_EQ(page->told.area, map.area) << entry.path;
        ASSERT_EQ(page->told.outlines.size(), map.outlines.size()) << entry.path;
        for (std::size_t i = 0; i < map.outlines.size(); ++i)
            EXPECT_TRUE(page->told.outlines[i].points == map.outlines[i].points) << entry.path;
    }
}

}  // namespace
}  // namespace touchline
