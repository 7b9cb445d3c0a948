#include "app/sheets/braille_lines.h"

#include "app/sheets/sheet_words.h"
#include "tests/app/sheets/sheet_maps.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

rc::Gen<BrailleCells> any_cells() {
    return rc::gen::container<BrailleCells>(rc::gen::weightedOneOf<std::uint8_t>(
        {{1, rc::gen::just(std::uint8_t{0})}, {4, rc::gen::inRange<std::uint8_t>(1, 64)}}));
}

BrailleCells without_blanks(const BrailleCells& cells) {
    BrailleCells kept = cells;
    std::erase(kept, std::uint8_t{0});
    return kept;
}

BrailleCells joined(const std::vector<BrailleCells>& lines) {
    BrailleCells all;
    for (const BrailleCells& line : lines) all.insert(all.end(), line.begin(), line.end());
    return all;
}

RC_GTEST_PROP(BrailleLines, LoseNoCellAndKeepTheWidth, ()) {
    const BrailleCells cells = *any_cells();
    const auto width = *rc::gen::inRange<std::size_t>(4, 42);
    const auto first = *rc::gen::inRange<std::size_t>(0, 3);
    const auto lines = wrapped(cells, width, first, 2 - first);
    RC_ASSERT(without_blanks(joined(lines)) == without_blanks(cells));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        RC_ASSERT(lines[i].size() <= width);
        RC_ASSERT(!lines[i].empty() && lines[i].back() != 0);
        const std::size_t indent = i == 0 ? first : 2 - first;
        RC_ASSERT(std::all_of(lines[i].begin(), lines[i].begin() + static_cast<long>(indent),
                              [](std::uint8_t cell) { return cell == 0; }));
    }
}

RC_GTEST_PROP(BrailleLines, BreakNoWordThatFits, ()) {
    const BrailleCells cells = *any_cells();
    RC_PRE(longest_word(cells) > 0);
    const auto lines = wrapped(cells, longest_word(cells));
    BrailleCells read;
    for (const BrailleCells& line : lines) {
        if (!read.empty()) read.push_back(0);
        read.insert(read.end(), line.begin(), line.end());
    }
    // Words and single blanks are those of the text.
    BrailleCells expected;
    for (const std::uint8_t cell : cells)
        if (cell != 0 || (!expected.empty() && expected.back() != 0)) expected.push_back(cell);
    if (!expected.empty() && expected.back() == 0) expected.pop_back();
    RC_ASSERT(read == expected);
}

RC_GTEST_PROP(BrailleLines, ShapesHaveOneWayForEachNumberOfRows, ()) {
    const BrailleCells cells = *any_cells();
    const auto shapes = label_shapes(cells, 24, 4);
    std::size_t rows = 0;
    for (const auto& shape : shapes) {
        RC_ASSERT(shape.size() > rows && shape.size() <= 4U);
        rows = shape.size();
        for (const BrailleCells& line : shape) RC_ASSERT(line.size() <= 24U);
        RC_ASSERT(without_blanks(joined(shape)) == without_blanks(cells));
    }
    RC_ASSERT(shapes.empty() || longest_word(cells) <= 24U);
}

TEST(BrailleLines, ATextOfBlanksIsNoCells) {
    EXPECT_EQ(cells_of("  \t ", {}).value(), BrailleCells{});
    EXPECT_EQ(cells_of(" a  b ", {}).value(), (BrailleCells{1, 0, 3}));
    EXPECT_TRUE(label_shapes({}, 24, 4).empty());
    EXPECT_TRUE(wrapped({}, 10).empty());
}

TEST(BrailleLines, ALanguageWithoutATableIsALine) {
    const auto cells = cells_of("a", {"xx", BrailleGrade::uncontracted});
    ASSERT_FALSE(cells.has_value());
    EXPECT_EQ(cells.error().line.find('\n'), std::string::npos);
}

