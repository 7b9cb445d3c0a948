// Tests answers of a worker, honest and not.
#include "app/documents/decode/page.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Bytes = std::vector<std::byte>;

Page some_page() {
    Page page;
    page.picture = {3, 2, {}, 0.25};
    for (int i = 0; i < 18; ++i) page.picture.bgr.push_back(static_cast<std::uint8_t>(7 * i));
    page.told.title = "Fish";
    page.told.description = "A fish that swims to the left";
    page.told.labels.push_back({"fin", {0.01, 0.02}});
    page.words = {{0, 0, 1, 1}};
    page.figures = {{{0, 0, 2, 2}, "A boat"}, {{1, 1, 3, 2}, ""}};
    page.number = 2;
    page.count = 7;
    page.dpi = 150;
    return page;
}

Bytes some_answer() {
    return answer_of(some_page()).value();
}

TEST(Page, CrossesWhole) {
    const Page page = page_of(some_answer()).value();
    EXPECT_EQ(page.picture.bgr, some_page().picture.bgr);
    EXPECT_EQ(page.picture.width, 3);
    EXPECT_EQ(page.picture.height, 2);
    EXPECT_EQ(page.picture.scale, 0.25);
    EXPECT_EQ(page.told.title, "Fish");
    ASSERT_EQ(page.told.labels.size(), 1U);
    EXPECT_EQ(page.told.labels[0].text, "fin");
    EXPECT_EQ(page.words, some_page().words);
    EXPECT_EQ(page.figures, some_page().figures);
    EXPECT_EQ(page.number, 2);
    EXPECT_EQ(page.count, 7);
    EXPECT_EQ(page.dpi, 150);
}

TEST(Page, OfOutlinesHasNoPixels) {
    Page page = some_page();
    page.picture = {};
    page.words.clear();
    page.figures.clear();
    page.told.outlines.push_back({{{0.0, 0.0}, {0.01, 0.0}}, false, "a", "", 1.0, 1});
    const Page read = page_of(answer_of(page).value()).value();
    EXPECT_TRUE(read.picture.bgr.empty());
    EXPECT_EQ(read.told.outlines.size(), 1U);
}

TEST(Page, ARefusalIsOneLineWhateverItHolds) {
    const auto refused =
        page_of(answer_of(failure("torn\n\x1b[2Jin half" + std::string(1000, '!'))).value());
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().line.find('\n'), std::string::npos);
    EXPECT_EQ(refused.error().line.find('\x1b'), std::string::npos);
    EXPECT_LE(refused.error().line.size(), 203U);
}

TEST(Page, AnyOtherHeaderIsRefused) {
    EXPECT_FALSE(page_of({}).has_value());
    EXPECT_FALSE(page_of(Bytes(27)).has_value());
    EXPECT_FALSE(page_of(Bytes(28)).has_value());
    for (std::size_t byte = 0; byte < 28; ++byte) {
        const bool may_be_another = byte >= 16 && byte < 22;  // number, count, dpi
        for (int bit = 0; bit < 8; ++bit) {
            Bytes answer = some_answer();
            answer[byte] ^= static_cast<std::byte>(1U << static_cast<unsigned>(bit));
            EXPECT_TRUE(may_be_another || !page_of(answer)) << byte;
        }
    }
}

TEST(Page, AnotherLengthIsRefused) {
    const Bytes whole = some_answer();
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(page_of(std::span(whole).first(size)).has_value());
    Bytes longer = whole;
    longer.push_back(std::byte{0});
    EXPECT_FALSE(page_of(longer).has_value());
}

TEST(Page, SizesThatNobodyHasAreRefusedThoughTheSumIsRight) {
    Page page = some_page();
    page.picture.width = 10'001;
    page.picture.height = 1;
    page.picture.bgr.assign(30'003, 1);
    EXPECT_FALSE(page_of(answer_of(page).value()).has_value());
    page.picture = some_page().picture;
    page.number = 8;
    EXPECT_FALSE(page_of(answer_of(page).value()).has_value());
    page.number = page.count = max_pages + 1;
    EXPECT_FALSE(page_of(answer_of(page).value()).has_value());
    page.number = page.count = 0;
    EXPECT_FALSE(page_of(answer_of(page).value()).has_value());
}

TEST(Page, FiguresOutsideThePictureOrWithoutPixelsAreRefused) {
    for (const WordBox box :
         {WordBox{0, 0, 4, 1}, WordBox{0, 0, 1, 3}, WordBox{2, 0, 2, 1}, WordBox{0, 2, 1, 2}}) {
        Page page = some_page();
        page.figures[1].box = box;
        EXPECT_FALSE(page_of(answer_of(page).value()).has_value()) << box.right;
    }
}

TEST(Page, MoreFiguresThanMayBeAreRefused) {
    Page page = some_page();
    page.figures.assign(max_figures, {{0, 0, 1, 1}, ""});
    EXPECT_EQ(page_of(answer_of(page).value())->figures.size(), max_figures);
    page.figures.push_back(page.figures.front());
    EXPECT_FALSE(page_of(answer_of(page).value()).has_value());
}

TEST(Page, TheTextOfAFigureIsOneLine) {
    Page page = some_page();
    page.figures[0].text = "A\n\x1b[2Jboat";
    EXPECT_EQ(page_of(answer_of(page).value())->figures[0].text, "A [2Jboat");
}

TEST(Page, NoiseIsRefused) {
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        Bytes answer = some_answer();
        for (unsigned hits = 1 + random() % 4; hits > 0; --hits)
            answer[random() % answer.size()] = static_cast<std::byte>(random());
        const auto page = page_of(answer);
        EXPECT_TRUE(!page || page->picture.bgr.size() == 18U);
    }
}

}  // namespace
}  // namespace touchline
