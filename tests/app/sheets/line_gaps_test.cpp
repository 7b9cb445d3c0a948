#include "app/sheets/line_gaps.h"

#include "app/sheets/stroke_grid.h"
#include "tests/app/sheets/sheet_maps.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

constexpr PaperSize landscape{297.0, 210.0};
/// A place on the other line is further from where they meet.
constexpr double reach_mm = joint_reach_mm + least_clear_mm + 2.5;

constexpr PaperPlace place{{148.0, 105.0}, 1.5};

std::vector<SheetStroke> pieces_of(const PaperLines& lines, std::size_t source) {
    std::vector<SheetStroke> pieces;
    for (const SheetStroke& stroke : lines.strokes)
        if (stroke.source == source) pieces.push_back(stroke);
    return pieces;
}

double length_of(const PaperLines& lines, std::size_t source) {
    double sum = 0.0;
    for (const SheetStroke& piece : pieces_of(lines, source)) sum += length_mm(piece);
    return sum;
}

void expect_gaps(const PaperLines& lines) {
    for (std::size_t i = 0; i < lines.strokes.size(); ++i)
        for (std::size_t j = 0; j < lines.strokes.size(); ++j) {
            if (i == j || lines.strokes[i].source == lines.strokes[j].source) continue;
            const auto near =
                too_near(lines.strokes[i], lines.strokes[j], least_clear_mm - 0.1, reach_mm);
            EXPECT_EQ(near.size(), 0U)
                << "outlines " << lines.strokes[i].source << " and " << lines.strokes[j].source
                << " at " << (near.empty() ? 0.0 : near[0].x_mm) << ", "
                << (near.empty() ? 0.0 : near[0].y_mm);
        }
}

TEST(LineGaps, WhereTwoCrossTheLessImportantIsBroken) {
    const TactileMap map =
        map_of_lines({line_through({{-40, 0}, {40, 0}}, 2), line_through({{0, -30}, {0, 30}}, 1)});
    const PaperLines lines = paper_lines(map, place, landscape);
    ASSERT_EQ(pieces_of(lines, 1).size(), 1U);
    EXPECT_NEAR(length_of(lines, 1), 90.0, 1e-9);
    const auto broken = pieces_of(lines, 0);
    ASSERT_EQ(broken.size(), 2U);
    // 3 mm between the edges on each side, and the lines' own widths.
    const double gap = broken[1].points.front().x_mm - broken[0].points.back().x_mm;
    EXPECT_GE(std::abs(gap), 2.0 * 3.0 + 1.5 + 1.25);
    EXPECT_LE(std::abs(gap), 2.0 * 3.0 + 1.5 + 1.25 + 1.0);
    EXPECT_TRUE(lines.broken.empty());
    EXPECT_TRUE(lines.left_out.empty());
    expect_gaps(lines);
}

TEST(LineGaps, ALineThatEndsOnAnotherStaysJoined) {
    const TactileMap map =
        map_of_lines({line_through({{-40, 0}, {40, 0}}, 1), line_through({{0, 0}, {0, 30}}, 2)});
    for (const bool is_bar_less : {false, true}) {
        TactileMap other = map;
        if (is_bar_less) std::swap(other.outlines[0].detail, other.outlines[1].detail);
        const PaperLines lines = paper_lines(other, place, landscape);
        ASSERT_EQ(lines.strokes.size(), 2U);
        EXPECT_NEAR(length_of(lines, 0), 120.0, 1e-9);
        EXPECT_NEAR(length_of(lines, 1), 45.0, 1e-9);
    }
}

TEST(LineGaps, OfTwoSideBySideOneIsLeftOutAndTold) {
    const TactileMap map =
        map_of_lines({line_through({{-40, 0}, {40, 0}}, 1), line_through({{-40, 2}, {40, 2}}, 2)});
    const PaperLines lines = paper_lines(map, place, landscape);
    EXPECT_EQ(lines.left_out, std::vector<std::size_t>{1});
    ASSERT_EQ(lines.strokes.size(), 1U);
    const TactileMap partly = map_of_lines(
        {line_through({{-40, 0}, {40, 0}}, 1), line_through({{-40, 2}, {0, 2}, {0, 40}}, 2)});
    const PaperLines kept = paper_lines(partly, place, landscape);
    EXPECT_EQ(kept.broken, std::vector<std::size_t>{1});
    expect_gaps(kept);
    EXPECT_GT(length_of(kept, 1), 40.0);
    EXPECT_LT(length_of(kept, 1), 60.0);
}

