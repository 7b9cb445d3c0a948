#include "tests/bench/curve/outlines.h"

#include "app/cli/load.h"
#include "app/gallery/gallery.h"
#include "haptics/curve/sampling.h"

#include <cmath>
#include <numbers>
#include <random>

namespace touchline::bench {
namespace {

constexpr double shortest_m = 0.04;

/// Equal arc length, from a polyline that repeats its first point.
ClosedCurve resampled(const std::vector<Position>& line) {
    ClosedCurve curve = resample(line, outline_points);
    curve.pop_back();
    return curve;
}

}  // namespace

std::vector<ClosedCurve> closed_outlines(const TactileMap& map) {
    std::vector<ClosedCurve> curves;
    for (const Outline& outline : map.outlines) {
        if (!outline.is_closed || outline.points.size() < 3) continue;
        std::vector<Position> line = outline.points;
        line.push_back(line.front());
        if (polyline_length_m(line) >= shortest_m) curves.push_back(resampled(line));
    }
    return curves;
}

Result<std::vector<ClosedCurve>> gallery_outlines(bool is_traced) {
    const auto entries = list_gallery(gallery_folder());
    if (!entries) return tl::unexpected(entries.error());
    std::vector<ClosedCurve> all;
    for (const GalleryEntry& entry : *entries) {
        const auto map = load_map(entry.path, is_traced);
        if (!map) return tl::unexpected(map.error());
        for (ClosedCurve& curve : closed_outlines(*map)) all.push_back(std::move(curve));
    }
    return all;
}

std::vector<ClosedCurve> smooth_outlines() {
    constexpr std::size_t fine = 16 * outline_points;
    std::vector<ClosedCurve> curves;
    for (int waves = 2; waves <= 5; ++waves) {
        std::vector<Position> line;
        for (std::size_t i = 0; i <= fine; ++i) {
            const double angle =
                2.0 * std::numbers::pi * static_cast<double>(i % fine) / static_cast<double>(fine);
            const double radius_m = 0.035 * (1.0 + 0.25 * std::cos(waves * angle + 0.5) +
                                             0.1 * std::cos((2 * waves + 1) * angle));
            line.push_back({radius_m * std::cos(angle), radius_m * std::sin(angle)});
        }
        curves.push_back(resampled(line));
    }
    return curves;
}

ClosedCurve with_noise(const ClosedCurve& curve, double sigma_m, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, sigma_m);
    ClosedCurve noisy = curve;
    for (Position& p : noisy) p += Position{noise(random), noise(random)};
    return noisy;
}

}  // namespace touchline::bench
