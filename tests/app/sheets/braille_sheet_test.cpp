#include "app/sheets/braille_sheet.h"

#include "app/sheets/stroke_grid.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/app/sheets/rendered_page.h"
#include "tests/app/sheets/sheet_maps.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

/// The pages of a BRF as lines of characters.
std::vector<std::vector<std::string>> pages_in(const std::string& brf) {
    std::vector<std::vector<std::string>> pages(1);
    std::string line;
    for (const char c : brf) {
        if (c == '\f') {
            EXPECT_TRUE(line.empty());
            pages.emplace_back();
        } else if (c == '\n') {
            EXPECT_TRUE(line.ends_with('\r'));
            pages.back().push_back(line.substr(0, line.size() - 1));
            line.clear();
        } else {
            line += c;
        }
    }
    EXPECT_TRUE(pages.back().empty() && line.empty());
    pages.pop_back();
    return pages;
}

/// The pieces of raised dots that hang together, also over corners and over one cell's rim.
std::size_t pieces(const DotPicture& dots) {
    std::vector<bool> seen(dots.raised.size(), false);
    std::size_t count = 0;
    for (std::size_t start = 0; start < seen.size(); ++start) {
        if (!dots.raised[start] || seen[start]) continue;
        ++count;
        std::queue<std::size_t> left({start});
        seen[start] = true;
        while (!left.empty()) {
            const auto x = static_cast<long>(left.front() % dots.columns);
            const auto y = static_cast<long>(left.front() / dots.columns);
            left.pop();
            for (long v = y - 1; v <= y + 1; ++v)
                for (long u = x - 1; u <= x + 1; ++u) {
                    if (u < 0 || v < 0 || u >= static_cast<long>(dots.columns) ||
                        v >= static_cast<long>(dots.rows))
                        continue;
                    const auto i =
                        static_cast<std::size_t>(v) * dots.columns + static_cast<std::size_t>(u);
                    if (dots.raised[i] && !seen[i]) {
                        seen[i] = true;
                        left.push(i);
                    }
                }
        }
    }
    return count;
}

TEST(BrailleSheet, EveryPictureFitsAnEmbosser) {
    for (const char* code : {"en", "de", "fr", "es", "it"}) {
        const Language language = Language::load(TOUCHLINE_CATALOGUES, code).value();
        for (const ShippedPicture& picture : shipped_pictures({code})) {
            const BrailleHand hand{code, BrailleGrade::uncontracted};
            auto all = word_pages(picture.map, hand, language).value();
            const auto drawing = drawing_pages(picture.map, hand).value();
            all.insert(all.end(), drawing.begin(), drawing.end());
            const auto pages = pages_in(brf_of(all));
            EXPECT_GE(pages.size(), 2U);
            for (const auto& page : pages) {
                EXPECT_LE(page.size(), 24U) << picture.name;
                for (const std::string& line : page) {
                    EXPECT_LE(line.size(), 40U) << picture.name;
                    EXPECT_FALSE(line.ends_with(' '));
                    for (const char c : line) EXPECT_TRUE(c >= ' ' && c <= '_') << picture.name;
                }
            }
            EXPECT_EQ(pages.back().size(), 24U);
        }
    }
}

TEST(BrailleSheet, TheWordsReadBackAreTheWords) {
    const TactileMap map = shipped_pictures()[5].map;
    const auto pages = word_pages(map, {"en", BrailleGrade::uncontracted}, Language()).value();
    BrailleCells cells;
    for (const auto& page : pages)
        for (const BrailleCells& line : page) {
            if (!cells.empty() && cells.back() != 0) cells.push_back(0);
            for (const std::uint8_t cell : line)
                if (cell != 0 || (!cells.empty() && cells.back() != 0)) cells.push_back(cell);
        }
    const std::string words = back_translated(cells, "en-ueb-g1.ctb");
    EXPECT_TRUE(words.starts_with(map.title + " " + map.description)) << words;
    EXPECT_NE(words.find("The parts:"), std::string::npos);
    for (const Outline& outline : map.outlines)
        EXPECT_NE(words.find(outline.label + ": "), std::string::npos) << outline.label;
}

