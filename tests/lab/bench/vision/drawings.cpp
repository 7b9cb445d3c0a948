// Measures what of drawings reaches the hand, and in what time. drawings_bench RESULTS writes
// drawings.csv and drawings_sizes.csv there; drawings_bench RESULTS PROGRAM writes to
// drawings_before.csv what the maps of another touchline program show of them.
#include "app/documents/decode/map_svg.h"
#include "app/isolation/process/child.h"
#include "tests/app/drawings/charts.h"
#include "tests/app/drawings/felt.h"
#include "tests/app/drawings/pdf_drawings.h"
#include "tests/app/drawings/pens.h"
#include "tests/app/drawings/scans.h"
#include "tests/app/drawings/svg_drawings.h"
#include "vision/simplify/detail_limits.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/ostream.h>
#include <unistd.h>

namespace touchline::bench {
namespace {

constexpr int svg_seeds = 8;
constexpr int chart_seeds = 6;
constexpr int pdf_seeds = 10;
constexpr int pen_seeds = 5;

struct Group {
    std::string name;
    std::vector<testing::Drawing> drawings;
};

/// Adds the drawing if it could be made.
void add(Group& group, Result<testing::Drawing> drawing) {
    if (drawing) group.drawings.push_back(std::move(*drawing));
}

std::vector<Group> svg_groups() {
    Group dashes{"SVG: dashes and dots", {}};
    Group others{"SVG: all other features", {}};
    for (int feature = 0; feature < testing::svg_feature_count(); ++feature) {
        for (int seed = 0; seed < svg_seeds; ++seed) {
            testing::Drawing drawing = testing::svg_drawing(feature, seed);
            (drawing.kind == "dashes and dots" ? dashes : others)
                .drawings.push_back(std::move(drawing));
        }
    }
    return {dashes, others};
}

Group pdf_group() {
    Group pages{"PDF: pages of six figures", {}};
    for (int page = 0; page < pdf_seeds * testing::pdf_page_count(); ++page)
        pages.drawings.push_back(testing::pdf_page(page));
    return pages;
}

Group chart_group() {
    Group charts{"charts and plans", {}};
    for (int kind = 0; kind < testing::chart_kind_count(); ++kind)
        for (int seed = 0; seed < chart_seeds; ++seed)
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
        add(scans, testing::scanned(chart, seed % chart_seeds));
        add(beds, testing::scanned_on_bed(chart, seed % testing::bed_kind_count(), seed));
        ++seed;
    }
    for (const testing::Dashing& dashing : testing::dashings())
        for (int i = 0; i < pen_seeds; ++i)
            add(dashes, testing::as_pixels(testing::dashed_drawing(dashing, i), {}));
    for (int i = 0; i < 2 * pen_seeds; ++i)
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

/// A way from a drawing to what is felt of it.
using Way = std::function<Result<testing::Felt>(const testing::Drawing&)>;

Way way_of_at_most(double most_pixels) {
    return [most_pixels](const testing::Drawing& drawing) {
        return testing::felt_of(drawing, most_detail, testing::usual_tolerance_mm, most_pixels);
    };
}

/// Returns the map that another touchline program makes of the file, with its own workers.
Result<TactileMap> map_by(const std::string& program, const testing::Drawing& drawing) {
    constexpr double kPatience_s = 60.0;
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("touchline-drawing-{}", getpid());
    std::filesystem::create_directories(folder);
    const std::string file = folder / "drawing";
    const std::string map = folder / "map.svg";
    std::ofstream(file, std::ios::binary) << drawing.file;
    auto child = Child::start(
        program, {"trace", file, "-o", map, "--detail", std::to_string(most_detail)}, {},
        StandardStreams::nothing,
        {"TOUCHLINE_PROGRAMS=" + std::filesystem::path(program).parent_path().string()});
    if (!child) return tl::unexpected(child.error());
    if (!child->ends_within(kPatience_s)) child->kill();
    auto read = child->reap().is_good() ? read_map_svg(map) : failure("it made no map");
    std::filesystem::remove_all(folder);
    return read;
}

Way way_of_program(const std::string& program) {
    return [program](const testing::Drawing& drawing) -> Result<testing::Felt> {
        const auto begin = std::chrono::steady_clock::now();
        auto map = map_by(program, drawing);
        const std::chrono::duration<double, std::milli> took =
            std::chrono::steady_clock::now() - begin;
        if (!map) return tl::unexpected(map.error());
        testing::Felt felt =
            testing::felt_by(std::move(*map), drawing, most_detail, testing::usual_tolerance_mm);
        felt.milliseconds = took.count();
        return felt;
    };
}

Measured measured(const std::vector<testing::Drawing>& drawings, const Way& way) {
    Measured all;
    for (const testing::Drawing& drawing : drawings) {
        const auto felt = way(drawing);
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

bool write_kinds(const std::string& path, const Group& charts, const Way& way) {
    std::vector<Group> all = svg_groups();
    all.push_back(pdf_group());
    all.push_back(charts);
    std::ranges::move(pixel_groups(charts), std::back_inserter(all));
    std::ofstream kinds(path);
    fmt::print(
        kinds,
        "kind,drawings,refused,seen_m,felt_share,too_near_share,too_short_share,seen_share,ms\n");
    for (const Group& group : all) {
        const Measured m = measured(group.drawings, way);
        const double whole_mm =
            m.seen.right_mm + m.seen.wrong_mm + m.seen.too_near_mm + m.seen.too_short_mm;
        fmt::print(kinds, "{},{},{},{:.2f},{:.4f},{:.4f},{:.4f},{:.4f},{:.0f}\n", group.name,
                   group.drawings.size(), m.refused, 1e-3 * whole_mm, m.seen.share(),
                   m.seen.too_near_mm / whole_mm, m.seen.too_short_mm / whole_mm, m.felt.share(),
                   m.median_ms());
    }
    return kinds.good();
}

bool write_sizes(const std::string& path, const Group& charts) {
    std::ofstream sizes(path);
    fmt::print(sizes, "megapixels,felt_share,seen_share,ms\n");
    for (const double megapixels : {0.03, 0.06, 0.12, 0.25, 0.5, 1.0}) {
        const Measured m = measured(charts.drawings, way_of_at_most(1e6 * megapixels));
        fmt::print(sizes, "{},{:.4f},{:.4f},{:.0f}\n", megapixels, m.seen.share(), m.felt.share(),
                   m.median_ms());
    }
    return sizes.good();
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    using namespace touchline::bench;
    if (argc != 2 && argc != 3) {
        fmt::print(stderr, "usage: drawings_bench RESULTS [PROGRAM]\n");
        return 2;
    }
    const std::string results = argv[1];
    const Group charts = chart_group();
    const bool is_written =
        argc == 3 ? write_kinds(results + "/drawings_before.csv", charts, way_of_program(argv[2]))
                  : write_kinds(results + "/drawings.csv", charts, way_of_at_most(1e9)) &&
                        write_sizes(results + "/drawings_sizes.csv", charts);
    return is_written ? EXIT_SUCCESS : EXIT_FAILURE;
}
