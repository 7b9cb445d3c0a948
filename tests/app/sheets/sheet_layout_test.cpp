// The rules of paper for fingers, on every picture of the gallery.
#include "app/sheets/sheet_layout.h"

#include "app/sheets/label_places.h"
#include "app/sheets/line_gaps.h"
#include "app/sheets/sheet_words.h"
#include "app/sheets/stroke_grid.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/app/sheets/sheet_maps.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Language language_of(const std::string& code) {
    return Language::load(TOUCHLINE_CATALOGUES, code).value();
}

struct GallerySheet {
    std::string name;
    TactileMap map;
    TactileSheet sheet;
};

/// Every picture in one language and on one paper, laid out once.
const std::vector<GallerySheet>& gallery_sheets(const std::string& code, PaperKind paper) {
    static std::map<std::pair<std::string, PaperKind>, std::vector<GallerySheet>> all;
    auto& sheets = all[{code, paper}];
    if (!sheets.empty()) return sheets;
    const SheetOrder order{paper, {code, BrailleGrade::uncontracted}};
    for (const ShippedPicture& picture : shipped_pictures({code}))
        sheets.push_back({picture.name, picture.map,
                          tactile_sheet(picture.map, order, language_of(code)).value()});
    return sheets;
}

class EverySheet : public testing::TestWithParam<std::pair<const char*, PaperKind>> {
  protected:
    [[nodiscard]] static const std::vector<GallerySheet>& sheets() {
        return gallery_sheets(GetParam().first, GetParam().second);
    }
};

INSTANTIATE_TEST_SUITE_P(All, EverySheet,
                         testing::Values(std::pair("en", PaperKind::a4),
                                         std::pair("en", PaperKind::letter),
                                         std::pair("de", PaperKind::a4)));

PaperBox ink_of(const SheetStroke& stroke) {
    PaperBox box{1e9, 1e9, -1e9, -1e9};
    for (const PaperPoint& p : stroke.points)
        box = {std::min(box.left_mm, p.x_mm), std::min(box.top_mm, p.y_mm),
               std::max(box.right_mm, p.x_mm), std::max(box.bottom_mm, p.y_mm)};
    return grown(box, stroke.width_mm / 2.0);
}

bool is_within(const PaperBox& inner, const PaperBox& outer) {
    constexpr double rounding_mm = 1e-6;
    return inner.left_mm >= outer.left_mm - rounding_mm &&
           inner.top_mm >= outer.top_mm - rounding_mm &&
           inner.right_mm <= outer.right_mm + rounding_mm &&
           inner.bottom_mm <= outer.bottom_mm + rounding_mm;
}

double gap_mm(const PaperBox& a, const PaperBox& b) {
    return std::hypot(std::max({a.left_mm - b.right_mm, b.left_mm - a.right_mm, 0.0}),
                      std::max({a.top_mm - b.bottom_mm, b.top_mm - a.bottom_mm, 0.0}));
}

TEST_P(EverySheet, IsWithinTheMargins) {
    for (const auto& [name, map, sheet] : sheets())
        for (const PaperPage& page : sheet.pages) {
            const PaperSize size = size_of(GetParam().second);
            EXPECT_EQ(std::min(page.size.width_mm, page.size.height_mm), size.width_mm);
            EXPECT_EQ(std::max(page.size.width_mm, page.size.height_mm), size.height_mm);
            const PaperBox area{10.0, 10.0, page.size.width_mm - 10.0, page.size.height_mm - 10.0};
            for (const SheetStroke& stroke : page.strokes)
                EXPECT_TRUE(is_within(ink_of(stroke), area)) << name;
            for (const BrailleBlock& block : page.blocks)
                EXPECT_TRUE(is_within(box_of(block), area)) << name << ": " << block.words;
            for (const SheetPrint& print : page.prints)
                EXPECT_TRUE(is_within({print.base.x_mm, print.base.y_mm - print.cap_mm,
                                       print.base.x_mm + print.width_mm, print.base.y_mm},
                                      area))
                    << name;
        }
}

TEST_P(EverySheet, BrailleIsClearOfLinesAndOtherBraille) {
    for (const auto& [name, map, sheet] : sheets()) {
        const PaperPage& page = sheet.pages.front();
        for (std::size_t i = 0; i < page.blocks.size(); ++i) {
            const PaperBox box = box_of(page.blocks[i]);
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GE(gap_mm(box, box_of(page.blocks[j])), least_clear_mm)
                    << name << ": " << page.blocks[i].words << ", " << page.blocks[j].words;
            for (const SheetStroke& stroke : page.strokes)
                for (const PaperPoint& p : sampled(stroke, 0.5))
                    EXPECT_GE(distance_mm(box, p) - stroke.width_mm / 2.0, least_clear_mm - 1e-6)
                        << name << ": " << page.blocks[i].words;
            for (const SheetPrint& print : page.prints)
                EXPECT_GE(print.base.y_mm - print.cap_mm - box.bottom_mm, least_clear_mm) << name;
        }
    }
}

