#include "tests/lab/bench/curve/coarse_curve.h"
#include "tests/lab/bench/curve/outlines.h"
#include "tests/lab/bench/curve/report.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/core.h>

namespace touchline::bench {
namespace {

constexpr std::array noises_m{1e-4, 2e-4, 3e-4};
constexpr int coarsest = 6;
constexpr int denoised_levels = 6;  // all of them, as in the product
constexpr unsigned seeds = 8;
constexpr double degrees = 180.0 / std::numbers::pi;

/// A level of a method, or, as level -1, the whole curve with its details shrunk.
struct Way {
    Method method = Method::paper_13_7;
    int level = 0;

    friend auto operator<=>(const Way&, const Way&) = default;
};

std::vector<Way> all_ways() {
    std::vector<Way> ways;
    for (const Method method : all_methods) {
        for (int level = 0; level <= coarsest; ++level) ways.push_back({method, level});
        if (is_filter(method) && method != Method::subsample) ways.push_back({method, -1});
    }
    return ways;
}

CoarseCurve taken(const Way& way, const Curve& noisy, double sigma_m) {
    if (way.level >= 0) return coarse_curve(way.method, noisy, way.level);
    CoarseCurve curve = coarse_curve(way.method, noisy, 0);
    curve.points.pop_back();
    curve.points = denoised(filter_of(way.method), curve.points, sigma_m, denoised_levels);
    curve.points.push_back(curve.points.front());
    return curve;
}

struct Sums {
    std::map<Way, CurveError> mean;  // distances in mm
};

Sums errors_at(double sigma_m) {
    const auto clean = smooth_outlines();
    const double share = 1.0 / static_cast<double>(clean.size() * seeds);
    Sums sums;
    for (const Curve& curve : clean) {
        const double mm = 1e3 * diagonal_m(curve);
        for (unsigned seed = 1; seed <= seeds; ++seed) {
            const Curve noisy = with_noise(curve, sigma_m, seed);
            for (const Way& way : all_ways()) {
                const CurveError error = curve_error(curve, taken(way, noisy, sigma_m));
                CurveError& mean = sums.mean[way];
                mean.rms += share * mm * error.rms;
                mean.hausdorff += share * mm * error.hausdorff;
                mean.slope_rad += share * error.slope_rad;
            }
        }
    }
    return sums;
}

std::string points_in_words(const Way& way) {
    if (way.level < 0) return "denoised";
    return fmt::format("{}", outline_points >> static_cast<unsigned>(way.level));
}

/// Returns the level of a method that is nearest to the outline without noise.
Way nearest_level(const Sums& sums, Method method) {
    Way best{method, 0};
    for (int level = 1; level <= coarsest; ++level) {
        const Way way{method, level};
        if (sums.mean.at(way).rms < sums.mean.at(best).rms) best = way;
    }
    return best;
}

/// Lists for each method its best level and the denoised curve.
Table summary(const std::map<double, Sums>& by_noise) {
    Table table{{"method"}, {}};
    for (const double sigma_m : noises_m) {
        table.header.push_back(fmt::format("best level, {:.1f} mm", 1e3 * sigma_m));
        table.header.push_back(fmt::format("denoised, {:.1f} mm", 1e3 * sigma_m));
    }
    for (const Method method : all_methods) {
        std::vector<std::string> row{std::string(name_of(method))};
        for (const auto& [sigma_m, sums] : by_noise) {
            const Way best = nearest_level(sums, method);
            row.push_back(
                fmt::format("{:.0f} ({})", 1e3 * sums.mean.at(best).rms, points_in_words(best)));
            const auto whole = sums.mean.find({method, -1});
            row.push_back(
                whole == sums.mean.end() ? "-" : fmt::format("{:.0f}", 1e3 * whole->second.rms));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string verdict(double sigma_m, const Sums& sums) {
    Method best = Method::paper_13_7;
    Method best_denoised = Method::paper_13_7;
    for (const Method method : all_methods) {
        if (sums.mean.at(nearest_level(sums, method)).rms <
            sums.mean.at(nearest_level(sums, best)).rms) {
            best = method;
        }
        const auto whole = sums.mean.find({method, -1});
        if (whole != sums.mean.end() && whole->second.rms < sums.mean.at({best_denoised, -1}).rms) {
            best_denoised = method;
        }
    }
    const Way ours = nearest_level(sums, Method::paper_13_7);
    const CurveError& raw = sums.mean.at({Method::paper_13_7, 0});
    const CurveError& level_1 = sums.mean.at({Method::paper_13_7, 1});
    const CurveError& shrunk = sums.mean.at({Method::paper_13_7, -1});
    return fmt::format(
        "Noise of {:.1f} mm: the noisy curve is {:.0f} um RMS and {:.1f} degrees of slope off, its "
        "level 1 with "
        "13/7 {:.0f} um and {:.1f} degrees; 13/7 is "
        "nearest with {} points ({:.0f} um, {:.1f} degrees); denoised it is {:.0f} um and {:.1f} "
        "degrees off. "
        "Of the levels of all methods {} is nearest ({:.0f} um), of the denoised curves {} ({:.0f} "
        "um).",
        1e3 * sigma_m, 1e3 * raw.rms, degrees * raw.slope_rad, 1e3 * level_1.rms,
        degrees * level_1.slope_rad, points_in_words(ours), 1e3 * sums.mean.at(ours).rms,
        degrees * sums.mean.at(ours).slope_rad, 1e3 * shrunk.rms, degrees * shrunk.slope_rad,
        name_of(best), 1e3 * sums.mean.at(nearest_level(sums, best)).rms, name_of(best_denoised),
        1e3 * sums.mean.at({best_denoised, -1}).rms);
}

}  // namespace

Result<void> measure_noise(const Folders& folders) {
    Table all{{"noise_mm", "method", "level", "points", "rms_mm", "hausdorff_mm", "slope_deg"}, {}};
    std::map<double, Sums> by_noise;
    std::string verdicts;
    for (const double sigma_m : noises_m) {
        const Sums sums = errors_at(sigma_m);
        for (const auto& [way, error] : sums.mean) {
            all.rows.push_back(
                {fmt::format("{:.1f}", 1e3 * sigma_m), std::string(name_of(way.method)),
                 way.level < 0 ? "denoised" : fmt::format("{}", way.level),
                 way.level < 0 ? fmt::format("{}", outline_points) : points_in_words(way),
                 fmt::format("{:.5f}", error.rms), fmt::format("{:.5f}", error.hausdorff),
                 fmt::format("{:.3f}", degrees * error.slope_rad)});
        }
        verdicts += verdict(sigma_m, sums) + "\n";
        by_noise.emplace(sigma_m, sums);
    }
    const std::string text = fmt::format(
        "{} smooth outlines that are known exactly, each with {} lots of Gaussian noise on both "
        "coordinates of "
        "{} points. RMS distance in um of the outline without noise from the best level (its "
        "points in brackets) "
        "and from the whole curve with its details shrunk over {} levels as the product "
        "does.\n\n{}\n{}",
        smooth_outlines().size(), seeds, outline_points, denoised_levels,
        summary(by_noise).markdown(), verdicts);
    return write_csv(folders, "curve_noise", all).and_then([&] {
        return write_words(folders, "noise", text);
    });
}

}  // namespace touchline::bench
