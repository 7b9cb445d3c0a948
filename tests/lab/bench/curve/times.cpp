#include "app/cli/load.h"
#include "app/documents/gallery/gallery.h"
#include "tests/lab/bench/curve/coarse_curve.h"
#include "tests/lab/bench/curve/filters.h"
#include "tests/lab/bench/curve/outlines.h"
#include "tests/lab/bench/curve/report.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <numbers>

#include <fmt/core.h>

namespace touchline::bench {
namespace {

constexpr int coarsest = 6;
constexpr int repetitions = 101;
constexpr int runs = 10;  // per repetition, so that the clock's own cost does not count

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Computes the coarse points. Returns how many there are.
std::size_t work(Method method, const Curve& line, const Curve& closed, int level) {
    const std::size_t count = (closed.size() >> static_cast<unsigned>(level)) + 1;
    if (method == Method::douglas_peucker) return douglas_peucker(line, count).size();
    if (method == Method::visvalingam) return visvalingam(line, count).size();
    WaveletLevel coarse = analyze_closed(filter_of(method), closed);
    for (int i = 1; i < level; ++i) coarse = analyze_closed(filter_of(method), coarse.points);
    return coarse.points.size();
}

double time_us(Method method, const Curve& line, int level) {
    Curve closed = line;
    closed.pop_back();
    std::vector<double> times_us;
    std::size_t points = 0;
    for (int i = 0; i < repetitions; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        for (int run = 0; run < runs; ++run) points += work(method, line, closed, level);
        const std::chrono::duration<double, std::micro> spent =
            std::chrono::steady_clock::now() - begin;
        times_us.push_back(spent.count() / runs);
    }
    return points > 0 ? median(std::move(times_us)) : 0.0;
}

using Times = std::map<Method, std::vector<double>>;  // per level, from 1

std::string words(const Times& times, const Table& table) {
    const auto at_32 = [&](Method method) { return times.at(method)[3]; };
    return fmt::format(
        "Median of {} repetitions for the outline of a traced hand, {} points, from the points to "
        "the coarse "
        "curve; "
        "microseconds by the number of points left. A filter gives all levels on the way. 13/7 "
        "takes {:.1f} us to "
        "32 points, {:.1f} times 5/3 and {:.1f} times 9/7; it is the product's own code, which "
        "also handles open "
        "ends and odd counts, the others are short loops for closed curves only. Douglas-Peucker "
        "takes {:.0f} us "
        "and Visvalingam {:.0f} us for that one number of points.\n\n{}",
        repetitions, outline_points, at_32(Method::paper_13_7),
        at_32(Method::paper_13_7) / at_32(Method::cdf_5_3),
        at_32(Method::paper_13_7) / at_32(Method::cdf_9_7), at_32(Method::douglas_peucker),
        at_32(Method::visvalingam), table.markdown());
}

}  // namespace

Result<void> measure_times(const Folders& folders) {
    const auto map = load_map(gallery_folder() + "/15-hand.svg", true);
    if (!map) return tl::unexpected(map.error());
    const Curve curve = closed_outlines(*map).front();
    Times times;
    Table all{{"method", "level", "points", "time_us", "rms_per_mille", "hausdorff_per_mille",
               "slope_deg", "box_half_width_per_mille"},
              {}};
    Table brief{{"method"}, {}};
    for (int level = 1; level <= coarsest; ++level) {
        brief.header.push_back(fmt::format("{}", outline_points >> static_cast<unsigned>(level)));
    }
    for (const Method method : all_methods) {
        brief.rows.push_back({std::string(name_of(method))});
        for (int level = 1; level <= coarsest; ++level) {
            const double spent_us = time_us(method, curve, level);
            const CurveError error = curve_error(curve, coarse_curve(method, curve, level));
            times[method].push_back(spent_us);
            brief.rows.back().push_back(fmt::format("{:.1f}", spent_us));
            all.rows.push_back({std::string(name_of(method)), fmt::format("{}", level),
                                fmt::format("{}", outline_points >> static_cast<unsigned>(level)),
                                fmt::format("{:.2f}", spent_us),
                                fmt::format("{:.4f}", 1e3 * error.rms),
                                fmt::format("{:.4f}", 1e3 * error.hausdorff),
                                fmt::format("{:.3f}", 180.0 / std::numbers::pi * error.slope_rad),
                                fmt::format("{:.4f}", 1e3 * error.box)});
        }
    }
    return write_csv(folders, "curve_times", all).and_then([&] {
        return write_words(folders, "times", words(times, brief));
    });
}

}  // namespace touchline::bench