TEST(BrailleSheet, ALineIsOnePieceOfDotsAndTwoAreTwo) {
    const DotLattice text = text_lattice(40, 23);
    EXPECT_EQ(text.x_mm.size(), 80U);
    EXPECT_EQ(text.y_mm.size(), 69U);
    EXPECT_DOUBLE_EQ(text.x_mm[1], 2.5);
    EXPECT_DOUBLE_EQ(text.x_mm[2], 6.0);
    EXPECT_DOUBLE_EQ(text.y_mm[3], 10.0);
    for (const DotLattice& lattice : {text, graphic_lattice(PaperKind::a4)}) {
        const TactileMap one = map_of_lines({ring_through({{-40, -25}, {40, -20}, {10, 25}})});
        EXPECT_EQ(pieces(dots_of(one, lattice).value()), 1U);
        const TactileMap two = map_of_lines({ring_through({{-40, -25}, {40, -20}, {10, 25}}),
                                             ring_through({{-10, -12}, {10, -12}, {5, 2}})});
        EXPECT_EQ(pieces(dots_of(two, lattice).value()), 2U);
    }
    EXPECT_FALSE(dots_of({}, text).has_value());
}

/// Where `place` is nearer to places[i] than to its neighbours, or at most `by` further.
bool is_nearest(const std::vector<double>& places, std::size_t i, double place, double by) {
    const double far = std::abs(places[i] - place) - by;
    return (i == 0 || far <= std::abs(places[i - 1] - place)) &&
           (i + 1 == places.size() || far <= std::abs(places[i + 1] - place));
}

/// The way of a line through the part of the paper that is nearest to each dot, in steps of
/// 0.05 mm.
std::vector<double> ways_mm(const SheetStroke& line, const DotLattice& lattice, double by) {
    constexpr double step_mm = 0.05;
    std::vector<double> ways(lattice.x_mm.size() * lattice.y_mm.size(), 0.0);
    for (const PaperPoint& p : sampled(line, step_mm))
        for (std::size_t y = 0; y < lattice.y_mm.size(); ++y) {
            if (!is_nearest(lattice.y_mm, y, p.y_mm, by)) continue;
            for (std::size_t x = 0; x < lattice.x_mm.size(); ++x)
                if (is_nearest(lattice.x_mm, x, p.x_mm, by))
                    ways[y * lattice.x_mm.size() + x] += step_mm;
        }
    return ways;
}

/// A dot is raised if the line passes nearer to it than to others for 0.6 mm, and only if it passes
/// so at all. The line is as large as the page, or 2.5 times as large as at the kiosk.
RC_GTEST_PROP(BrailleSheet, DotsLieOnTheLine, ()) {
    const auto coordinate =
        rc::gen::map(rc::gen::inRange(-580, 581), [](int v) { return v / 10.0; });
    const auto points = *rc::gen::container<std::vector<std::pair<double, double>>>(
        3, rc::gen::pair(coordinate, coordinate));
    RC_PRE(std::set(points.begin(), points.end()).size() == 3U);
    const TactileMap map = map_of_lines({line_through(points)});
    const DotLattice lattice = text_lattice(40, 23);
    const DotPicture dots = dots_of(map, lattice).value();
    RC_ASSERT(pieces(dots) == 1U);

    // From x and y in millimetres of W to the paper: told here again.
    const auto range = [&points](auto coordinate_of) {
        const auto [low, high] = std::ranges::minmax(points, {}, coordinate_of);
        return std::pair(coordinate_of(low), coordinate_of(high));
    };
    const auto [left, right] = range([](const auto& p) { return p.first; });
    const auto [bottom, top] = range([](const auto& p) { return p.second; });
    const double width_mm = 39.0 * 6.0 + 2.5;
    const double height_mm = 22.0 * 10.0 + 5.0;
    const double scale =
        std::min({2.5, width_mm / (right - left), height_mm / (top - bottom)});  // by 0: infinite
    SheetStroke line;
    for (const auto& [x, y] : points)
        line.points.push_back({width_mm / 2.0 + scale * (x - (left + right) / 2.0),
                               height_mm / 2.0 - scale * (y - (bottom + top) / 2.0)});
    // A line half-way between two dots may raise either; and between two samples lie 0.05 mm.
    const std::vector<double> maybe = ways_mm(line, lattice, 0.05);
    for (std::size_t i = 0; i < maybe.size(); ++i)
        if (dots.raised[i]) RC_ASSERT(maybe[i] > 0.0);
    for (std::size_t k = 0; k < 2; ++k) {
        const std::vector<double> surely =
            ways_mm({.points = {line.points[k], line.points[k + 1]}}, lattice, -1e-6);
        for (std::size_t i = 0; i < surely.size(); ++i)
            if (surely[i] > 0.6) RC_ASSERT(dots.raised[i]);
    }
}

