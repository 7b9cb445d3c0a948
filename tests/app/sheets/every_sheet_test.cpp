// The rules of paper for fingers, on every picture of the gallery.
#include "app/sheets/label_places.h"
#include "app/sheets/line_gaps.h"
#include "app/sheets/sheet_layout.h"
#include "app/sheets/sheet_words.h"
#include "app/sheets/stroke_grid.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/app/sheets/sheet_maps.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double rounding_mm = 1e-6;

PaperBox ink_of(const SheetStroke& stroke) {
    PaperBox box{1e9, 1e9, -1e9, -1e9};
    for (const PaperPoint& p : stroke.points)
        box = {std::min(box.left_mm, p.x_mm), std::min(box.top_mm, p.y_mm),
               std::max(box.right_mm, p.x_mm), std::max(box.bottom_mm, p.y_mm)};
    return grown(box, stroke.width_mm / 2.0);
}

bool is_within(const PaperBox& inner, const PaperBox& outer) {
    return inner.left_mm >= outer.left_mm - rounding_mm &&
           inner.top_mm >= outer.top_mm - rounding_mm &&
           inner.right_mm <= outer.right_mm + rounding_mm &&
           inner.bottom_mm <= outer.bottom_mm + rounding_mm;
}

void expect_margins(const TactileSheet& sheet, PaperSize size) {
    for (const PaperPage& page : sheet.pages) {
        EXPECT_EQ(std::min(page.size.width_mm, page.size.height_mm), size.width_mm);
        EXPECT_EQ(std::max(page.size.width_mm, page.size.height_mm), size.height_mm);
        const PaperBox area{10.0, 10.0, page.size.width_mm - 10.0, page.size.height_mm - 10.0};
        for (const SheetStroke& stroke : page.strokes) EXPECT_TRUE(is_within(ink_of(stroke), area));
        for (const BrailleBlock& block : page.blocks)
            EXPECT_TRUE(is_within(box_of(block), area)) << block.words;
        for (const SheetPrint& print : page.prints)
            EXPECT_TRUE(is_within({print.base.x_mm, print.base.y_mm - print.cap_mm,
                                   print.base.x_mm + print.width_mm, print.base.y_mm},
                                  area));
    }
}

void expect_clear_braille(const PaperPage& page) {
    for (std::size_t i = 0; i < page.blocks.size(); ++i) {
        const PaperBox box = box_of(page.blocks[i]);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(gap_mm(box, box_of(page.blocks[j])), least_clear_mm)
                << page.blocks[i].words << ", " << page.blocks[j].words;
        for (const SheetStroke& stroke : page.strokes)
            for (const PaperPoint& p : sampled(stroke, 0.5))
                EXPECT_GE(distance_mm(box, p) - stroke.width_mm / 2.0, least_clear_mm - rounding_mm)
                    << page.blocks[i].words;
        for (const SheetPrint& print : page.prints)
            EXPECT_GE(print.base.y_mm - print.cap_mm - box.bottom_mm, least_clear_mm);
    }
}

/// Two lines may be near each other only near a place where they meet.
void expect_gaps(const std::vector<SheetStroke>& strokes) {
    for (const SheetStroke& a : strokes)
        for (const SheetStroke& b : strokes) {
            if (a.use == b.use && a.source == b.source) continue;
            const bool are_outlines = a.use == StrokeUse::outline && b.use == StrokeUse::outline;
            const auto near = too_near(a, b, least_clear_mm - 0.1,
                                       are_outlines ? joint_reach_mm + least_clear_mm + 2.5 : 9.0);
            EXPECT_TRUE(near.empty())
                << "strokes " << &a - strokes.data() << " and " << &b - strokes.data() << " at "
                << near.front().x_mm << ", " << near.front().y_mm;
        }
}

void expect_widths(const std::vector<SheetStroke>& strokes) {
    for (const SheetStroke& stroke : strokes) {
        if (stroke.points.size() == 1) continue;  // the dot of a place
        const bool is_outline = stroke.use == StrokeUse::outline;
        EXPECT_GE(stroke.width_mm, is_outline ? 1.25 : 1.0);
        EXPECT_LE(stroke.width_mm, is_outline ? 1.5 : 1.0);
    }
}

/// How far a label's leader ends from the label, and begins from the nearest line of its part.
struct LeaderEnds {
    double to_label_mm = std::numeric_limits<double>::infinity();
    double to_line_mm = std::numeric_limits<double>::infinity();
};

