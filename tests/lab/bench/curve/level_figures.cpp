#include "app/cli/load.h"
#include "app/documents/decode/files.h"
#include "app/documents/gallery/gallery.h"
#include "haptics/curve/wavelet.h"
#include "tests/lab/bench/curve/coarse_curve.h"
#include "tests/lab/bench/curve/outlines.h"
#include "tests/lab/bench/curve/report.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace touchline::bench {
namespace {

constexpr int levels = 6;

Result<void> write_data(const Folders& folders, const std::string& name, const std::string& text) {
    return write_whole_file(folders.work + "/" + name + ".dat", text);
}

std::string lines(const Curve& line) {
    std::string text;
    for (const Position p : line) text += fmt::format("{:.4f} {:.4f}\n", 1e3 * p.x, 1e3 * p.y);
    return text;
}

/// The height of a traced outline along its length, with noise on a third of it: smooth and rough
/// areas, as in the paper's example.
Curve half_rough(const Curve& outline) {
    const Curve noisy = with_noise(outline, 4e-4, 1);
    Curve curve = outline;
    for (std::size_t i = curve.size() / 2; i < curve.size() * 5 / 6; ++i) curve[i] = noisy[i];
    return curve;
}

double largest(const std::vector<Position>& details, bool is_rough) {
    double most = 0.0;
    const std::size_t count = details.size();
    // Keeps away from the borders of the rough area by the reach of the filter.
    for (std::size_t k = 0; k < count; ++k) {
        const bool inside = 2 * k > count + 4 && 6 * k + 12 < 5 * count;
        const bool outside = 2 * k + 4 < count || (6 * k > 5 * count + 12);
        if (is_rough ? inside : outside) most = std::max(most, std::abs(details[k].y));
    }
    return most;
}

/// Figs. 1 and 2: coefficients level by level, and the smoothed approximations.
Result<void> plot_coefficients(const Folders& folders, const Curve& outline) {
    Curve curve = half_rough(outline);
    curve.pop_back();
    const Decomposition parts = decompose(curve, {curve.size(), 1, true}, levels);
    std::string approximations;
    std::string coefficients;
    std::vector<Position> points = curve;
    for (int level = 0; level <= levels; ++level) {
        const double step = std::exp2(level);
        for (std::size_t i = 0; i <= points.size(); ++i) {
            approximations += fmt::format("{} {:.4f}\n", step * static_cast<double>(i),
                                          1e3 * points[i % points.size()].y);
        }
        approximations += "\n\n";
        if (level == levels) break;
        const auto& details = parts.details[static_cast<std::size_t>(level)];
        for (std::size_t k = 0; k < details.size(); ++k) {
            coefficients += fmt::format("{} {:.5f}\n", step * (2.0 * static_cast<double>(k) + 1.0),
                                        1e3 * details[k].y);
        }
        coefficients += "\n\n";
        points = analyze(points, {curve.size(), static_cast<std::size_t>(step), true}).points;
    }
    const auto& finest = parts.details[0];
    const std::string fig1 = fmt::format(
        "Fig. 1, wavelet coefficients. Top: the height of a traced outline along its length, {} "
        "points, with noise "
        "of 0.4 mm added on a third of it. Below: the coefficients of levels 1 to {}, finest "
        "first, half as many on "
        "each. At level 1 the largest coefficient is {:.2f} mm in the rough third and {:.2f} mm "
        "elsewhere: where the "
        "data are smooth they are all but nothing.",
        curve.size(), levels, 1e3 * largest(finest, true), 1e3 * largest(finest, false));
    const std::string fig2 = fmt::format(
        "Fig. 2, approximations. The same data (level 0, {} points) and its levels 2, 4 and 6 ({}, "
        "{} and {} points), "
        "one above the other. The noise is fainter at level 2 and gone at level 4; level 6 keeps "
        "only the great rise and fall.",
        curve.size(), curve.size() / 4, curve.size() / 16, curve.size() / 64);
    return write_data(folders, "fig1", coefficients)
        .and_then([&] { return write_data(folders, "fig2", approximations); })
        .and_then([&] { return write_words(folders, "fig-coefficients", fig1); })
        .and_then([&] { return write_words(folders, "fig-approximations", fig2); });
}

/// Fig. 3: an image boundary at three levels.
Result<void> plot_boundary(const Folders& folders, const Curve& outline) {
    const CoarseCurve middle = coarse_curve(Method::paper_13_7, outline, 2);
    const CoarseCurve coarse = coarse_curve(Method::paper_13_7, outline, 4);
    const std::string data =
        lines(outline) + "\n\n" + lines(middle.points) + "\n\n" + lines(coarse.points);
    const CurveError off_2 = curve_error(outline, middle);
    const double mm = 1e3 * diagonal_m(outline);
    return write_data(folders, "fig3", data).and_then([&] {
        return write_words(
            folders, "fig-boundary",
            fmt::format("Fig. 3, a boundary curve at three levels: the outline of a hand as traced "
                        "from pixels, "
                        "{} points, then level 2 with {} and level 4 with {}. Level 2 lies {:.2f} "
                        "mm from level 0 "
                        "(RMS; {:.2f} mm at most, at corners) and level 4 {:.2f} mm, on a hand of "
                        "{:.0f} mm. Corners "
                        "are not pinned here, as in the paper.",
                        outline.size() - 1, middle.points.size() - 1, coarse.points.size() - 1,
                        mm * off_2.rms, mm * off_2.hausdorff, mm * curve_error(outline, coarse).rms,
                        mm));
    });
}

}  // namespace

Result<void> plot_levels(const Folders& folders) {
    return load_map(gallery_folder() + "/15-hand.svg", true).and_then([&](const TactileMap& map) {
        const Curve outline = closed_outlines(map).front();
        return plot_coefficients(folders, outline).and_then([&] {
            return plot_boundary(folders, outline);
        });
    });
}

}  // namespace touchline::bench
