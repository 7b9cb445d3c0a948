#include "app/braille/line_pages.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

/// Letters are cells with dots, blanks are blank.
BrailleCells cells(const std::string& text) {
    BrailleCells made;
    for (const char c : text) made.push_back(c == ' ' ? 0 : static_cast<std::uint8_t>(c));
    return made;
}

std::string text(const BrailleCells& line) {
    std::string made;
    for (const std::uint8_t cell : line) made += cell == 0 ? ' ' : static_cast<char>(cell);
    return made;
}

std::vector<std::string> pages(const std::string& whole, std::size_t width) {
    std::vector<std::string> made;
    for (const LinePage& page : pages_of(cells(whole), width))
        made.push_back(whole.substr(page.first, page.count));
    return made;
}

LineReading line_of(std::size_t width) {
    return with_width({}, width, 0.0);
}

LineReading said(LineReading reading, const std::string& words, LineUse use = LineUse::now,
                 double now_s = 0.0) {
    return with_text(std::move(reading), cells(words), use, now_s);
}

/// Turns, and says "end" where nothing is.
std::string turn(LineReading& reading, LineTurn way) {
    const auto next = turned(reading, way, 0.0);
    if (!next) return "end";
    reading = *next;
    return text(shown_on(reading));
}

TEST(LinePages, BreakAtBlanks) {
    using Pages = std::vector<std::string>;
    EXPECT_EQ(pages("the house", 20), Pages{"the house"});
    EXPECT_EQ(pages("the house", 9), Pages{"the house"});
    EXPECT_EQ(pages("the house", 8), (Pages{"the", "house"}));
    EXPECT_EQ(pages("the house stands", 9), (Pages{"the house", "stands"}));
    EXPECT_EQ(pages("  a  b  ", 3), (Pages{"a", "b"}));
    EXPECT_EQ(pages("", 4), Pages{""});
    EXPECT_EQ(pages("    ", 2), Pages{""});
}

TEST(LinePages, AWordWiderThanTheLineIsCut) {
    using Pages = std::vector<std::string>;
    EXPECT_EQ(pages("abcdefghij", 4), (Pages{"abcd", "efgh", "ij"}));
    EXPECT_EQ(pages("an abcdefghij", 4), (Pages{"an", "abcd", "efgh", "ij"}));
    EXPECT_EQ(pages("abc", 1), (Pages{"a", "b", "c"}));
}

rc::Gen<std::string> any_words() {
    return rc::gen::container<std::string>(
        rc::gen::weightedElement<char>({{5, 'x'}, {5, 'y'}, {3, ' '}}));
}

RC_GTEST_PROP(LinePages, EveryCellIsOnExactlyOnePageAndNoPageIsTooWide, ()) {
    const std::string whole = *any_words();
    const auto width = *rc::gen::inRange<std::size_t>(1, 90);
    std::string read;
    std::size_t end = 0;
    for (const LinePage& page : pages_of(cells(whole), width)) {
        RC_ASSERT(page.count <= width);
        RC_ASSERT(page.first >= end);
        // Only blanks lie between two pages.
        RC_ASSERT(whole.find_first_not_of(' ', end) >= page.first);
        end = page.first + page.count;
        read += whole.substr(page.first, page.count);
    }
    RC_ASSERT(whole.find_first_not_of(' ', end) == std::string::npos);
    const auto dots = [](const std::string& of) {
        return std::ranges::count_if(of, [](char c) { return c != ' '; });
    };
    RC_ASSERT(dots(read) == dots(whole));
}

RC_GTEST_PROP(LinePages, NoWordThatFitsIsCut, ()) {
    const std::string whole = *any_words();
    const auto width = *rc::gen::inRange<std::size_t>(1, 90);
    for (const LinePage& page : pages_of(cells(whole), width)) {
        if (page.first == 0 || whole[page.first - 1] == ' ') continue;
        const std::size_t begin = whole.find_last_of(' ', page.first);
        const std::size_t first = begin == std::string::npos ? 0 : begin + 1;
        const std::size_t last = std::min(whole.find(' ', page.first), whole.size());
        RC_ASSERT(last - first > width);
    }
}

TEST(Line, NothingIsBlank) {
    EXPECT_EQ(text(shown_on(line_of(5))), "     ");
    EXPECT_TRUE(shown_on(LineReading{}).empty());
    LineReading empty = line_of(5);
    for (const LineTurn way : {LineTurn::on, LineTurn::back, LineTurn::to_first, LineTurn::to_last})
        EXPECT_EQ(turn(empty, way), "end");
}

TEST(Line, WhatCutsIsThereAtOnceFromItsBeginning) {
    LineReading line = said(line_of(6), "one two three");
    EXPECT_EQ(text(shown_on(line)), "one   ");
    EXPECT_EQ(turn(line, LineTurn::on), "two   ");
    line = said(line, "four");
    EXPECT_EQ(text(shown_on(line)), "four  ");
}

TEST(Line, WhatWasThereBeforeCanBePagedBackTo) {
    LineReading line = said(said(line_of(4), "one two"), "six");
    EXPECT_EQ(turn(line, LineTurn::back), "two ");
    EXPECT_EQ(turn(line, LineTurn::back), "one ");
    EXPECT_EQ(turn(line, LineTurn::back), "end");
    EXPECT_EQ(turn(line, LineTurn::on), "two ");
    EXPECT_EQ(turn(line, LineTurn::on), "six ");
    EXPECT_EQ(turn(line, LineTurn::on), "end");
}