/// A line that is shorter than the way between two dots is one dot.
TEST(BrailleSheet, TheShortestLineIsADot) {
    const TactileMap map = map_of_lines({line_through({{-40, -40}, {-40, -39.8}})});
    const DotPicture dots = dots_of(map, text_lattice(40, 23)).value();
    EXPECT_EQ(std::ranges::count(dots.raised, true), 1);
}

DotPicture dots_from(const std::vector<std::string>& rows) {
    DotPicture dots{rows[0].size(), rows.size(), {}};
    for (const std::string& row : rows)
        for (const char c : row) dots.raised.push_back(c == '#');
    return dots;
}

TEST(BrailleSheet, UnicodePatternsAreThoseOfTheStandard) {
    EXPECT_EQ(ubrl_of(dots_from({"#.", "..", "..", ".."})), "⠁\n");
    EXPECT_EQ(ubrl_of(dots_from({"..", "#.", "..", ".."})), "⠂\n");
    EXPECT_EQ(ubrl_of(dots_from({"..", "..", "#.", ".."})), "⠄\n");
    EXPECT_EQ(ubrl_of(dots_from({"..", "..", "..", "#."})), "⡀\n");
    EXPECT_EQ(ubrl_of(dots_from({".#", "..", "..", ".."})), "⠈\n");
    EXPECT_EQ(ubrl_of(dots_from({"..", "..", "..", ".#"})), "⢀\n");
    EXPECT_EQ(ubrl_of(dots_from({"##", "##", "##", "##"})), "⣿\n");
    EXPECT_EQ(ubrl_of(dots_from({"....", "....", "....", "..##", "#..."})), "⠀⣀\n⠁⠀\n");
}

/// Rows of the table by which Debian's filter imageubrltoindexv4 tells an Index embosser, and the
/// signs before and after.
TEST(BrailleSheet, AnIndexEmbosserIsToldAsDebiansFilterTellsIt) {
    const auto graphic = [](const std::vector<std::string>& rows) {
        const std::string all = index_of({}, dots_from(rows));
        const auto begin = all.find("\x1b\x07") + 2;
        return all.substr(begin, all.find("\x1b\x06") - begin);
    };
    EXPECT_EQ(graphic({"#.", "..", "..", ".."}), "A\r\n");   // A@, without the '@' at the end
    EXPECT_EQ(graphic({"..", "..", "#.", ".."}), "D\r\n");   // D@
    EXPECT_EQ(graphic({"..", "..", "..", "#."}), "H\r\n");   // H@
    EXPECT_EQ(graphic({".#", "..", "..", ".."}), "@A\r\n");  // @A
    EXPECT_EQ(graphic({"#.", "##", "..", ".#"}), "CJ\r\n");
    EXPECT_EQ(graphic({"##", "##", "##", "##"}), "OO\r\n");
    EXPECT_EQ(graphic({"..", "..", "..", ".."}), "\r\n");
    const std::string words = index_of({{{1, 0, 32, 63}, {}}}, dots_from({"..", "..", "..", ".."}));
    EXPECT_TRUE(
        words.starts_with("\x1b"
                          "DTM0,BI0,"));
    // Four cells in transparent mode: dots 1 to 3 in the low half, 4 to 6 in the high one.
    const std::string told{'\x1b', '\\', 4, 0, 1, 0, 0x40, 0x77, '\r', '\n', '\r', '\n', '\f'};
    EXPECT_NE(words.find(told), std::string::npos);
    EXPECT_TRUE(words.ends_with("\x1b\x06\x1a"));
}

TEST(BrailleSheet, GraphicPagesKeepToThePaper) {
    const DotLattice a4 = graphic_lattice(PaperKind::a4);
    EXPECT_EQ(a4.x_mm.size(), 98U);
    EXPECT_EQ(a4.y_mm.size(), 140U);
    const DotLattice letter = graphic_lattice(PaperKind::letter);
    EXPECT_EQ(letter.x_mm.size(), 102U);
    EXPECT_EQ(letter.y_mm.size(), 132U);
    for (const ShippedPicture& picture : shipped_pictures()) {
        const std::string text = ubrl_of(dots_of(picture.map, a4).value());
        std::istringstream lines(text);
        std::size_t rows = 0;
        for (std::string line; std::getline(lines, line); ++rows)
            EXPECT_EQ(line.size(), 49U * 3U) << picture.name;
        EXPECT_EQ(rows, 35U) << picture.name;
        EXPECT_LT(index_of({}, dots_of(picture.map, a4).value()).size(), 35U * 100U + 60U);
    }
}

}  // namespace
}  // namespace touchline
