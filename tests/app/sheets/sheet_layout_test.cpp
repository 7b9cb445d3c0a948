#include "app/sheets/sheet_layout.h"

#include "app/sheets/label_places.h"
#include "app/sheets/leader_way.h"
#include "app/sheets/paper_faces.h"
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
    EXPECT_FALSE(leader_way({100, 100}, {100, 100}, grid).has_value());
}

TEST(LeaderWay, HasNoGapThatAFingertipDoesNotBridge) {
    StrokeGrid grid({297.0, 210.0}, 9.0);
    grid.add({{{130, 50}, {130, 150}}, false, 1.25, StrokeUse::outline, 1});
    EXPECT_TRUE(leader_way({100, 80}, {160, 120}, grid).has_value());
    EXPECT_FALSE(leader_way({115, 70}, {145, 130}, grid).has_value());  // 18 mm along the leader
}

TEST(LeaderWay, TellsHowMuchOfItIsNearToALine) {
    StrokeGrid grid({297.0, 210.0}, 9.0);
    grid.add({{{130, 50}, {130, 150}}, false, 1.0, StrokeUse::outline, 1});
    EXPECT_NEAR(leader_way({100, 100}, {160, 100}, grid)->near_mm, 2.0 * 3.0, 0.8);
    EXPECT_NEAR(leader_way({135, 60}, {135, 140}, grid)->near_mm, 80.0, 0.8);
    EXPECT_NEAR(leader_way({138, 60}, {138, 140}, grid)->near_mm, 0.0, 1e-9);
}

WantedLabel wanted_at(std::vector<PaperPoint> anchors) {
    return {0, std::move(anchors), false, {{BrailleCells(8, 63)}}};
}

SheetStroke box_ring(const PaperBox& box) {
    return {{{box.left_mm, box.top_mm},
             {box.right_mm, box.top_mm},
             {box.right_mm, box.bottom_mm},
             {box.left_mm, box.bottom_mm}},
            true,
            1.25,
            StrokeUse::outline,
            0};
}

/// A market's name in the park would make the park a market.
TEST(LabelPlaces, NoneLiesInAShapeThatItDoesNotName) {
    const PaperSize page{200.0, 100.0};
    const PaperBox zone{10.0, 10.0, 190.0, 90.0};
    const std::vector<SheetStroke> lines{
        box_ring({100.0, 14.0, 180.0, 86.0}),
        {{{85.0, 30.0}, {85.0, 70.0}}, false, 1.25, StrokeUse::outline, 1}};
    const auto plan = placed_labels({wanted_at({{85.0, 50.0}})}, lines, lines, page, zone);
    ASSERT_EQ(plan.placed.size(), 1U);
    EXPECT_LT(box_of({{}, plan.placed[0].rows}).right_mm, 85.0);
    // Without room at the left it is told in the words.
    const PaperBox narrow{84.0, 10.0, 190.0, 90.0};
    EXPECT_EQ(placed_labels({wanted_at({{85.0, 50.0}})}, lines, lines, page, narrow).without_room,
              std::vector<std::size_t>{0});
    // What lies in the box, or is the box, may be named there.
    EXPECT_EQ(placed_labels({wanted_at({{100.0, 50.0}})}, lines, lines, page, narrow).placed.size(),
              1U);
    // The same box in two open lines is no other box.
    const std::vector<SheetStroke> halves{
        {{{140.0, 14.0}, {100.0, 14.0}, {100.0, 86.0}, {140.0, 86.0}},
         false,
         1.25,
         StrokeUse::outline,
         0},
        {{{140.0, 14.0}, {180.0, 14.0}, {180.0, 86.0}, {140.0, 86.0}},
         false,
         1.25,
         StrokeUse::outline,
         2},
        lines[1]};
    EXPECT_EQ(placed_labels({wanted_at({{85.0, 50.0}})}, halves, halves, page, narrow).without_room,
              std::vector<std::size_t>{0});
    const std::vector<SheetStroke> inside{
        lines[0], {{{110.0, 30.0}, {110.0, 70.0}}, false, 1.25, StrokeUse::outline, 1}};
    EXPECT_EQ(
        placed_labels({wanted_at({{110.0, 50.0}})}, inside, inside, page, narrow).placed.size(),
        1U);
}