TEST(LineGaps, AWallOfTwoRoomsIsOneLine) {
    const TactileMap map = map_of_lines({ring_through({{-30, -20}, {0, -20}, {0, 20}, {-30, 20}}),
                                         ring_through({{0, -20}, {30, -20}, {30, 20}, {0, 20}})});
    const PaperLines lines = paper_lines(map, place, landscape);
    EXPECT_TRUE(lines.broken.empty());
    EXPECT_TRUE(lines.left_out.empty());
    EXPECT_NEAR(length_of(lines, 0) + length_of(lines, 1), 2 * 210.0 - 60.0, 2.5);
    expect_gaps(lines);
}

TEST(LineGaps, TheSameLineTwiceIsOneAndNothingIsMissing) {
    const Outline ring = ring_through({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}});
    const PaperLines lines = paper_lines(map_of_lines({ring, ring}), place, landscape);
    EXPECT_EQ(lines.strokes.size(), 1U);
    EXPECT_TRUE(lines.left_out.empty());
}

TEST(LineGaps, WeightThenLengthDecideWithinOneDetail) {
    TactileMap map =
        map_of_lines({line_through({{-40, 0}, {40, 0}}), line_through({{-20, 2}, {20, 2}})});
    EXPECT_EQ(paper_lines(map, place, landscape).left_out, std::vector<std::size_t>{1});
    map.outlines[1].weight = 2.0;
    EXPECT_NEAR(length_of(paper_lines(map, place, landscape), 1), 60.0, 1e-9);
}

TEST(LineGaps, WidthsTellTheSilhouette) {
    const PaperLines lines = paper_lines(map_of_lines({line_through({{-40, 0}, {40, 0}}, 1),
                                                       line_through({{-40, 20}, {40, 20}}, 3)}),
                                         place, landscape);
    EXPECT_DOUBLE_EQ(pieces_of(lines, 0)[0].width_mm, 1.5);
    EXPECT_DOUBLE_EQ(pieces_of(lines, 1)[0].width_mm, 1.25);
}

/// Whatever the lines are, no two strokes are too near but at a joint.
RC_GTEST_PROP(LineGaps, HoldForAnyLines, ()) {
    const auto coordinate = rc::gen::map(rc::gen::inRange(-40, 41), [](int v) { return v * 1.0; });
    const auto count = *rc::gen::inRange<std::size_t>(2, 6);
    TactileMap map = map_of_lines({});
    for (std::size_t i = 0; i < count; ++i) {
        const auto points = *rc::gen::container<std::vector<std::pair<double, double>>>(
            *rc::gen::inRange<std::size_t>(2, 5), rc::gen::pair(coordinate, coordinate));
        if (points.front() == points.back()) continue;
        Outline outline = line_through(points, *rc::gen::inRange(1, 6));
        outline.is_closed = points.size() > 2 && *rc::gen::arbitrary<bool>();
        map.outlines.push_back(outline);
    }
    const PaperLines lines = paper_lines(map, place, landscape);
    for (std::size_t i = 0; i < lines.strokes.size(); ++i)
        for (std::size_t j = 0; j < lines.strokes.size(); ++j) {
            if (lines.strokes[i].source == lines.strokes[j].source) continue;
            RC_ASSERT(too_near(lines.strokes[i], lines.strokes[j], least_clear_mm - 0.15, reach_mm)
                          .empty());
        }
}

/// The grid answers as a look at every segment does.
RC_GTEST_PROP(LineGaps, TheGridIsRight, ()) {
    const auto x = rc::gen::map(rc::gen::inRange(0, 29700), [](int v) { return v / 100.0; });
    const auto y = rc::gen::map(rc::gen::inRange(0, 21000), [](int v) { return v / 100.0; });
    const SheetStroke stroke{{{*x, *y}, {*x, *y}, {*x, *y}}, false, 1.5, StrokeUse::outline, 7};
    StrokeGrid grid(landscape, 9.0);
    grid.add(stroke);
    for (int i = 0; i < 50; ++i) {
        const PaperPoint p{*x, *y};
        const double centre = std::min(segment_distance_mm(stroke.points[0], stroke.points[1], p),
                                       segment_distance_mm(stroke.points[1], stroke.points[2], p));
        if (centre < 8.0) RC_ASSERT(std::abs(grid.near(p).centre_mm - centre) < 1e-9);
        if (centre > 9.8) RC_ASSERT(grid.near(p).clear_mm == 9.0);
        RC_ASSERT(grid.near(p, 7).clear_mm == 9.0);
    }
}

}  // namespace
}  // namespace touchline