TEST(Line, TheBeginningAndTheEndOfATextAreOneKeyAway) {
    LineReading line = said(line_of(4), "a bc def ghi");
    EXPECT_EQ(turn(line, LineTurn::to_last), "ghi ");
    EXPECT_EQ(turn(line, LineTurn::to_last), "end");
    EXPECT_EQ(turn(line, LineTurn::to_first), "a bc");
    EXPECT_EQ(turn(line, LineTurn::to_first), "end");
}

TEST(Line, WhatWaitsComesWhenTheReaderHadTheTime) {
    LineReading line = said(line_of(8), "one", LineUse::now, 10.0);
    line = said(line, "hint", LineUse::after, 10.5);
    EXPECT_EQ(text(shown_on(line)), "one     ");
    ASSERT_TRUE(next_due_s(line));
    EXPECT_DOUBLE_EQ(*next_due_s(line), 10.0 + reading_s(3));
    EXPECT_EQ(text(shown_on(passed(line, *next_due_s(line) - 0.01))), "one     ");
    line = passed(line, *next_due_s(line));
    EXPECT_EQ(text(shown_on(line)), "hint    ");
    EXPECT_FALSE(next_due_s(line));
    EXPECT_EQ(turn(line, LineTurn::back), "one     ") << "nothing is lost";
}

TEST(Line, WhatWaitsNeverTakesAPageAwayThatHasNotBeenReachedYet) {
    LineReading line = said(line_of(4), "one two", LineUse::now, 0.0);
    line = said(line, "hint", LineUse::after, 0.0);
    EXPECT_FALSE(next_due_s(line)) << "the second page is still to be read";
    line = passed(line, 1e6);
    EXPECT_EQ(text(shown_on(line)), "one ");
    line = *turned(line, LineTurn::on, 1e6);
    ASSERT_TRUE(next_due_s(line));
    EXPECT_EQ(text(shown_on(passed(line, *next_due_s(line)))), "hint");
}

TEST(Line, WhatHasTheFocusComesLast) {
    LineReading line = said(line_of(6), "told");
    line = with_resting(line, cells("item 2"), 0.0);
    EXPECT_EQ(text(shown_on(line)), "told  ") << "nothing is taken away";
    EXPECT_EQ(turn(line, LineTurn::on), "item 2");
    line = with_resting(line, cells("item 3"), 0.0);
    EXPECT_EQ(text(shown_on(line)), "item 3") << "who reads it reads what it is now";
    EXPECT_EQ(turn(line, LineTurn::on), "end");
    EXPECT_EQ(turn(line, LineTurn::back), "told  ");
}

TEST(Line, WhatHasTheFocusIsNotThereTwice) {
    LineReading line = with_resting(said(line_of(6), "item 2"), cells("item 2"), 0.0);
    EXPECT_EQ(turn(line, LineTurn::on), "end");
    line = said(line, "item 2");
    EXPECT_EQ(turn(line, LineTurn::back), "end") << "nor what is said again";
}

TEST(Line, AnotherWidthKeepsThePlace) {
    LineReading line = said(line_of(8), "one two three four");
    EXPECT_EQ(turn(line, LineTurn::on), "three   ");
    line = with_width(line, 5, 0.0);
    EXPECT_EQ(text(shown_on(line)), "three");
    line = with_width(line, 40, 0.0);
    EXPECT_EQ(text(shown_on(line)).substr(0, 18), "one two three four");
}

TEST(Line, TheOldestTextIsForgottenUnderTheReader) {
    LineReading line = said(line_of(4), "old");
    for (std::size_t i = 0; i < most_line_texts; ++i)
        line = said(line, std::string(1, static_cast<char>('a' + i)), LineUse::after);
    EXPECT_EQ(line.texts.size(), most_line_texts);
    EXPECT_EQ(text(shown_on(line)), "a   ");
}

/// Any order of all that happens.
RC_GTEST_PROP(Line, ThePlaceIsSoundWhateverHappens, ()) {
    LineReading line = line_of(*rc::gen::inRange<std::size_t>(0, 12));
    double now_s = 0.0;
    const int steps = *rc::gen::inRange(1, 60);
    for (int i = 0; i < steps; ++i) {
        now_s += *rc::gen::inRange(0, 5);
        switch (*rc::gen::inRange(0, 6)) {
            case 0:
                line = said(line, *any_words(), LineUse::now, now_s);
                break;
            case 1:
                line = said(line, *any_words(), LineUse::after, now_s);
                break;
            case 2:
                line = with_resting(line, cells(*any_words()), now_s);
                break;
            case 3:
                line = with_width(line, *rc::gen::inRange<std::size_t>(0, 12), now_s);
                break;
            case 4:
                line = passed(line, now_s);
                break;
            default:
                line = turned(line, static_cast<LineTurn>(*rc::gen::inRange(0, 4)), now_s)
                           .value_or(line);
        }
        RC_ASSERT(shown_on(line).size() == line.width);
        RC_ASSERT(line.texts.size() <= most_line_texts);
        RC_ASSERT(line.at <= line.texts.size());
        if (line.width == 0) continue;
        const bool is_any = !line.texts.empty() ||
                            std::ranges::any_of(line.resting, [](auto cell) { return cell != 0; });
        const auto shown = shown_on(line);
        const bool has_dots = std::ranges::any_of(shown, [](auto cell) { return cell != 0; });
        RC_ASSERT(has_dots == is_any);
        // From the first page to the last and back by the same number of turns.
        LineReading reader = line;
        int back = 0;
        while (auto next = turned(reader, LineTurn::back, now_s)) reader = *next, ++back;
        for (; back > 0; --back) reader = *turned(reader, LineTurn::on, now_s);
        RC_ASSERT(shown_on(reader) == shown);
    }
}

}  // namespace
}  // namespace touchline
