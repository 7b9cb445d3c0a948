// Tests that words on a PDF's drawing, visible or not, take none of its lines away.
#include "tests/app/documents/decode/pdf_writer.h"
#include "tests/app/drawings/felt.h"
#include "vision/simplify/detail_limits.h"

#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double pt_per_mm = 5.0;  // on a page of 580 x 420

/// A house with a door, a window and a path, in points from the lower left corner.
const std::vector<std::vector<cv::Point2d>>& house() {
    static const std::vector<std::vector<cv::Point2d>> lines{
        {{120, 80}, {460, 80}, {460, 250}, {120, 250}, {120, 80}},
        {{120, 250}, {290, 380}, {460, 250}},
        {{260, 80}, {260, 180}, {320, 180}, {320, 80}},
        {{160, 150}, {220, 150}, {220, 210}, {160, 210}, {160, 150}},
        {{360, 120}, {430, 200}},
        {{40, 40}, {540, 40}}};
    return lines;
}

constexpr double pen_pt = 2.5;

std::string drawn() {
    std::string content = fmt::format("0 G {} w ", pen_pt);
    for (const auto& line : house()) {
        for (std::size_t i = 0; i < line.size(); ++i)
            content += fmt::format("{} {} {} ", line[i].x, line[i].y, i == 0 ? "m" : "l");
        content += "S ";
    }
    return content;
}

std::vector<testing::Paint> painted_house() {
    std::vector<testing::Paint> paints;
    for (const auto& line : house()) {
        testing::Polyline on_sheet;
        for (const cv::Point2d& p : line)
            on_sheet.points.emplace_back(p.x / pt_per_mm,
                                         testing::sheet_mm.height - p.y / pt_per_mm);
        paints.push_back({{on_sheet}, pen_pt / pt_per_mm});
    }
    return paints;
}

struct Found {
    double house = 0.0;  // share of its lines that are felt
    double others_mm = 0.0;
    std::vector<std::string> told;
};

Found found_with(const std::string& before, const std::string& after) {
    testing::Drawing drawing{"", "", "", painted_house()};
    for (const std::byte byte :
         written_pdf({{before + " " + drawn() + after, "/MediaBox [0 0 580 420]",
                       "/Font << /F 4 0 R /D 5 0 R /W 6 0 R >> /ExtGState << /G << /ca 0.3 >> >>"}},
                     {"<< /Type /Font /Subtype /Type1 /BaseFont /ZapfDingbats >>",
                      "<< /Type /Font /Subtype /TrueType /BaseFont /Wingdings >>"}))
        drawing.file.push_back(static_cast<char>(byte));
    const auto felt = testing::felt_of(drawing, most_detail, testing::usual_tolerance_mm);
    EXPECT_TRUE(felt.has_value()) << felt.error().line;
    if (!felt) return {};
    Found found{felt->seen.share(), felt->felt.wrong_mm + felt->felt.too_near_mm, {}};
    for (const Label& label : felt->map.labels) found.told.push_back(label.text);
    return found;
}

using Texts = std::vector<std::string>;

struct Case {
    std::string name;
    std::string before;
    std::string after;
    Texts told;
};

std::string text(const std::string& how, double x, double y, const std::string& words) {
    return fmt::format("BT {} {} {} Td ({}) Tj ET ", how, x, y, words);
}

std::string slanted(double size, double x, double y, const std::string& words) {
    return fmt::format("BT /F {} Tf 0.819 0.574 -0.574 0.819 {} {} Tm ({}) Tj ET ", size, x, y,
                       words);
}

std::vector<Case> cases() {
    std::string letters = "0.82 g ";
    for (int i = 0; i < 6; ++i)
        letters += slanted(80, 130 + 55 * i, 60 + 38 * i, std::string(1, "SAMPLE"[i]));
    std::string many = "0.85 g ";
    for (int i = 0; i < 12; ++i)
        many += slanted(30, 20 + 150 * (i % 4), 30 + 140 * (i / 4), "Proof");
    return {{"nothing", "", "", {}},
            {"read by a program, wrongly",
             "",
             "3 Tr " + text("/F 60 Tf", 130, 240, "Il o L") + text("/F 20 Tf", 150, 150, "window") +
                 text("/F 300 Tf", 100, 90, "AV"),
             {}},
            {"invisible names of layers",
             "",
             "3 Tr " + text("/F 12 Tf", 120, 246, "A-WALL-EXTERIOR LINE 0.25") +
                 text("/F 8 Tf", 360, 150, "A-STAIR") + text("/F 12 Tf", 40, 36, "BOUNDARY LINE"),
             {}},
            {"white words before", "1 g " + text("/F 60 Tf", 130, 200, "Harbour"), "", {}},
            {"clipped words",
             "",
             "q 0 0 5 5 re W n " + text("/F 60 Tf", 130, 200, "Harbour") + "Q",
             {}},
            {"one watermark over it", "", "/G gs " + slanted(110, 150, 60, "SAMPLE"), {"SAMPLE"}},
            {"one watermark under it", "0.8 g " + slanted(110, 150, 60, "SAMPLE"), "", {"SAMPLE"}},
            {"a watermark along the page",
             "0.85 g " + text("/F 110 Tf", 90, 150, "SAMPLE"),
             "",
             {"SAMPLE"}},
            {"a watermark of letters", letters, "", {"SAMPLE"}},
            {"a red watermark", "1 0.7 0.7 rg " + slanted(110, 150, 60, "SAMPLE"), "", {"SAMPLE"}},
            {"watermarks everywhere", many, "", {"Proof"}},
            {"measures beside lines",
             "",
             text("/F 12 Tf", 270, 255, "8.40 m") + text("/F 12 Tf", 465, 160, "5.20 m"),
             {"8.40 m", "5.20 m"}},
            {"a name across a line", "", text("/F 24 Tf", 200, 241, "Great hall"), {"Great hall"}}};
}

TEST(PdfWordsOverLines, TakeNoLineAway) {
    for (const Case& one : cases()) {
        const Found felt = found_with(one.before, one.after);
        std::printf("%-28s %.1f %% of the house, %.1f mm of others\n", one.name.c_str(),
                    100.0 * felt.house, felt.others_mm);
        EXPECT_GE(felt.house, 0.97) << one.name;
        EXPECT_EQ(felt.told, one.told) << one.name;
        EXPECT_LE(felt.others_mm, one.name == "a name across a line" ? 60.0 : 12.0) << one.name;
    }
}

TEST(PdfWordsOverLines, SignsThatDrawAreFelt) {
    // A black square and a heavy cross of Dingbats, 100 points large.
    const Found felt =
        found_with("", text("/D 100 Tf", 470, 260, "n") + text("/D 100 Tf", 20, 260, "n"));
    EXPECT_GE(felt.house, 0.97);
    EXPECT_EQ(felt.told, Texts{});
    EXPECT_GE(felt.others_mm, 2 * 4 * 12.0) << "their borders";
}

}  // namespace
}  // namespace touchline
