// What is painted on PDF pages is what is felt: figures of many kinds against their own geometry,
// by the way that the kiosk goes. TOUCHLINE_PAGES=N takes N pages instead of a few;
// TOUCHLINE_PAGES_KEPT=FOLDER keeps those whose lines are felt worst.
#include "app/cli/load.h"
#include "app/decode/files.h"
#include "app/decode/map_svg.h"
#include "app/decode/opening.h"
#include "app/trace/page_views.h"
#include "tests/app/trace/line_share.h"
#include "tests/app/trace/page_figures.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

using testing::felt_line;
using testing::FiguresPage;
using testing::length_mm;
using testing::Nearby;
using testing::PagePoint;
using testing::Sample;
using testing::samples_of;
using testing::Share;
using testing::VisibleLine;

constexpr double least_line_mm = 3.0;

std::vector<PagePoint> under_the_hand(const std::vector<PagePoint>& on_page) {
    std::vector<PagePoint> line;
    for (const PagePoint& p : on_page)
        line.push_back({testing::mm_per_pt * p.x, testing::mm_per_pt * p.y});
    return line;
}

struct Score {
    std::map<std::string, Share> seen_is_felt;  // by kind
    std::map<std::string, Share> felt_is_seen;  // likewise, of the cell that it is in
};

const std::string& kind_at(const FiguresPage& page, const PagePoint& p) {
    const int column = std::clamp(static_cast<int>(3.0 * p.x / 116.0), 0, 2);
    const int row = std::clamp(static_cast<int>(2.0 * p.y / 84.0), 0, 1);
    static const std::string none = "none";
    for (const VisibleLine& line : page.lines)
        if (line.figure == 3 * row + column) return line.kind;
    return none;
}

Score score_of(const FiguresPage& page, const TactileMap& map) {
    Nearby felt;
    Nearby seen;
    for (const Outline& outline : map.outlines) felt.add(samples_of(felt_line(outline, map.area)));
    for (const VisibleLine& line : page.lines) seen.add(samples_of(under_the_hand(line.points)));
    Score score;
    for (const VisibleLine& line : page.lines) {
        const auto points = under_the_hand(line.points);
        if (length_mm(points) >= least_line_mm)
            score.seen_is_felt[line.kind].add(samples_of(points), felt);
    }
    for (const Outline& outline : map.outlines)
        for (const Sample& sample : samples_of(felt_line(outline, map.area)))
            score.felt_is_seen[kind_at(page, sample.at)].add({sample}, seen);
    return score;
}

Result<TracedMap> felt_at_detail_5(const std::string& path) {
    const auto page = open_page_of(path);
    if (!page) return tl::unexpected(page.error());
    TraceRequest request;
    request.options.detail = 5;
    return trace_picture(path, request, view_count(*page));
}

double wrong_mm(const std::map<std::string, Share>& shares) {
    double sum = 0.0;
    for (const auto& [kind, share] : shares) sum += share.all_mm - share.part_mm;
    return sum;
}

void keep(const std::string& path, std::uint32_t seed, const TactileMap& map) {
    const char* const folder = std::getenv("TOUCHLINE_PAGES_KEPT");
    if (folder == nullptr) return;
    const std::string name = std::string(folder) + "/page-" + std::to_string(seed);
    std::filesystem::copy_file(path, name + ".pdf",
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_TRUE(write_whole_file(name + ".svg", format_map_svg(map)).has_value());
}

void print(const char* what, const std::map<std::string, Share>& shares) {
    std::printf("%s\n", what);
    for (const auto& [kind, share] : shares)
        std::printf("  %-16s %6.2f %% of %7.0f mm\n", kind.c_str(), 100.0 * share.value(),
                    share.all_mm);
}

/// What the page was taken for: "drawing", "diagram" or "photo".
std::string class_in(const std::string& report) {
    const std::string key = "\"class\": \"";
    const auto at = report.find(key);
    if (at == std::string::npos) return "none";
    const auto from = at + key.size();
    return report.substr(from, report.find('"', from) - from);
}

/// Kinds whose lines are felt as they are drawn, whatever stands beside them on the page. Of the
/// others dashes, dots and hair lines are lost beside areas, strokes beside shaded areas are felt
/// by one side, and ends and near lines are joined.
constexpr std::array sound_kinds{"area with edge", "clipped area", "nonzero star",
                                 "picture",        "polygon",      "ring",
                                 "shaded",         "united discs", "wide ring"};

Share all_of(const std::map<std::string, Share>& shares) {
    Share all;
    for (const auto& [kind, share] : shares) all.add(share);
    return all;
}

TEST(PdfPages, WhatIsPaintedIsFeltAndWhatIsFeltIsPainted) {
    const char* const wanted = std::getenv("TOUCHLINE_PAGES");
    const auto pages = static_cast<std::uint32_t>(wanted != nullptr ? std::atoi(wanted) : 8);
    const std::string path = (std::filesystem::temp_directory_path() /
                              ("touchline-page-" + std::to_string(getpid()) + ".pdf"))
                                 .string();
    Score all;
    for (std::uint32_t seed = 0; seed < pages; ++seed) {
        const FiguresPage page = testing::figures_page(seed);
        ASSERT_TRUE(write_whole_file(path, page.pdf).has_value());
        const auto felt = felt_at_detail_5(path);
        ASSERT_TRUE(felt.has_value()) << felt.error().line;
        const Score score = score_of(page, felt->map);
        for (const auto& [kind, share] : score.seen_is_felt) all.seen_is_felt[kind].add(share);
        for (const auto& [kind, share] : score.felt_is_seen) all.felt_is_seen[kind].add(share);
        const std::string page_class = class_in(felt->report);
        all.seen_is_felt["page: " + page_class].add(all_of(score.seen_is_felt));
        all.felt_is_seen["page: " + page_class].add(all_of(score.felt_is_seen));
        const double wrong = wrong_mm(score.seen_is_felt) + wrong_mm(score.felt_is_seen);
        if (wrong > 3.0) {
            std::printf("page %u: %.1f mm are wrong\n", seed, wrong);
            keep(path, seed, felt->map);
        }
    }
    std::filesystem::remove(path);
    print("what is seen and felt", all.seen_is_felt);
    print("what is felt and seen", all.felt_is_seen);
    for (const char* const kind : sound_kinds) {
        EXPECT_GE(all.seen_is_felt[kind].value(), 0.99) << kind;
        EXPECT_GE(all.felt_is_seen[kind].value(), 0.99) << kind;
    }
    // Each millimetre is counted twice: by its kind, and by its page's class.
    const double felt = all_of(all.seen_is_felt).value();
    const double seen = all_of(all.felt_is_seen).value();
    std::printf("pages %u: %.2f %% of what is seen is felt, %.2f %% of what is felt is seen\n",
                pages, 100.0 * felt, 100.0 * seen);
    EXPECT_GE(felt, 0.85);
    EXPECT_GE(seen, 0.92);
}

}  // namespace
}  // namespace touchline
