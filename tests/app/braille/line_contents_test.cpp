#include "app/braille/line_contents.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::string ascii(const BrailleCells& cells) {
    std::string text;
    for (const std::uint8_t cell : cells) text += braille_ascii(cell);
    const auto last = text.find_last_not_of(' ');
    return text.substr(0, last + 1);
}

LineContents contents_of(std::size_t width) {
    LineContents line;
    line.set_width(width, 0.0);
    return line;
}

TEST(LineContents, TextsAreWrittenInTheirLanguageAndGrade) {
    LineContents line = contents_of(40);
    line.say({"en", "the house"}, LineUse::now, 0.0);
    EXPECT_EQ(ascii(line.shown()), "THE HOUSE");
    line.choose(BrailleGrade::contracted, 0.0);
    EXPECT_EQ(ascii(line.shown()), "! H\\SE") << "what is there is written again";
    line.say({"de", "das Haus"}, LineUse::now, 0.0);
    EXPECT_EQ(ascii(line.shown()), "D H*S");
    line.choose(BrailleGrade::uncontracted, 0.0);
    EXPECT_EQ(ascii(line.shown()), "DAS HAUS");
}

TEST(LineContents, ALanguageWithoutATableIsWrittenByTheEnglishOne) {
    LineContents line = contents_of(40);
    line.say({"tlh", "house"}, LineUse::now, 0.0);
    EXPECT_EQ(ascii(line.shown()), "HOUSE");
    EXPECT_EQ(line.problem(), "");
}

TEST(LineContents, ALineThatComesLaterHasWhatWasSaidLast) {
    LineContents line;
    line.say({"en", "one"}, LineUse::now, 0.0);
    line.say({"en", "two"}, LineUse::now, 1.0);
    line.rest({"en", "three"}, 1.0);
    EXPECT_TRUE(line.shown().empty());
    line.set_width(20, 2.0);
    EXPECT_EQ(ascii(line.shown()), "TWO");
    EXPECT_TRUE(line.turn(LineTurn::on, 2.0));
    EXPECT_EQ(ascii(line.shown()), "THREE");
    line.set_width(0, 3.0);
    EXPECT_FALSE(line.turn(LineTurn::back, 3.0));
    line.say({"en", "four"}, LineUse::now, 4.0);
    line.set_width(40, 5.0);
    EXPECT_EQ(ascii(line.shown()), "FOUR");
    EXPECT_TRUE(line.turn(LineTurn::back, 5.0));
    EXPECT_EQ(ascii(line.shown()), "TWO");
}

TEST(LineContents, WhatWaitsComesWithTime) {
    LineContents line = contents_of(20);
    line.say({"en", "one"}, LineUse::now, 0.0);
    line.say({"en", "two"}, LineUse::after, 0.1);
    line.pass(0.5);
    EXPECT_EQ(ascii(line.shown()), "ONE");
    ASSERT_TRUE(line.due_s());
    line.pass(*line.due_s());
    EXPECT_EQ(ascii(line.shown()), "TWO");
}

TEST(LineContents, NothingOfAVisitorStays) {
    LineContents line = contents_of(20);
    line.say({"en", "secret"}, LineUse::now, 0.0);
    line.rest({"en", "name"}, 0.0);
    line.forget();
    EXPECT_EQ(ascii(line.shown()), "");
    EXPECT_FALSE(line.turn(LineTurn::back, 1.0));
    EXPECT_FALSE(line.turn(LineTurn::on, 1.0));
    line.set_width(0, 1.0);
    line.set_width(20, 1.0);
    EXPECT_EQ(ascii(line.shown()), "");
    line.rest({"en", "name"}, 2.0);
    EXPECT_EQ(ascii(line.shown()), "NAME");
}

TEST(LineContents, AnEmptyTextIsNone) {
    LineContents line = contents_of(20);
    line.say({"en", "one"}, LineUse::now, 0.0);
    line.say({"en", ""}, LineUse::now, 0.0);
    line.say({"en", "  "}, LineUse::now, 0.0);
    EXPECT_EQ(ascii(line.shown()), "ONE");
}

}  // namespace
}  // namespace touchline
