// Tests layered pictures of the IMAGE project, read and written.

#include "app/documents/decode/map_svg.h"
#include "app/documents/gallery/gallery.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// After the guidelines of the project's Monarch client: y up to 0, pixels, one title, layers.
const std::string layered = R"svg(<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" width="1160" height="420" viewBox="0 -420 1160 420">
  <title>Two people beside a tree</title>
  <desc id="left">Person on the left</desc>
  <desc id="tall">It is twice as tall as the people.</desc>
  <g data-image-layer="people" aria-label="People" aria-description="They hold hands">
    <rect x="100" y="-300" width="100" height="200" aria-labelledby="left"/>
    <rect x="300" y="-300" width="100" height="200" aria-label="Person on the right"/>
  </g>
  <g data-image-layer="nature" aria-label="Tree" aria-describedby="tall">
    <circle cx="800" cy="-200" r="150"/>
  </g>
  <path aria-label="Ground" d="M0 -10 L1160 -10"/>
</svg>)svg";

TEST(ImageLayers, AreFound) {
    EXPECT_TRUE(has_image_layers(layered));
    EXPECT_FALSE(has_image_layers("<svg><path d='M0 0 L1 1'/></svg>"));
    EXPECT_FALSE(has_image_layers("no xml"));
}

TEST(ImageLayers, BecomeAMap) {
    const auto text = map_svg_of_image_layers(layered, Area{});
    ASSERT_TRUE(text.has_value()) << text.error().line;
    const auto map = parse_map_svg(*text);
    ASSERT_TRUE(map.has_value()) << map.error().line;
    EXPECT_EQ(map->area, Area{});
    EXPECT_EQ(map->title, "Two people beside a tree");
    EXPECT_NE(map->description.find("Person on the left"), std::string::npos);
    ASSERT_EQ(map->outlines.size(), 4U);
    EXPECT_EQ(map->outlines[0].label, "Person on the left");
    EXPECT_EQ(map->outlines[1].label, "Person on the right");
    EXPECT_EQ(map->outlines[2].label, "Tree");
    EXPECT_EQ(map->outlines[3].label, "Ground");
    // A tenth of its size, in the middle: 116 by 42 of 84 millimetres.
    EXPECT_NEAR(map->outlines[3].points[0].x, -0.058, 1e-9);
    EXPECT_NEAR(map->outlines[3].points[0].y, -0.020, 1e-9);
}

TEST(ImageLayers, DescribeAPictureThatHasNoDescription) {
    std::string text = layered;
    for (const char* desc : {"<desc id=\"left\">Person on the left</desc>",
                             "<desc id=\"tall\">It is twice as tall as the people.</desc>"})
        text.erase(text.find(desc), std::string(desc).size());
    const auto map = parse_map_svg(*map_svg_of_image_layers(text, Area{}));
    ASSERT_TRUE(map.has_value());
    EXPECT_EQ(map->description, "People: They hold hands. Tree.");
}

TEST(ImageLayers, HostileDepthIsRefusedInWords) {
    std::string deep = "<svg viewBox=\"0 0 10 10\">";
    for (int i = 0; i < 100000; ++i) deep += "<g data-image-layer=\"a\">";
    const auto text = map_svg_of_image_layers(deep + "<path d=\"M0 0 L1 1\"/>", Area{});
    EXPECT_TRUE(!text || !parse_map_svg(*text));
}

bool is_before(const Outline& a, const Outline& b) {
    return a.id < b.id;
}

/// Every picture of the gallery says and shows the same after it was written and read.
TEST(ImageLayers, OfTheGalleryHoldTheSameMap) {
    const auto gallery = list_gallery(gallery_folder());
    ASSERT_TRUE(gallery.has_value());
    for (const GalleryEntry& entry : *gallery) {
        std::ifstream file(entry.path);
        std::stringstream text;
        text << file.rdbuf();
        for (const char* language : {"en", "de"}) {
            SCOPED_TRACE(entry.path + ' ' + language);
            const auto layers = image_layers_of_map_svg(text.str(), {language});
            ASSERT_TRUE(layers.has_value()) << layers.error().line;
            EXPECT_NE(layers->find("<g data-image-layer=\"detail-1\" aria-label="),
                      std::string::npos);
            EXPECT_EQ(layers->find("xml:lang"), std::string::npos);
            auto before = parse_map_svg(text.str(), {language});
            auto after = parse_map_svg(*map_svg_of_image_layers(*layers, Area{}), {language});
            ASSERT_TRUE(before.has_value() && after.has_value());
            EXPECT_EQ(after->title, before->title);
            EXPECT_EQ(after->description, before->description);
            ASSERT_EQ(after->outlines.size(), before->outlines.size());
            std::sort(before->outlines.begin(), before->outlines.end(), is_before);
            std::sort(after->outlines.begin(), after->outlines.end(), is_before);
            for (std::size_t i = 0; i < before->outlines.size(); ++i) {
                EXPECT_EQ(after->outlines[i].label, before->outlines[i].label);
                EXPECT_EQ(after->outlines[i].detail, before->outlines[i].detail);
                EXPECT_TRUE(after->outlines[i].points == before->outlines[i].points);
            }
            ASSERT_EQ(after->labels.size(), before->labels.size());
            for (std::size_t i = 0; i < before->labels.size(); ++i)
                EXPECT_EQ(after->labels[i].text, before->labels[i].text);
        }
    }
}

}  // namespace
}  // namespace touchline
