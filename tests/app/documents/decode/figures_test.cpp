// Tests which figures are found on a PDF page.
#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/files_of_formats.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Returns each figure's box as "left top right bottom", at 72 dpi so that a pixel is a point.
std::vector<std::string> boxes_of(const encoders::Bytes& pdf, int page = 1) {
    const auto opened = decode_page(pdf, {page, 72});
    EXPECT_TRUE(opened.has_value()) << opened.error().line;
    std::vector<std::string> boxes;
    if (!opened) return boxes;
    for (const Figure& figure : opened->figures)
        boxes.push_back(fmt::format("{} {} {} {}", figure.box.left, figure.box.top,
                                    figure.box.right, figure.box.bottom));
    return boxes;
}

using Boxes = std::vector<std::string>;

TEST(Figures, AreThePicturesOfThePageFromTheTopDown) {
    const auto pdf = drawn_pdf({{{100, 100, 200, 150}, {50, 500, 300, 200}},
                                {},
                                {{300, 500, 100, 100}, {100, 500, 100, 100}}});
    EXPECT_EQ(boxes_of(pdf), (Boxes{"50 100 350 300", "100 550 300 700"}));
    EXPECT_EQ(boxes_of(pdf, 2), Boxes{});
    EXPECT_EQ(boxes_of(pdf, 3), (Boxes{"100 200 200 300", "300 200 400 300"}));
}

TEST(Figures, AreAtTheirPlaceAtEveryResolution) {
    const auto pdf = drawn_pdf({{{100, 100, 200, 150}}});
    const auto fine = decode_page(pdf, {1, 144});
    ASSERT_EQ(fine->figures.size(), 1U);
    const WordBox box{200, 1100, 600, 1400};
    EXPECT_EQ(fine->figures[0].box, box);
}

TEST(Figures, WhatDecoratesIsNone) {
    // A bullet, a rule across the page, the page's background, and something beside the page.
    const auto pdf = drawn_pdf({{{0, 0, 600, 800},
                                 {100, 100, 20, 20},
                                 {50, 400, 500, 3},
                                 {700, 100, 200, 200},
                                 {100, 200, 100, 100}}});
    EXPECT_EQ(boxes_of(pdf), Boxes{"100 500 200 600"});
}

TEST(Figures, StripsOfAPictureAreOne) {
    std::vector<DrawnImage> strips;
    for (int i = 0; i < 10; ++i) strips.push_back({100.0, 300.0 + 20.0 * i, 200.0, 20.0});
    EXPECT_EQ(boxes_of(drawn_pdf({strips})), Boxes{"100 300 300 500"});
}

TEST(Figures, AScanInTilesIsThePageItself) {
    std::vector<DrawnImage> tiles;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 4; ++y) tiles.push_back({200.0 * x, 200.0 * y, 200.0, 200.0});
    EXPECT_EQ(boxes_of(drawn_pdf({tiles})), Boxes{});
}

TEST(Figures, PartsThatJoinOneByOneAreOneInTheEnd) {
    // Two that touch only the third, which is drawn last.
    const auto pdf = drawn_pdf(
        {{{100, 100, 100, 100}, {300, 100, 100, 100}, {200, 100, 100, 100}, {100, 600, 50, 50}}});
    EXPECT_EQ(boxes_of(pdf), (Boxes{"100 150 150 200", "100 600 400 700"}));
}

TEST(Figures, ThereAreAsManyAsCanBeCounted) {
    std::vector<DrawnImage> many;
    for (int x = 0; x < 15; ++x)
        for (int y = 0; y < 15; ++y) many.push_back({5.0 + 38.0 * x, 5.0 + 50.0 * y, 30.0, 30.0});
    EXPECT_EQ(boxes_of(drawn_pdf({many})).size(), max_figures);
}

TEST(Figures, HaveTheTextThatIsWrittenOfThem) {
    const auto page = decode_page(tagged_pdf({"Fish"}, "A black box"), {1, 72});
    ASSERT_EQ(page->figures.size(), 1U);
    EXPECT_EQ(page->figures[0].text, "A black box");
    const double px = page->picture.width / 300.0;
    EXPECT_NEAR(page->figures[0].box.left, px * 200, 1);
    EXPECT_NEAR(page->figures[0].box.top, px * 130, 1);
    EXPECT_NEAR(page->figures[0].box.right, px * 260, 1);
    EXPECT_NEAR(page->figures[0].box.bottom, px * 170, 1);
}

}  // namespace
}  // namespace touchline
