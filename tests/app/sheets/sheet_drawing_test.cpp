// The sheets as a printer would print them: widths, gaps and braille, from the ink alone.
#include "app/sheets/sheet_drawing.h"

#include "app/sheets/page_frame.h"
#include "app/sheets/sheet_layout.h"
#include "app/sheets/stroke_grid.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/app/sheets/rendered_page.h"
#include "tests/app/sheets/sheet_maps.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr double dpi = 300.0;
constexpr double pixel_mm = 25.4 / dpi;

struct PrintedSheet {
    TactileSheet sheet;
    std::vector<std::byte> pdf;
};

PrintedSheet printed(const TactileMap& map, const std::string& code = "en",
                     BrailleGrade grade = BrailleGrade::uncontracted,
                     PaperKind paper = PaperKind::a4) {
    const Language language = Language::load(TOUCHLINE_CATALOGUES, code).value();
    TactileSheet sheet = tactile_sheet(map, {paper, {code, grade}}, language).value();
    auto pdf = pdf_of(sheet, map.title).value();
    return {std::move(sheet), std::move(pdf)};
}

std::string small(const std::string& text) {
    std::string made;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.compare(i, 3, "’") == 0) {
            made += '\'';
            i += 2;
        } else if (static_cast<unsigned char>(text[i]) == 0xc3 && i + 1 < text.size() &&
                   static_cast<unsigned char>(text[i + 1]) >= 0x80 &&
                   static_cast<unsigned char>(text[i + 1]) <= 0x9e) {
            made += text[i];
            made += static_cast<char>(text[++i] + 0x20);  // À ... Þ to à ... þ
        } else {
            made += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
        }
    }
    return made;
}

/// Everything in braille on the first page, read from its ink.
void expect_words(const PrintedSheet& one, const std::string& table, bool has_capitals) {
    const std::vector<PaperPoint> dots = dots_on(rendered(one.pdf, 0, dpi));
    std::vector<int> used(dots.size(), 0);
    for (const BrailleBlock& block : one.sheet.pages[0].blocks) {
        std::vector<std::uint8_t> cells;
        for (const BrailleRow& row : block.rows) {
            if (!cells.empty()) cells.push_back(0);
            const auto read = read_row(dots, row.first_dot, row.cells.size(), used);
            EXPECT_EQ(read, row.cells) << block.words;
            cells.insert(cells.end(), read.begin(), read.end());
        }
        const std::string words = back_translated(cells, table);
        if (has_capitals) {
            std::string straight = block.words;
            for (auto at = straight.find("’"); at != std::string::npos; at = straight.find("’"))
                straight.replace(at, 3, "'");
            std::string read = words;
            for (auto at = read.find("’"); at != std::string::npos; at = read.find("’"))
                read.replace(at, 3, "'");
            EXPECT_EQ(read, straight);
        } else {
            EXPECT_EQ(small(words), small(block.words));
        }
    }
    // No dot that is not a part of a cell, and none of two.
    for (std::size_t i = 0; i < dots.size(); ++i)
        EXPECT_EQ(used[i], 1) << dots[i].x_mm << ", " << dots[i].y_mm;
}

std::vector<ShippedPicture> some_pictures(const std::string& code) {
    std::vector<ShippedPicture> chosen;
    for (ShippedPicture& picture : shipped_pictures({code}))
        if (picture.name.find("fish") != std::string::npos ||
            picture.name.find("house") != std::string::npos ||
            picture.name.find("leaf") != std::string::npos ||
            picture.name.find("flat") != std::string::npos)
            chosen.push_back(std::move(picture));
    return chosen;
}

TEST(PrintedSheet, BrailleReadBackIsTheWords) {
    ASSERT_EQ(some_pictures("en").size(), 4U);
    for (const ShippedPicture& picture : some_pictures("en"))
        expect_words(printed(picture.map), "en-ueb-g1.ctb", true);
}

TEST(PrintedSheet, ContractedBrailleReadBackIsTheWords) {
    for (const ShippedPicture& picture : some_pictures("en"))
        expect_words(printed(picture.map, "en", BrailleGrade::contracted), "en-ueb-g2.ctb", true);
}

TEST(PrintedSheet, GermanReadBackIsTheWords) {
    for (const ShippedPicture& picture : some_pictures("de"))
        expect_words(printed(picture.map, "de"), "de-g0.utb", false);
}

