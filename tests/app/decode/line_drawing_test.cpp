// Drawings of anybody, read as lines or looked at.
#include "app/decode/files.h"
#include "app/decode/map_svg.h"
#include "app/gallery/gallery.h"
#include "tests/app/decode/decoding_here.h"
#include "tests/app/decode/encoders.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

std::string svg(const std::string& attributes, const std::string& inside) {
    return fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" {}>{}</svg>)", attributes,
                       inside);
}

bool is_lines(const std::string& inside) {
    return parse_line_drawing(svg(R"(viewBox="0 0 100 100")", inside), Area{}).has_value();
}

TEST(LineDrawing, StrokesAreLines) {
    EXPECT_TRUE(is_lines(R"(<path d="M0 0 L50 50" stroke="red" fill="none"/>)"));
    EXPECT_TRUE(is_lines(R"(<line x2="9" y2="9" stroke="red"/>)"));
    EXPECT_TRUE(is_lines(R"(<g style="fill:none; stroke:#000"><circle cx="9" cy="9" r="5"/></g>)"));
}

TEST(LineDrawing, FillsThatCoverNothingAreTheirEdges) {
    EXPECT_TRUE(is_lines(R"(<rect width="10" height="10"/><rect x="20" width="10" height="10"/>)"));
}

TEST(LineDrawing, WhateverNeedsALookIsNone) {
    for (const char* inside :
         {R"(<rect width="10" height="10"/><rect x="5" width="10" height="10"/>)",
          R"(<rect width="100" height="100"/>)", R"(<rect width="9" height="9" fill="white"/>)",
          R"(<path d="M0 0 L50 50" fill="none"/>)", R"(<use href="#a"/>)",
          R"(<image href="a.png" width="9" height="9"/>)",
          R"(<style>.a{fill:red}</style><rect width="9" height="9"/>)",
          R"(<rect class="a" width="9" height="9"/>)",
          R"x(<rect width="9" height="9" fill="url(#g)"/>)x",
          R"(<rect width="9" height="9" opacity="0.5"/>)",
          R"x(<rect width="9" height="9" clip-path="url(#c)"/>)x"})
        EXPECT_FALSE(is_lines(inside)) << inside;
}

TEST(LineDrawing, IsFittedInTheArea) {
    const auto map =
        parse_line_drawing(svg(R"(viewBox="0 0 24 24")",
                               R"(<circle cx="12" cy="12" r="12" stroke="red" fill="none"/>)"),
                           Area{});
    ASSERT_TRUE(map.has_value()) << map.error().line;
    EXPECT_NEAR(map->area.width_m, 0.084, 1e-9);
    EXPECT_NEAR(map->area.height_m, 0.084, 1e-9);
    for (const Position p : map->outlines.at(0).points)
        EXPECT_NEAR(std::hypot(p.x, p.y), 0.042, 0.05e-3);
}

/// Between two points the line is as near as that, too.
TEST(LineDrawing, CurvesAreFlattenedToAFewHundredthsOfAMillimetre) {
    const auto map = parse_line_drawing(
        svg(R"(viewBox="0 0 2 2")", R"(<circle cx="1" cy="1" r="1" stroke="red" fill="none"/>)"),
        Area{});
    ASSERT_TRUE(map.has_value());
    const auto& points = map->outlines.at(0).points;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double x = 0.5 * (points[i].x + points[i - 1].x);
        const double y = 0.5 * (points[i].y + points[i - 1].y);
        EXPECT_LT(0.042 - std::hypot(x, y), 0.05e-3);
    }
}

TEST(LineDrawing, EveryPictureOfTheGalleryComesThroughTheWorkerAsItsMap) {
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