TEST(SheetWords, PartsAreNamedOnceAndInPlaces) {
    TactileMap map = map_of_lines({line_through({{-50, 30}, {-40, 30}}, 1, "Ear"),
                                   line_through({{-30, 30}, {-25, 35}}, 1, "Ear"),
                                   line_through({{0, 0}, {0, 5}}, 2, "Nose"),
                                   line_through({{30, 0}, {30, 5}}, 2)});
    map.labels.push_back({"Garden", {0.04, -0.03}});
    map.labels.push_back({"Ear", {-0.04, 0.03}});
    map.description = "It faces left.";
    const auto parts = named_parts(map);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].outlines, (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(parts[2].name, "Garden");
    std::string told;
    for (const auto& paragraph : paragraphs_of(map, {1.5, {"Nose"}, {"Ear", "Garden"}}, Language()))
        told += paragraph.words + "\n";
    EXPECT_EQ(told,
              "Lines\nIt faces left.\nThe parts:\nEar: upper left\nNose: middle\n"
              "Garden: lower right\nLeft out, at least in places: Nose.\n"
              "On the sheet without a name: Ear, Garden.\n2 cm are 1.3 cm at the kiosk.\n");
}

/// A text beside a line that says the line's name is no second part; two places may share a name.
TEST(SheetWords, ATextIsAPartUnlessItNamesALine) {
    TactileMap map = map_of_lines({line_through({{-50, 30}, {-40, 30}}, 1, "Westport")});
    map.labels = {
        {"Westport", {-0.05, 0.02}}, {"Bench", {0.0, 0.0}}, {"Bench", {0.03, 0.0}}, {"", {}}};
    const auto parts = named_parts(map);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[0].outlines, std::vector<std::size_t>{0});
    EXPECT_EQ(parts[1].name, "Bench");
    EXPECT_EQ(parts[2].name, "Bench");
    EXPECT_NE(parts[1].place, parts[2].place);
}

TEST(SheetWords, WhatTracingNamesIsNamedByItsKindInTheLanguage) {
    TactileMap map =
        map_of_lines({line_through({{-50, 30}, {-40, 30}}, 1, "closed line, upper left"),
                      line_through({{-30, 30}, {-25, 35}}, 1, "line 2, middle"),
                      line_through({{0, 0}, {0, 5}}, 1, "dashed line, middle"),
                      line_through({{9, 0}, {9, 5}}, 1, "dashed line 2, middle"),
                      line_through({{20, 0}, {20, 5}}, 1, "left eye"),
                      line_through({{30, 0}, {30, 5}}, 1, "Closed line, by hand")});
    const Language german = Language::load(TOUCHLINE_CATALOGUES, "de").value();
    std::vector<std::string> names;
    for (const Outline& outline : named_for_paper(map, german).outlines)
        names.push_back(outline.label);
    EXPECT_EQ(names, (std::vector<std::string>{"", "", "gestrichelte Linie", "gestrichelte Linie 2",
                                               "linkes Auge", "Closed line, by hand"}));
}

TEST(SheetWords, TheOnlyPartIsTheTitle) {
    EXPECT_TRUE(
        named_parts(map_of_lines({line_through({{0, 0}, {9, 9}}, 1, "Star")}, "A star")).empty());
    EXPECT_EQ(named_parts(map_of_lines({line_through({{0, 0}, {9, 9}}, 1, "Star")}, "")).size(),
              1U);
}

TEST(SheetWords, LinesBeginAsBrailleDoes) {
    const auto lines = braille_lines({{ParagraphKind::title, "a b"},
                                      {ParagraphKind::text, "aaa bbb"},
                                      {ParagraphKind::item, "ccccc ddd"}},
                                     7, {});
    ASSERT_TRUE(lines.has_value());
    EXPECT_EQ(
        *lines,
        (std::vector<BrailleCells>{
            {0, 0, 1, 0, 3}, {}, {0, 0, 1, 1, 1}, {3, 3, 3}, {9, 9, 9, 9, 9}, {0, 0, 25, 25, 25}}));
}

}  // namespace
}  // namespace touchline