TEST(PrintedSheet, LinesAreAsWideInInk) {
    const PrintedSheet one = printed(some_pictures("en")[0].map);
    const InkPage page = rendered(one.pdf, 0, dpi);
    cv::Mat1f depth;
    cv::distanceTransform(page.ink, depth, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    const auto& strokes = one.sheet.pages[0].strokes;
    int measured = 0;
    for (const SheetStroke& stroke : strokes) {
        if (stroke.points.size() == 1) continue;
        StrokeGrid others(one.sheet.pages[0].size, 9.0);
        for (const SheetStroke& other : strokes)
            if (&other != &stroke) others.add(other);
        const auto points = sampled(stroke, 1.0);
        for (std::size_t i = 3; i + 3 < points.size(); i += 3) {
            if (others.near(points[i]).clear_mm < 2.0) continue;
            // A corner is wider than its line.
            const double way_mm =
                distance_mm(points[i - 3], points[i]) + distance_mm(points[i], points[i + 3]);
            if (distance_mm(points[i - 3], points[i + 3]) < 0.99 * way_mm) continue;
            // The deepest pixel around: half the width, and half a pixel for the pixel's own size.
            const cv::Point at = page.pixel(points[i]);
            double deepest = 0.0;
            cv::minMaxLoc(depth(cv::Rect(at - cv::Point(2, 2), at + cv::Point(3, 3))), nullptr,
                          &deepest);
            const double width_mm = (2.0 * deepest - 1.0) * pixel_mm;
            EXPECT_NEAR(width_mm, stroke.width_mm, 2.0 * pixel_mm);
            EXPECT_GE(width_mm, 1.0 - 2.0 * pixel_mm);
            EXPECT_LE(width_mm, 1.5 + 2.0 * pixel_mm);
            ++measured;
        }
    }
    EXPECT_GT(measured, 150);
}

TEST(PrintedSheet, GapsInInkAreThreeMillimetres) {
    for (const char* code : {"en", "de"})
        for (const ShippedPicture& picture : some_pictures(code)) {
            const PrintedSheet one = printed(picture.map, code);
            InkPage page = rendered(one.pdf, 0, dpi);
            EXPECT_LT(least_gap_mm(page), 1.5);  // dots of one cell
            // Each label is one piece; its dots are nearer to each other.
            for (const BrailleBlock& block : one.sheet.pages[0].blocks)
                cv::rectangle(page.ink, page.pixels(box_of(block)), 255, cv::FILLED);
            EXPECT_GE(least_gap_mm(page), 3.0 - 2.5 * pixel_mm) << picture.name;
        }
}

TEST(PrintedSheet, NothingIsInTheMargins) {
    for (const ShippedPicture& picture : some_pictures("en")) {
        const PrintedSheet one = printed(picture.map);
        EXPECT_EQ(page_count(one.pdf), static_cast<int>(one.sheet.pages.size()));
        for (int i = 0; i < page_count(one.pdf); ++i) {
            const InkPage page = rendered(one.pdf, i, 100.0);
            const PaperSize size = one.sheet.pages[0].size;
            cv::Mat1b rest = page.ink.clone();
            rest(page.pixels(grown(printable(size), 0.3))) = 0;
            EXPECT_EQ(cv::countNonZero(rest), 0) << picture.name << ", page " << i;
            EXPECT_GT(cv::countNonZero(page.ink), 1000);
        }
    }
}

TEST(PrintedSheet, IsTrueToSize) {
    const TactileMap map = some_pictures("en")[0].map;
    const PaperSize a4 = page_size(printed(map).pdf);
    EXPECT_NEAR(std::max(a4.width_mm, a4.height_mm), 297.0, 0.05);
    EXPECT_NEAR(std::min(a4.width_mm, a4.height_mm), 210.0, 0.05);
    const PrintedSheet letter = printed(map, "en", BrailleGrade::uncontracted, PaperKind::letter);
    EXPECT_NEAR(std::max(page_size(letter.pdf).width_mm, page_size(letter.pdf).height_mm), 279.4,
                0.05);
    // The bar is 20 mm long from middle to middle of its ends.
    const PrintedSheet one = printed(map);
    EXPECT_TRUE(std::ranges::any_of(one.sheet.pages[0].strokes, [](const SheetStroke& stroke) {
        return stroke.use == StrokeUse::furniture && std::abs(length_mm(stroke) - 20.0) < 1e-9;
    }));
}

TEST(PrintedSheet, TitlesMayBeAnything) {
    TactileMap map = map_of_lines({line_through({{-40, 0}, {40, 0}})});
    for (const std::string title : {"<&\"'>", "\xff\xfe", "(\\)", "Ελληνικά", ""}) {
        map.title = title;
        const PrintedSheet one = printed(map);
        EXPECT_GE(page_count(one.pdf), 1);
        EXPECT_TRUE(svg_of(one.sheet.pages[0]).has_value());
    }
}

TEST(PrintedSheet, SvgIsThePageInMillimetres) {
    const PrintedSheet one = printed(some_pictures("en")[0].map);
    const auto bytes = svg_of(one.sheet.pages[0]).value();
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    EXPECT_NE(text.find("<svg"), std::string::npos);
    EXPECT_NE(text.find("297mm"), std::string::npos);
    // A style, or since cairo 1.18 an attribute.
    const auto as_style = text.find("stroke-width:1.5;");
    const auto as_attribute = text.find("stroke-width=\"1.5\"");
    EXPECT_NE(std::min(as_style, as_attribute), std::string::npos);
}

TEST(PrintedSheet, TellsNoDateAndNoName) {
    const PrintedSheet one = printed(some_pictures("en")[0].map);
    const std::string text(reinterpret_cast<const char*>(one.pdf.data()), one.pdf.size());
    EXPECT_EQ(text.find("/CreationDate (D:20"), std::string::npos);
    EXPECT_EQ(text.find("/Author"), std::string::npos);
}

}  // namespace
}  // namespace touchline
