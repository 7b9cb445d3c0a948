// What of drawings reaches the hand, and in what time: drawings_bench RESULTS writes drawings.csv
// and drawings_sizes.csv there.
#include "tests/app/drawings/charts.h"
#include "tests/app/drawings/felt.h"
#include "tests/app/drawings/scans.h"
#include "tests/app/drawings/svg_drawings.h"
#include "vision/simplify/detail_limits.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/ostream.h>

namespace touchline::bench {
namespace {

constexpr int kSvgSeeds = 8;
constexpr int kChartSeeds = 6;

struct Group {
    std::string name;
    std::vector<testing::Drawing> drawings;
};

std::vector<Group> groups() {
    Group dashes{"SVG: dashes and dots", {}};
    Group others{"SVG: all other features", {}};
    for (int feature = 0; feature < testing::svg_feature_count(); ++feature) {
        for (int seed = 0; seed < kSvgSeeds; ++seed) {
            testing::Drawing drawing = testing::svg_drawing(feature, seed);
            (drawing.kind == "dashes and dots" ? dashes : others)
                .drawings.push_back(std::move(drawing));
        }
    }
    Group charts{"charts and plans", {}};
    Group scans{"the same scanned", {}};
    for (int kind = 0; kind < testing::chart_kind_count(); ++kind) {
        for (int seed = 0; seed < kChartSeeds; ++seed) {
            charts.drawings.push_back(testing::chart_drawing(kind, seed));
            if (auto scan = testing::scanned(charts.drawings.back(), seed)) {
                scans.drawings.push_back(std::move(*scan));
            }
        }
    }
    return {dashes, others, charts, scans};
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
    const std::vector<Group> all = groups();
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
        const Measured m = measured(all[2].drawings, 1e6 * megapixels);
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
