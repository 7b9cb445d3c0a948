// What of drawings reaches the hand, and in what time: drawings_bench RESULTS writes drawings.csv
// and drawings_sizes.csv there.
#include "tests/app/drawings/charts.h"
#include "tests/app/drawings/felt.h"
#include "tests/app/drawings/pdf_drawings.h"
#include "tests/app/drawings/pens.h"
#include "tests/app/drawings/scans.h"
#include "tests/app/drawings/svg_drawings.h"
#include "vision/simplify/detail_limits.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/ostream.h>

namespace touchline::bench {
namespace {

constexpr int kSvgSeeds = 8;
constexpr int kChartSeeds = 6;
constexpr int kPdfSeeds = 10;
constexpr int kPenSeeds = 5;

struct Group {
    std::string name;
    std::vector<testing::Drawing> drawings;
};

/// Adds a drawing that could be made.
void add(Group& group, Result<testing::Drawing> drawing) {
    if (drawing) group.drawings.push_back(std::move(*drawing));
}

std::vector<Group> svg_groups() {
    Group dashes{"SVG: dashes and dots", {}};
    Group others{"SVG: all other features", {}};
    for (int feature = 0; feature < testing::svg_feature_count(); ++feature) {
        for (int seed = 0; seed < kSvgSeeds; ++seed) {
            testing::Drawing drawing = testing::svg_drawing(feature, seed);
            (drawing.kind == "dashes and dots" ? dashes : others)
                .drawings.push_back(std::move(drawing));
        }
    }
    return {dashes, others};
}

Group pdf_group() {
    Group pages{"PDF: pages of six figures", {}};
    for (int page = 0; page < kPdfSeeds * testing::pdf_page_count(); ++page)
        pages.drawings.push_back(testing::pdf_page(page));
    return pages;
}

Group chart_group() {
    Group charts{"charts and plans", {}};
    for (int kind = 0; kind < testing::chart_kind_count(); ++kind)
        for (int seed = 0; seed < kChartSeeds; ++seed)
            charts.drawings.push_back(testing::chart_drawing(kind, seed));
    return charts;
}

std::vector<Group> pixel_groups(const Group& charts) {
    Group scans{"scanned charts and plans", {}};
    Group beds{"the same on a scanner's bed", {}};
    Group dashes{"broken lines as pixels", {}};
    Group crossings{"thin and thick strokes that cross", {}};
    int seed = 0;
    for (const testing::Drawing& chart : charts.drawings) {
        add(scans, testing::scanned(chart, seed % kChartSeeds));
        add(beds, testing::scanned_on_bed(chart, seed % testing::bed_kind_count(), seed));
        ++seed;
    }
    for (const testing::Dashing& dashing : testing::dashings())
        for (int i = 0; i < kPenSeeds; ++i)
            add(dashes, testing::as_pixels(testing::dashed_drawing(dashing, i), {}));
    for (int i = 0; i < 2 * kPenSeeds; ++i)
        add(crossings, testing::as_pixels(testing::crossing_strokes(i), {}));
    return {scans, beds, dashes, crossings};
}

struct Measured {
    testing::Counted seen;
    testing::Counted felt;
    int refused = 0;
    std::vector<double> times_ms;

    [[nodiscard]] double median_ms() const {
        std::vector<double> sorted = times_ms;
        std::ranges::sort(sorted);
        return sorted.empty() ? 0.0 : sorted[sorted.size() / 2];
    }
};

Measured measured(const std::vector<testing::Drawing>& drawings, double most_pixels) {
    Measured all;
    for (const testing::Drawing& drawing : drawings) {
        const auto felt =
            testing::felt_of(drawing, kMostDetail, testing::kTolerance_mm, most_pixels);
        if (!felt) {
            ++all.refused;
            continue;
        }
        all.seen += felt->seen;
        all.felt += felt->felt;
        all.times_ms.push_back(felt->milliseconds);
    }
    return all;
}

int run(const std::string& results) {
    const Group charts = chart_group();
    std::vector<Group> all = svg_groups();
    all.push_back(pdf_group());
    all.push_back(charts);
    std::ranges::move(pixel_groups(charts), std::back_inserter(all));
    std::ofstream kinds(results + "/drawings.csv");
    fmt::print(
        kinds,
        "kind,drawings,refused,seen_m,felt_share,too_near_share,too_short_share,seen_share,ms\n");
    for (const Group& group : all) {
        const Measured m = measured(group.drawings, 1e9);
        const double whole_mm =
            m.seen.right_mm + m.seen.wrong_mm + m.seen.too_near_mm + m.seen.too_short_mm;
        fmt::print(kinds, "{},{},{},{:.2f},{:.4f},{:.4f},{:.4f},{:.4f},{:.0f}\n", group.name,
                   group.drawings.size(), m.refused, 1e-3 * whole_mm, m.seen.share(),
                   m.seen.too_near_mm / whole_mm, m.seen.too_short_mm / whole_mm, m.felt.share(),
                   m.median_ms());
    }
    std::ofstream sizes(results + "/drawings_sizes.csv");
    fmt::print(sizes, "megapixels,felt_share,seen_share,ms\n");
    for (const double megapixels : {0.03, 0.06, 0.12, 0.25, 0.5, 1.0}) {
        const Measured m = measured(charts.drawings, 1e6 * megapixels);
        fmt::print(sizes, "{},{:.4f},{:.4f},{:.0f}\n", megapixels, m.seen.share(), m.felt.share(),
                   m.median_ms());
    }
    return kinds && sizes ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: drawings_bench RESULTS\n");
        return 2;
    }
    return touchline::bench::run(argv[1]);
}