LeaderEnds leader_ends(const PaperPage& page, std::size_t block, const NamedPart& part) {
    LeaderEnds ends;
    for (const SheetStroke& leader : page.strokes) {
        if (leader.use != StrokeUse::leader || leader.source != block) continue;
        ends.to_label_mm = std::min(ends.to_label_mm,
                                    distance_mm(box_of(page.blocks[block]), leader.points.back()));
        for (const SheetStroke& line : page.strokes) {
            if (line.use != StrokeUse::outline ||
                std::ranges::find(part.outlines, line.source) == part.outlines.end())
                continue;
            const auto points = sampled(line, 5.0);
            for (std::size_t k = 0; k + 1 < points.size(); ++k)
                ends.to_line_mm =
                    std::min(ends.to_line_mm,
                             segment_distance_mm(points[k], points[k + 1], leader.points.front()));
        }
    }
    return ends;
}

/// Parts of one picture.
struct NamedCount {
    std::size_t all = 0;
    std::size_t without_a_label = 0;
};

NamedCount expect_names(const TactileMap& map, const TactileSheet& sheet) {
    const PaperPage& page = sheet.pages.front();
    NamedCount count;
    for (const NamedPart& part : named_parts(map)) {
        const auto is_told = [&part](const std::vector<std::string>& names) {
            return std::ranges::find(names, part.name) != names.end();
        };
        const auto block = std::ranges::find(page.blocks, part.name, &BrailleBlock::words);
        ++count.all;
        if (block == page.blocks.end()) {
            ++count.without_a_label;
            EXPECT_TRUE(is_told(sheet.unlabelled) || is_told(sheet.left_out)) << part.name;
        } else if (!part.outlines.empty()) {
            const auto ends =
                leader_ends(page, static_cast<std::size_t>(block - page.blocks.begin()), part);
            EXPECT_NEAR(ends.to_label_mm, least_clear_mm + 0.5, 0.01) << part.name;
            EXPECT_LT(ends.to_line_mm, 0.2) << part.name;
        }
    }
    return count;
}

void expect_frame(const TactileMap& map, const TactileSheet& sheet, const Language& language) {
    const auto has = [&](const std::string& words) {
        return std::ranges::count(sheet.pages.front().blocks, words, &BrailleBlock::words) == 1;
    };
    EXPECT_TRUE(has(map.title));
    EXPECT_TRUE(has(up_words(language)));
    EXPECT_TRUE(has(scale_words(sheet.scale, language)));
    EXPECT_GE(sheet.pages.size(), 2U);  // its description
    EXPECT_GE(sheet.scale, 0.9);
}

void expect_rows_of_braille(const TactileSheet& sheet) {
    for (const PaperPage& page : sheet.pages)
        for (const BrailleBlock& block : page.blocks)
            for (std::size_t i = 1; i < block.rows.size(); ++i)
                EXPECT_NEAR(block.rows[i].first_dot.y_mm - block.rows[i - 1].first_dot.y_mm, 10.0,
                            1e-9);
}

class EverySheet : public testing::TestWithParam<std::pair<const char*, PaperKind>> {};

INSTANTIATE_TEST_SUITE_P(All, EverySheet,
                         testing::Values(std::pair("en", PaperKind::a4),
                                         std::pair("en", PaperKind::letter),
                                         std::pair("de", PaperKind::a4)));

/// One case of all rules, for to lay out the gallery takes far longer than to look at it.
TEST_P(EverySheet, KeepsTheRulesOfPaper) {
    const auto& [code, paper] = GetParam();
    const Language language = Language::load(TOUCHLINE_CATALOGUES, code).value();
    const SheetOrder order{paper, {code, BrailleGrade::uncontracted}};
    NamedCount parts;
    for (const ShippedPicture& picture : shipped_pictures({code})) {
        SCOPED_TRACE(picture.name);
        const TactileSheet sheet = tactile_sheet(picture.map, order, language).value();
        expect_margins(sheet, size_of(paper));
        expect_clear_braille(sheet.pages.front());
        expect_gaps(sheet.pages.front().strokes);
        expect_widths(sheet.pages.front().strokes);
        expect_frame(picture.map, sheet, language);
        expect_rows_of_braille(sheet);
        const NamedCount count = expect_names(picture.map, sheet);
        parts.all += count.all;
        parts.without_a_label += count.without_a_label;
    }
    EXPECT_GT(parts.all, 200U);
    EXPECT_LE(parts.without_a_label, parts.all / 10);
    RecordProperty("parts", static_cast<int>(parts.all));
    RecordProperty("without_a_label", static_cast<int>(parts.without_a_label));
}

}  // namespace
}  // namespace touchline
