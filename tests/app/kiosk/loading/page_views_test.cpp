#include "app/documents/trace/page_views.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

/// Each pixel tells its place: x, y, and a third value that no neighbour has.
Page page_of_pixels(int width, int height) {
    Page page;
    page.picture = {width, height, {}, 1.0};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            page.picture.bgr.push_back(static_cast<std::uint8_t>(x));
            page.picture.bgr.push_back(static_cast<std::uint8_t>(y));
            page.picture.bgr.push_back(static_cast<std::uint8_t>(x ^ y));
        }
    }
    page.told.area = {1e-4 * width, 1e-4 * height};
    page.told.title = "Animals";
    page.told.description = "A fish A bird";
    page.number = 2;
    page.count = 7;
    page.dpi = 150;
    return page;
}

/// Returns the place of a pixel's centre.
Position place_of(const Page& page, int x, int y) {
    const double m_per_px = page.told.area.width_m / page.picture.width;
    return {(x + 0.5 - page.picture.width / 2.0) * m_per_px,
            (page.picture.height / 2.0 - y - 0.5) * m_per_px};
}

Page fish_and_bird() {
    Page page = page_of_pixels(100, 80);
    page.figures = {{{10, 20, 40, 50}, "A fish"}, {{50, 5, 90, 75}, ""}};
    page.words = {{12, 22, 20, 30}, {35, 45, 60, 55}, {0, 0, 10, 20}};
    page.told.labels = {{"A fish", place_of(page, 25, 35)},
                        {"fin", place_of(page, 11, 21)},
                        {"elsewhere", place_of(page, 45, 35)}};
    return page;
}

TEST(PageViews, APageWithoutFiguresIsOneView) {
    const Page page = page_of_pixels(4, 3);
    EXPECT_EQ(view_count(page), 1);
    EXPECT_EQ(view_of(page, 1).picture.bgr, page.picture.bgr);
}

TEST(PageViews, FiguresComeBeforeThePageAsAWhole) {
    const Page page = fish_and_bird();
    ASSERT_EQ(view_count(page), 3);
    EXPECT_EQ(view_of(page, 1).picture.width, 30);
    EXPECT_EQ(view_of(page, 2).picture.height, 70);
    const Page whole = view_of(page, 3);
    EXPECT_EQ(whole.picture.bgr, page.picture.bgr);
    EXPECT_EQ(whole.words, page.words);
    EXPECT_EQ(whole.told.labels.size(), 3U);
}

TEST(PageViews, AFigureTakesItsWordsAndLabelsAlong) {
    const Page page = fish_and_bird();
    const Page fish = view_of(page, 1);
    const std::vector<WordBox> words{{2, 2, 10, 10}, {25, 25, 30, 30}};
    EXPECT_EQ(fish.words, words);
    ASSERT_EQ(fish.told.labels.size(), 1U);
    EXPECT_EQ(fish.told.labels[0].text, "fin");
    const Position fin = place_of(fish, 1, 1);
    EXPECT_NEAR(fish.told.labels[0].place.x, fin.x, 1e-12);
    EXPECT_NEAR(fish.told.labels[0].place.y, fin.y, 1e-12);
    EXPECT_EQ(fish.number, 2);
    EXPECT_EQ(fish.count, 7);
}

TEST(PageViews, WhatIsWrittenOfAFigureIsItsDescriptionAndShortItsTitle) {
    Page page = fish_and_bird();
    EXPECT_EQ(view_of(page, 1).told.title, "A fish");
    EXPECT_EQ(view_of(page, 1).told.description, "A fish");
    EXPECT_EQ(view_of(page, 2).told.title, "Animals");
    EXPECT_EQ(view_of(page, 2).told.description, "");
    page.figures[0].text = std::string(200, 'a');
    EXPECT_EQ(view_of(page, 1).told.title, "Animals");
    EXPECT_EQ(view_of(page, 1).told.description, page.figures[0].text);
}

TEST(PageViews, ASmallFigureIsDrawnFiner) {
    Page page = page_of_pixels(1240, 900);
    page.figures = {{{0, 0, 300, 100}, ""}, {{0, 0, 100, 600}, ""}, {{0, 0, 20, 10}, ""}};
    EXPECT_EQ(dpi_for(page, 1), 300);
    EXPECT_EQ(dpi_for(page, 2), 150);
    EXPECT_EQ(dpi_for(page, 3), most_view_dpi);
    EXPECT_EQ(dpi_for(page, 4), 150);
    page.dpi = 0;  // a photo has nothing finer
    EXPECT_EQ(dpi_for(page, 1), 0);
    EXPECT_EQ(dpi_for(page_of_pixels(400, 200), 1), 225);
}

RC_GTEST_PROP(PageViews, EveryPixelOfAFigureIsThatOfThePage, ()) {
    const int width = *rc::gen::inRange(1, 60);
    const int height = *rc::gen::inRange(1, 60);
    Page page = page_of_pixels(width, height);
    const int left = *rc::gen::inRange(0, width);
    const int top = *rc::gen::inRange(0, height);
    const int right = *rc::gen::inRange(left + 1, width + 1);
    const int bottom = *rc::gen::inRange(top + 1, height + 1);
    const auto u16 = [](int value) { return static_cast<std::uint16_t>(value); };
    page.figures = {{{u16(left), u16(top), u16(right), u16(bottom)}, ""}};
    const int x = *rc::gen::inRange(left, right);
    const int y = *rc::gen::inRange(top, bottom);
    page.told.labels = {{"here", place_of(page, x, y)}};
    const Page part = view_of(page, 1);
    RC_ASSERT(part.picture.width == right - left && part.picture.height == bottom - top);
    RC_ASSERT(part.picture.bgr.size() ==
              3U * static_cast<std::size_t>((right - left) * (bottom - top)));
    const auto at = 3 * static_cast<std::size_t>((y - top) * part.picture.width + x - left);
    RC_ASSERT(part.picture.bgr[at] == static_cast<std::uint8_t>(x));
    RC_ASSERT(part.picture.bgr[at + 1] == static_cast<std::uint8_t>(y));
    RC_ASSERT(part.told.labels.size() == 1U);
    const Position label = part.told.labels[0].place;
    const Position expected = place_of(part, x - left, y - top);
    RC_ASSERT(norm(label - expected) < 1e-9);
}

}  // namespace
}  // namespace touchline
