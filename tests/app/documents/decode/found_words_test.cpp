// Tests found words as they cross from their worker, honest and not, and as they join a page.
#include "app/documents/decode/found_words.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Bytes = std::vector<std::byte>;

FoundWords some_words() {
    return {100,
            50,
            {{10, 5, 30, 12}, {35, 5, 60, 12}, {0, 40, 100, 50}},
            {0.01, 0.005},
            {{"left atrium", {-0.002, 0.001}}, {"heart", {0.0, -0.002}}}};
}

Bytes answer_with(const FoundWords& words) {
    return answer_of(Result<FoundWords>(words)).value();
}

bool is_refused(const FoundWords& words) {
    return !words_of(answer_with(words), 100, 50).has_value();
}

Page page_of_pixels(int width, int height) {
    Page page;
    page.picture = {width, height, std::vector<std::uint8_t>(3 * 100 * 50), 1.0};
    page.told.area = {0.02, 0.01};
    return page;
}

TEST(FoundWords, CrossWhole) {
    const FoundWords words = words_of(answer_with(some_words()), 100, 50).value();
    EXPECT_EQ(words.width, 100);
    EXPECT_EQ(words.height, 50);
    EXPECT_EQ(words.boxes, some_words().boxes);
    EXPECT_EQ(words.area, some_words().area);
    ASSERT_EQ(words.labels.size(), 2U);
    EXPECT_EQ(words.labels[0].text, "left atrium");
    EXPECT_EQ(words.labels[1].place, (Position{0.0, -0.002}));
}

TEST(FoundWords, NoneIsNoError) {
    const FoundWords none{100, 50, {}, {0.01, 0.005}, {}};
    EXPECT_TRUE(words_of(answer_with(none), 100, 50).value().labels.empty());
}

TEST(FoundWords, OfAnotherPictureAreRefused) {
    EXPECT_FALSE(words_of(answer_with(some_words()), 101, 50).has_value());
    EXPECT_FALSE(words_of(answer_with(some_words()), 100, 49).has_value());
    EXPECT_FALSE(words_of(answer_with(some_words()), -100, -50).has_value());
}

TEST(FoundWords, APageIsNoWordsAndWordsAreNoPage) {
    const Bytes page = answer_of(Result<Page>(page_of_pixels(100, 50))).value();
    EXPECT_TRUE(page_of(page).has_value());
    EXPECT_FALSE(words_of(page, 100, 50).has_value());
    EXPECT_FALSE(page_of(answer_with(some_words())).has_value());
}

TEST(FoundWords, WhatIsOutsideThePictureIsRefused) {
    FoundWords words = some_words();
    words.boxes[0].right = 101;
    EXPECT_TRUE(is_refused(words));
    words = some_words();
    words.boxes[0].bottom = 51;
    EXPECT_TRUE(is_refused(words));
    words = some_words();
    words.boxes[0].left = words.boxes[0].right;
    EXPECT_TRUE(is_refused(words));
    words = some_words();
    words.labels[0].place.x = 0.0051;
    EXPECT_TRUE(is_refused(words));
    words = some_words();
    words.labels[0].place.y = -0.0026;
    EXPECT_TRUE(is_refused(words));
}

TEST(FoundWords, ALabelNeedsAWordAndAText) {
    FoundWords words = some_words();
    words.boxes.resize(1);
    EXPECT_TRUE(is_refused(words));
    words = some_words();
    words.labels[0].text = "\x01 ";
    EXPECT_TRUE(is_refused(words));
}

TEST(FoundWords, ARefusalIsItsOneLine) {
    const Result<FoundWords> refusal = failure("no\ndata");
    const auto words = words_of(answer_of(refusal).value(), 100, 50);
    ASSERT_FALSE(words.has_value());
    EXPECT_EQ(words.error().line, "no data");
}

TEST(FoundWords, NoiseIsRefusedOrSound) {
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        Bytes answer = answer_with(some_words());
        for (unsigned hits = 1 + random() % 4; hits > 0; --hits)
            answer[random() % answer.size()] = static_cast<std::byte>(random());
        const auto words = words_of(answer, 100, 50);
        if (!words) continue;
        for (const WordBox& box : words->boxes)
            EXPECT_TRUE(box.left < box.right && box.right <= 100 && box.bottom <= 50);
    }
}

TEST(FoundWords, JoinAPageAtItsScaleBesideWhatItSays) {
    Page page = page_of_pixels(100, 50);
    page.told.title = "Heart";
    page.told.labels.push_back({"figure", {0.0, 0.0}});
    page = with_words(std::move(page), some_words());
    EXPECT_EQ(page.told.title, "Heart");
    EXPECT_EQ(page.words, some_words().boxes);
    ASSERT_EQ(page.told.labels.size(), 3U);
    EXPECT_EQ(page.told.labels[0].text, "figure");
    EXPECT_EQ(page.told.labels[1].text, "left atrium");
    EXPECT_EQ(page.told.labels[1].place, (Position{-0.004, 0.002}));
    EXPECT_FALSE(needs_reading(page));
}

TEST(FoundWords, LeaveAPageWithTextOfItsOwnAsItIs) {
    Page text = page_of_pixels(100, 50);
    text.words.push_back({1, 1, 2, 2});
    Page lines = page_of_pixels(100, 50);
    lines.told.outlines.push_back({{{0.0, 0.0}, {0.001, 0.0}}, false, "a", "", 1.0, 1});
    Page larger = page_of_pixels(101, 50);
    EXPECT_FALSE(needs_reading(text));
    EXPECT_FALSE(needs_reading(lines));
    EXPECT_FALSE(needs_reading(Page{}));
    for (const Page& page : {text, lines, larger}) {
        const Page same = with_words(page, some_words());
        EXPECT_EQ(same.words, page.words);
        EXPECT_TRUE(same.told.labels.empty());
    }
}

TEST(ReadingOrder, IsOfTheVisitorsLanguage) {
    EXPECT_EQ(code_of(written_language("it")), "ita");
    EXPECT_EQ(code_of(written_language("xx")), "eng") << "one that cannot be read";
}

TEST(ReadingOrder, CrossesTheCommandLine) {
    const ReadingOrder order{
        {WrittenLanguage::spanish, WrittenLanguage::english, WrittenLanguage::german}};
    EXPECT_EQ(arguments_of(order), (std::vector<std::string>{"spa", "eng", "deu"}));
    EXPECT_EQ(reading_order_in(arguments_of(order))->languages, order.languages);
    EXPECT_EQ(arguments_of({}), std::vector<std::string>{"eng"});
    EXPECT_FALSE(reading_order_in({}).has_value());
    EXPECT_FALSE(reading_order_in(std::vector<std::string>{"eng", "eng"}).has_value());
    EXPECT_FALSE(reading_order_in(std::vector<std::string>{"eng+deu"}).has_value());
}

}  // namespace
}  // namespace touchline
