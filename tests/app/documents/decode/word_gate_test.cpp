// Tests which of tesseract's words are believed.
#include "app/documents/decode/readers.h"
#include "app/documents/decode/word_reader.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using decode::believed;
using decode::SeenWord;

/// A word in the first line, 10 pixels high.
SeenWord word(std::string text, double confidence, int left = 10, bool begins_line = false) {
    const auto at = static_cast<std::uint16_t>(left);
    const auto end = static_cast<std::uint16_t>(left + 30);
    return {std::move(text), confidence, {at, 10, end, 20}, begins_line};
}

std::vector<std::string> texts(const std::vector<SeenWord>& seen) {
    std::vector<std::string> texts;
    for (const Label& label : believed(seen, 400, 200).labels) texts.push_back(label.text);
    return texts;
}

using Texts = std::vector<std::string>;

TEST(WordGate, WordsOfALineAreOneLabelInTheirMiddle) {
    const std::vector<SeenWord> seen{word("left", 96, 10, true), word("atrium", 93, 45)};
    const FoundWords found = believed(seen, 400, 200);
    ASSERT_EQ(found.labels.size(), 1U);
    EXPECT_EQ(found.labels[0].text, "left atrium");
    const Picture size{400, 200, {}, 1.0};
    EXPECT_EQ(found.labels[0].place, decode::told_place(size, 42.5, 15.0));
    EXPECT_EQ(found.boxes, (std::vector<WordBox>{seen[0].box, seen[1].box}));
    EXPECT_EQ(found.area, decode::told_area(size));
}

TEST(WordGate, AnotherLineOrAWideGapIsAnotherLabel) {
    EXPECT_EQ(texts({word("left", 96, 10, true), word("right", 96, 45, true)}),
              (Texts{"left", "right"}));
    EXPECT_EQ(texts({word("left", 96, 10, true), word("right", 96, 60)}), (Texts{"left", "right"}));
    EXPECT_EQ(texts({word("left", 96, 10, true), word("right", 96, 51)}), (Texts{"left right"}));
}

TEST(WordGate, AWordMustBeSureAndAShortOneSurer) {
    EXPECT_EQ(texts({word("heart", 75)}), (Texts{"heart"}));
    EXPECT_EQ(texts({word("heart", 74.9)}), (Texts{}));
    EXPECT_EQ(texts({word("sea", 95)}), (Texts{"sea"}));
    EXPECT_EQ(texts({word("sea", 94.9)}), (Texts{}));
    EXPECT_EQ(texts({word("12", 95)}), (Texts{"12"}));
}

TEST(WordGate, OneLetterOrMarksAloneAreNone) {
    for (const char* text :
         {"A", "7", "é", "|", "==", "@@", "(((", "—=—", "A|||", "\xc3\x97\xc3\xb7", ""})
        EXPECT_EQ(texts({word(text, 99)}), (Texts{})) << text;
}

TEST(WordGate, LettersOfTheLanguagesCount) {
    EXPECT_EQ(texts({word("œuf", 96)}), (Texts{"œuf"}));
    EXPECT_EQ(texts({word("île", 96)}), (Texts{"île"}));
    EXPECT_EQ(texts({word("Ärzt", 80)}), (Texts{"Ärzt"}));
    EXPECT_EQ(texts({word("¿año", 96)}), (Texts{"¿año"}));
}

/// A line of text may hold a word that would not be believed alone.
TEST(WordGate, WhatStandsInALineOfTextIsMeasuredByLess) {
    EXPECT_EQ(texts({word("the", 60, 10, true), word("heart", 96, 45)}), (Texts{"the heart"}));
    EXPECT_EQ(texts({word("the", 59, 10, true), word("heart", 96, 45)}), (Texts{"heart"}));
    EXPECT_EQ(texts({word("à", 85, 10, true), word("côté", 96, 45)}), (Texts{"à côté"}));
    EXPECT_EQ(texts({word("à", 84, 10, true), word("côté", 96, 45)}), (Texts{"côté"}));
    EXPECT_EQ(texts({word("|", 99, 10, true), word("heart", 96, 45)}), (Texts{"heart"}));
}

TEST(WordGate, WhatIsNotBelievedIsNotMaskedEither) {
    EXPECT_TRUE(believed(std::vector{word("igh", 90), word("=", 99, 100)}, 400, 200).boxes.empty());
}

/// The answer keeps as many boxes as it can hold, in whole lines.
TEST(WordGate, ManyWordsHaveAnEnd) {
    std::vector<SeenWord> seen;
    for (int i = 0; i < 20'000; ++i) seen.push_back(word("heart", 96, 10, i % 7 == 0));
    const FoundWords found = believed(seen, 400, 200);
    EXPECT_LE(found.boxes.size(), max_word_boxes);
    EXPECT_GT(found.boxes.size(), max_word_boxes - 7);
    EXPECT_TRUE(words_of(answer_of(Result<FoundWords>(found)).value(), 400, 200).has_value());
}

/// The kiosk accepts any words of tesseract.
TEST(WordGate, AnyWordsCross) {
    std::mt19937 random(7);
    const std::vector<std::string> some{"heart", "a",  "\xff\xfe",   "\xc3",
                                        "",      "12", "\x01\x02 x", "été"};
    for (int i = 0; i < 2000; ++i) {
        std::vector<SeenWord> seen;
        for (auto count = random() % 6; count > 0; --count)
            seen.push_back(word(some[random() % some.size()],
                                50.0 + static_cast<double>(random() % 51),
                                static_cast<int>(random() % 370), random() % 2 == 0));
        const auto crossed =
            words_of(answer_of(Result<FoundWords>(believed(seen, 400, 200))).value(), 400, 200);
        ASSERT_TRUE(crossed.has_value()) << crossed.error().line;
    }
}

}  // namespace
}  // namespace touchline