TEST(PaperFaces, AreWhatLinesCloseOffTogether) {
    const PaperSize page{100.0, 100.0};
    const SheetStroke left{
        {{50, 20}, {20, 20}, {20, 80}, {50, 80}}, false, 1.25, StrokeUse::outline, 0};
    SheetStroke right{{{50, 20}, {80, 20}, {80, 80}, {50, 80}}, false, 1.25, StrokeUse::outline, 1};
    const SheetStroke eye = box_ring({40.0, 40.0, 60.0, 60.0});
    PaperFaces faces({left, right, eye}, page);
    EXPECT_EQ(faces.face_at({5, 5}), PaperFaces::open);
    EXPECT_EQ(faces.face_at({-5, 500}), PaperFaces::open);
    EXPECT_EQ(faces.face_at({20, 50}), PaperFaces::line);
    const std::size_t body = faces.face_at({30, 50});
    const std::size_t inner = faces.face_at({50, 50});
    EXPECT_GT(body, PaperFaces::line);
    EXPECT_GT(inner, PaperFaces::line);
    EXPECT_NE(body, inner);
    EXPECT_EQ(body, faces.face_at({70, 30}));
    EXPECT_TRUE(faces.is_around(body, {40, 50}));
    EXPECT_TRUE(faces.is_around(body, {50, 50}));
    EXPECT_FALSE(faces.is_around(body, {20, 50}));
    EXPECT_FALSE(faces.is_around(inner, {30, 50}));
    right.points.back() = {53, 80};  // a gap
    EXPECT_EQ(PaperFaces({left, right, eye}, page).face_at({30, 50}), PaperFaces::open);
}

/// A finger that reads on along the row must not read both as one.
TEST(LabelPlaces, LabelsInOneRowAreFurtherApartThanWords) {
    const PaperSize page{200.0, 60.0};
    const PaperBox zone{10.0, 20.0, 190.0, 32.0};  // a single row
    const auto gap_with = [&](const std::vector<SheetStroke>& lines) {
        const auto plan = placed_labels({{0, {{75.0, 26.0}}, true, {{BrailleCells(8, 63)}}},
                                         {1, {{130.0, 26.0}}, true, {{BrailleCells(8, 63)}}}},
                                        lines, lines, page, zone);
        EXPECT_EQ(plan.placed.size(), 2U);
        return gap_mm(box_of({{}, plan.placed[0].rows}), box_of({{}, plan.placed[1].rows}));
    };
    EXPECT_GE(gap_with({}), braille_beside_mm);
    const double with_line_mm =
        gap_with({{{{102.5, 5.0}, {102.5, 55.0}}, false, 1.25, StrokeUse::outline, 0}});
    EXPECT_LT(with_line_mm, braille_beside_mm);
    EXPECT_GE(with_line_mm, braille_label_mm);
}

TEST(LabelPlaces, ALeaderPointsAtItsLabelFromEverySide) {
    const PaperSize page{200.0, 100.0};
    for (const PaperBox& zone : {PaperBox{10, 10, 60, 30}, PaperBox{140, 10, 190, 30},
                                 PaperBox{10, 70, 60, 90}, PaperBox{140, 70, 190, 90}}) {
        const std::vector<SheetStroke> lines{
            {{{99.0, 50.0}, {101.0, 50.0}}, false, 1.25, StrokeUse::outline, 0}};
        const auto plan = placed_labels({wanted_at({{100.0, 50.0}})}, lines, lines, page, zone);
        ASSERT_EQ(plan.placed.size(), 1U);
        const PaperPoint end = plan.placed[0].leader.back().points.back();
        EXPECT_NEAR(distance_mm(box_of({{}, plan.placed[0].rows}), end), 3.5, 1e-6);
    }
}

}  // namespace
}  // namespace touchline
