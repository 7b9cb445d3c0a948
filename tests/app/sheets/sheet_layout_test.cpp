#include "app/sheets/sheet_layout.h"

#include "app/sheets/label_places.h"
#include "app/sheets/stroke_grid.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/app/sheets/sheet_maps.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(SheetLayout, HasTheSizesOfBraille) {
    const BrailleRow row{{20.0, 30.0}, {63, 63}};
    EXPECT_DOUBLE_EQ(dot_place(row, 0, 1).y_mm - dot_place(row, 0, 0).y_mm, 2.5);
    EXPECT_DOUBLE_EQ(dot_place(row, 0, 3).x_mm - dot_place(row, 0, 0).x_mm, 2.5);
    EXPECT_DOUBLE_EQ(dot_place(row, 1, 0).x_mm - dot_place(row, 0, 0).x_mm, 6.0);
}

TEST(SheetLayout, AMapWithoutLinesIsALine) {
    EXPECT_EQ(tactile_sheet({}, {}, Language()).error().line, "there is no line to print");
    TactileMap point = map_of_lines({line_through({{1, 1}, {1, 1}})});
    EXPECT_FALSE(tactile_sheet(point, {}, Language()).has_value());
}

TEST(SheetLayout, ATitleThatFillsThePageIsALine) {
    std::string title;
    for (int i = 0; i < 400; ++i) title += "word ";
    const auto sheet =
        tactile_sheet(map_of_lines({line_through({{0, 0}, {40, 0}})}, title), {}, Language());
    ASSERT_FALSE(sheet.has_value());
    EXPECT_EQ(sheet.error().line, "the title leaves no room for the lines");
}

/// A crowd of parts: what finds no room is told, and nothing overlaps.
TEST(SheetLayout, ACrowdIsToldRatherThanSqueezed) {
    TactileMap map = map_of_lines({});
    map.title = "Crowd";
    for (int i = 0; i < 40; ++i) {
        const double x = -50.0 + 10.0 * (i % 10);
        const double y = -30.0 + 18.0 * (i / 10);
        map.outlines.push_back(
            ring_through({{x, y}, {x + 6, y}, {x + 6, y + 6}, {x, y + 6}}, 2,
                         "A part with a long name, number " + std::to_string(i)));
    }
    const TactileSheet sheet = tactile_sheet(map, {}, Language()).value();
    EXPECT_GT(sheet.unlabelled.size(), 5U);
    std::size_t named = 0;
    for (const BrailleBlock& block : sheet.pages.front().blocks)
        if (block.words.starts_with("A part")) ++named;
    EXPECT_EQ(named + sheet.unlabelled.size(), 40U);
    const auto& blocks = sheet.pages.front().blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(gap_mm(box_of(blocks[i]), box_of(blocks[j])), least_clear_mm);
}

TEST(SheetLayout, ContractedBrailleIsShorter) {
    const auto pictures = shipped_pictures();
    std::size_t cells[2] = {0, 0};
    for (int g = 0; g < 2; ++g) {
        const SheetOrder order{
            PaperKind::a4, {"en", g == 0 ? BrailleGrade::uncontracted : BrailleGrade::contracted}};
        const TactileSheet sheet = tactile_sheet(pictures[5].map, order, Language()).value();
        for (const PaperPage& page : sheet.pages)
            for (const BrailleBlock& block : page.blocks)
                for (const BrailleRow& row : block.rows) cells[g] += row.cells.size();
    }
    EXPECT_LT(cells[1], cells[0]);
}

TEST(LeaderWay, IsBrokenAtALineThatItCrosses) {
    StrokeGrid grid({297.0, 210.0}, 9.0);
    grid.add({{{100, 50}, {100, 150}}, false, 1.5, StrokeUse::outline, 0});
    grid.add({{{130, 50}, {130, 150}}, false, 1.25, StrokeUse::outline, 1});
    const auto way = leader_way({100, 100}, {160, 100}, grid);
    ASSERT_TRUE(way.has_value());
    EXPECT_EQ(way->breaks, 1);
    ASSERT_EQ(way->pieces.size(), 2U);
    EXPECT_DOUBLE_EQ(way->pieces[0].points[0].x_mm, 100.0);
    EXPECT_LE(way->pieces[0].points[1].x_mm, 130.0 - 3.0 - 0.625 - 0.5);
    EXPECT_GE(way->pieces[1].points[0].x_mm, 130.0 + 3.0 + 0.625 + 0.5);
    EXPECT_DOUBLE_EQ(way->pieces[1].points[1].x_mm, 160.0);
    EXPECT_FALSE(leader_way({100, 60}, {102, 140}, grid).has_value());   // along its line
    EXPECT_FALSE(leader_way({100, 100}, {128, 100}, grid).has_value());  // ends at a line
    EXPECT_FALSE(leader_way({100, 100}, {103, 100}, grid).has_value());  // too short
}

}  // namespace
}  // namespace touchline
