#include "tests/lab/bench/curve/coarse_curve.h"
#include "tests/lab/bench/curve/outlines.h"
#include "tests/lab/bench/curve/report.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numbers>

#include <fmt/core.h>

namespace touchline::bench {
namespace {

constexpr double per_mille = 1e3;
constexpr double degrees = 180.0 / std::numbers::pi;
constexpr double noise_m = 2e-4;

/// Curves of the same number of segments.
struct Set {
    std::string name;
    std::string what;
    std::vector<Curve> curves;
    int coarsest = 6;
    bool has_haar = true;
    bool has_table = true;  // in the words; the CSV has everything

    [[nodiscard]] std::size_t segments(int level) const {
        return (curves.front().size() - 1) >> static_cast<unsigned>(level);
    }

    [[nodiscard]] bool has(Method method) const { return has_haar || method != Method::haar; }
};

/// The result over all curves of a set, at one level.
struct LevelResult {
    std::map<Method, CurveError> mean;
    int tightest = 0;  // curves on which 13/7 has the tightest boxes of the filters
};

void add(CurveError& mean, const CurveError& error, double share) {
    mean.rms += share * error.rms;
    mean.hausdorff += share * error.hausdorff;
    mean.slope_rad += share * error.slope_rad;
    mean.box += share * error.box;
}

LevelResult result_at(const Set& set, int level) {
    LevelResult result;
    for (const Curve& curve : set.curves) {
        double ours = 0.0;
        double others = std::numeric_limits<double>::infinity();
        for (const Method method : all_methods) {
            if (!set.has(method)) continue;
            const CurveError error = curve_error(curve, coarse_curve(method, curve, level));
            add(result.mean[method], error, 1.0 / static_cast<double>(set.curves.size()));
            if (method == Method::paper_13_7) {
                ours = error.box;
            } else if (is_filter(method)) {
                others = std::min(others, error.box);
            }
        }
        result.tightest += ours < others ? 1 : 0;
    }
    return result;
}

std::vector<std::string> cells(const CurveError& error) {
    return {fmt::format("{:.3f}", per_mille * error.rms),
            fmt::format("{:.3f}", per_mille * error.hausdorff),
            fmt::format("{:.2f}", degrees * error.slope_rad),
            fmt::format("{:.3f}", per_mille * error.box)};
}

/// Returns the method with the tightest boxes of the filters, or of all methods.
Method tightest(const LevelResult& result, bool is_filters_only) {
    Method best = Method::paper_13_7;
    for (const auto& [method, error] : result.mean) {
        if (is_filters_only && !is_filter(method)) continue;
        if (error.box < result.mean.at(best).box) best = method;
    }
    return best;
}

/// Returns the numbers of segments with which 13/7 has the tighter boxes; "all" or "none" if it is
/// so.
std::string tighter_in_words(const Set& set, const std::vector<LevelResult>& levels, Method other) {
    std::vector<std::string> tighter;
    for (int level = 1; level <= set.coarsest; ++level) {
        const auto& mean = levels[static_cast<std::size_t>(level - 1)].mean;
        if (mean.at(Method::paper_13_7).box < mean.at(other).box) {
            tighter.push_back(fmt::format("{}", set.segments(level)));
        }
    }
    if (tighter.empty()) return "none";
    return tighter.size() == levels.size() ? "all" : list_in_words(tighter);
}

/// Says whether 13/7 has the tightest boxes of the filters, as claimed, and where it does not.
std::string claim_in_words(const Set& set, const std::vector<LevelResult>& levels) {
    std::vector<std::string> against;
    bool holds = true;
    for (const Method other : all_methods) {
        if (other == Method::paper_13_7 || !is_filter(other) || !set.has(other)) continue;
        const std::string where = tighter_in_words(set, levels, other);
        holds = holds && where == "all";
        against.push_back(fmt::format("{}: {}", name_of(other), where));
    }
    int wins = 0;
    for (const LevelResult& result : levels) wins += result.tightest;
    return fmt::format(
        "Are 13/7's boxes the tightest of the wavelets and subsampling? {}. Numbers of segments, "
        "of those from {} down "
        "to {}, with which its mean half-width is less than that of {}. It is the tightest of them "
        "on {} of {} single "
        "curves and levels.",
        holds ? "Yes" : "Not everywhere", set.segments(1), set.segments(set.coarsest),
        list_in_words(against), wins, set.curves.size() * levels.size());
}

std::string simplifiers_in_words(const Set& set, const LevelResult& result, int level) {
    const Method best = tightest(result, false);
    if (is_filter(best)) return fmt::format("{} beats both simplifiers.", name_of(best));
    const CurveError& ours = result.mean.at(Method::paper_13_7);
    const CurveError& theirs = result.mean.at(best);
    return fmt::format(
        "With {} segments the tightest of all is {}: boxes {:.3f} against {:.3f} per mille, slope "
        "{:.1f} against "
        "{:.1f} degrees. It puts its points where the curve bends and has no levels of equal "
        "parts.",
        set.segments(level), name_of(best), per_mille * theirs.box, per_mille * ours.box,
        degrees * theirs.slope_rad, degrees * ours.slope_rad);
}

constexpr std::array summary_levels{2, 4};

Table summary(const Set& set, const std::vector<LevelResult>& levels) {
    Table table{{"method"}, {}};
    for (const int level : summary_levels) {
        for (const char* measure : {"RMS", "Hausdorff", "slope", "box"}) {
            table.header.push_back(fmt::format("{} {}", measure, set.segments(level)));
        }
    }
    for (const Method method : all_methods) {
        if (!set.has(method)) continue;
        std::vector<std::string> row{std::string(name_of(method))};
        for (const int level : summary_levels) {
            const auto numbers = cells(levels[static_cast<std::size_t>(level - 1)].mean.at(method));
            row.insert(row.end(), numbers.begin(), numbers.end());
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Result<void> measure(const Folders& folders, const Set& set) {
    Table all{{"method", "level", "segments", "rms_per_mille", "hausdorff_per_mille", "slope_deg",
               "box_half_width_per_mille"},
              {}};
    std::vector<LevelResult> levels;
    for (int level = 1; level <= set.coarsest; ++level) levels.push_back(result_at(set, level));
    for (const Method method : all_methods) {
        if (!set.has(method)) continue;
        for (int level = 1; level <= set.coarsest; ++level) {
            std::vector<std::string> row{std::string(name_of(method)), fmt::format("{}", level),
                                         fmt::format("{}", set.segments(level))};
            const auto numbers = cells(levels[static_cast<std::size_t>(level - 1)].mean.at(method));
            row.insert(row.end(), numbers.begin(), numbers.end());
            all.rows.push_back(std::move(row));
        }
    }
    const int brief = summary_levels.back();
    const std::string text = fmt::format(
        "{} {}; {} segments each. {}{} {}\n", set.curves.size(), set.what, set.segments(0),
        set.has_table ? "\n\n" + summary(set, levels).markdown() + "\n" : "",
        claim_in_words(set, levels),
        simplifiers_in_words(set, levels[static_cast<std::size_t>(brief - 1)], brief));
    return write_csv(folders, "curve_errors_" + set.name, all).and_then([&] {
        return write_words(folders, "errors-" + set.name, text);
    });
}

Set noisy_of(Set set) {
    set.name = "noisy";
    set.what = fmt::format(
        "drawn outlines with Gaussian noise of {:.1f} mm on both coordinates, measured against the "
        "noisy data, which the boxes must hold",
        1e3 * noise_m);
    unsigned seed = 0;
    for (Curve& curve : set.curves) curve = with_noise(curve, noise_m, ++seed);
    return set;
}

}  // namespace

Result<void> measure_errors(const Folders& folders) {
    auto pinned = gallery_curves(false, pinned_pieces);
    if (!pinned) return tl::unexpected(pinned.error());
    auto drawn = gallery_curves(false, closed_outlines);
    if (!drawn) return tl::unexpected(drawn.error());
    auto traced = gallery_curves(true, closed_outlines);
    if (!traced) return tl::unexpected(traced.error());
    const Set whole{"drawn",
                    "closed outlines as the gallery draws its first pictures, not cut at pins",
                    std::move(*drawn),
                    6,
                    true,
                    false};
    for (const Set& set :
         {Set{"pinned",
              "pieces between pins of the gallery's first outlines, as the product cuts them",
              std::move(*pinned), 5, false, true},
          whole,
          Set{"traced", "closed outlines as the tracer finds them in those pictures' pixels",
              std::move(*traced), 6, true, false},
          noisy_of(whole)}) {
        if (auto written = measure(folders, set); !written) return written;
    }
    return {};
}

}  // namespace touchline::bench