TEST_P(EverySheet, LinesKeepTheirGaps) {
    for (const auto& [name, map, sheet] : sheets()) {
        const auto& strokes = sheet.pages.front().strokes;
        for (std::size_t i = 0; i < strokes.size(); ++i)
            for (std::size_t j = 0; j < strokes.size(); ++j) {
                const SheetStroke& a = strokes[i];
                const SheetStroke& b = strokes[j];
                const bool is_same = a.use == b.use && a.source == b.source;
                if (i == j || is_same) continue;
                const auto near =
                    too_near(a, b, least_clear_mm - 0.1,
                             a.use == StrokeUse::outline && b.use == StrokeUse::outline
                                 ? joint_reach_mm + least_clear_mm + 2.5
                                 : 9.0);
                EXPECT_EQ(near.size(), 0U) << name << ": strokes " << i << " and " << j << " at "
                                           << (near.empty() ? 0.0 : near[0].x_mm) << ", "
                                           << (near.empty() ? 0.0 : near[0].y_mm);
            }
    }
}

TEST_P(EverySheet, LinesAreAsWideAsTheyShouldBe) {
    for (const auto& [name, map, sheet] : sheets())
        for (const SheetStroke& stroke : sheet.pages.front().strokes) {
            if (stroke.points.size() == 1) continue;  // the dot of a place
            EXPECT_GE(stroke.width_mm, 1.0) << name;
            EXPECT_LE(stroke.width_mm, 1.5) << name;
            const double least_mm = stroke.use == StrokeUse::outline ? 1.25 : 1.0;
            EXPECT_GE(stroke.width_mm, least_mm) << name;
            if (stroke.use != StrokeUse::outline) {
                EXPECT_DOUBLE_EQ(stroke.width_mm, 1.0) << name;
            }
        }
}

TEST_P(EverySheet, EveryPartIsNamedWithALeaderOrTold) {
    std::size_t labels = 0;
    std::size_t unlabelled = 0;
    for (const auto& [name, map, sheet] : sheets()) {
        const PaperPage& page = sheet.pages.front();
        for (const NamedPart& part : named_parts(map)) {
            const auto block = std::ranges::find(page.blocks, part.name, &BrailleBlock::words);
            const auto is_told = [&part](const std::vector<std::string>& names) {
                return std::ranges::find(names, part.name) != names.end();
            };
            ++labels;
            if (block == page.blocks.end()) {
                ++unlabelled;
                EXPECT_TRUE(is_told(sheet.unlabelled) || is_told(sheet.left_out))
                    << name << ": " << part.name;
                continue;
            }
            if (part.outlines.empty()) continue;
            // Its leader begins on one of its lines and ends before the label.
            const auto source = static_cast<std::size_t>(block - page.blocks.begin());
            double to_label = 1e9;
            double to_line = 1e9;
            for (const SheetStroke& leader : page.strokes) {
                if (leader.use != StrokeUse::leader || leader.source != source) continue;
                to_label = std::min(to_label, distance_mm(box_of(*block), leader.points.back()));
                for (const SheetStroke& line : page.strokes)
                    if (line.use == StrokeUse::outline)
                        for (std::size_t k = 0; k + 1 < line.points.size(); ++k)
                            to_line = std::min(
                                to_line, segment_distance_mm(line.points[k], line.points[k + 1],
                                                             leader.points.front()));
            }
            EXPECT_NEAR(to_label, least_clear_mm + 0.5, 0.01) << name << ": " << part.name;
            EXPECT_LT(to_line, 1.0) << name << ": " << part.name;
        }
    }
    EXPECT_GT(labels, 200U);
    RecordProperty("labels", static_cast<int>(labels));
    RecordProperty("unlabelled", static_cast<int>(unlabelled));
    EXPECT_LE(unlabelled, labels / 10);
}

TEST_P(EverySheet, SaysItsTitleItsScaleAndWhichSideIsUp) {
    const Language language = language_of(GetParam().first);
    for (const auto& [name, map, sheet] : sheets()) {
        const auto has = [&](const std::string& words) {
            return std::ranges::count(sheet.pages.front().blocks, words, &BrailleBlock::words) == 1;
        };
        EXPECT_TRUE(has(map.title)) << name;
        EXPECT_TRUE(has(up_words(language))) << name;
        EXPECT_TRUE(has(scale_words(sheet.scale, language))) << name;
        EXPECT_GE(sheet.pages.size(), 2U) << name;  // its description
        EXPECT_GE(sheet.scale, 0.9) << name;
    }
}

TEST_P(EverySheet, HasTheSizesOfBraille) {
    const BrailleRow row{{20.0, 30.0}, {63, 63}};
    EXPECT_DOUBLE_EQ(dot_place(row, 0, 1).y_mm - dot_place(row, 0, 0).y_mm, 2.5);
    EXPECT_DOUBLE_EQ(dot_place(row, 0, 3).x_mm - dot_place(row, 0, 0).x_mm, 2.5);
    EXPECT_DOUBLE_EQ(dot_place(row, 1, 0).x_mm - dot_place(row, 0, 0).x_mm, 6.0);
    for (const auto& [name, map, sheet] : sheets())
        for (const PaperPage& page : sheet.pages)
            for (const BrailleBlock& block : page.blocks)
                for (std::size_t i = 1; i < block.rows.size(); ++i)
                    EXPECT_NEAR(block.rows[i].first_dot.y_mm - block.rows[i - 1].first_dot.y_mm,
                                10.0, 1e-9);
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
