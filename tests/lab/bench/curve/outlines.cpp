#include "tests/lab/bench/curve/outlines.h"

#include "app/cli/load.h"
#include "haptics/curve/spacing.h"
#include "tests/haptics/curve/uniform_points.h"

#include <cmath>
#include <numbers>
#include <random>

namespace touchline::bench {
namespace {

constexpr double shortest_outline_m = 0.04;
constexpr double shortest_piece_m = 0.02;
constexpr double least_bend = 0.01;
}  // namespace

std::vector<Curve> closed_outlines(const TactileMap& map) {
    std::vector<Curve> curves;
    for (const Outline& outline : map.outlines) {
        if (!outline.is_closed || outline.points.size() < 3) continue;
        std::vector<Position> line = outline.points;
        line.push_back(line.front());
        if (polyline_length_m(line) >= shortest_outline_m) {
            curves.push_back(resample(line, outline_points));
        }
    }
    return curves;
}

std::vector<Curve> pinned_pieces(const TactileMap& map) {
    std::vector<Curve> pieces;
    for (const uniform::Line& line : uniform::lines_of(map)) {
        const double length_m = polyline_length_m(line.points);
        if (length_m < shortest_piece_m) continue;
        const double off_m = deviation_m(line.points, resample(line.points, 1));
        if (off_m >= least_bend * length_m) pieces.push_back(resample(line.points, piece_segments));
    }
    return pieces;
}

Result<std::vector<GalleryEntry>> measured_pictures() {
    constexpr std::size_t measured = 16;
    auto entries = list_gallery(gallery_folder());
    if (entries && entries->size() < measured) return failure("the gallery lacks pictures");
    if (entries) entries->resize(measured);
    return entries;
}

Result<std::vector<Curve>> gallery_curves(bool is_traced,
                                          std::vector<Curve> (*curves_of)(const TactileMap&)) {
    const auto entries = measured_pictures();
    if (!entries) return tl::unexpected(entries.error());
    std::vector<Curve> all;
    for (const GalleryEntry& entry : *entries) {
        const auto map = load_map(entry.path, is_traced);
        if (!map) return tl::unexpected(map.error());
        for (Curve& curve : curves_of(*map)) all.push_back(std::move(curve));
    }
    return all;
}

std::vector<Curve> smooth_outlines() {
    constexpr std::size_t fine = 16 * outline_points;
    std::vector<Curve> curves;
    for (int waves = 2; waves <= 5; ++waves) {
        std::vector<Position> line;
        for (std::size_t i = 0; i <= fine; ++i) {
            const double angle =
                2.0 * std::numbers::pi * static_cast<double>(i % fine) / static_cast<double>(fine);
            const double radius_m = 0.035 * (1.0 + 0.25 * std::cos(waves * angle + 0.5) +
                                             0.1 * std::cos((2 * waves + 1) * angle));
            line.push_back({radius_m * std::cos(angle), radius_m * std::sin(angle)});
        }
        curves.push_back(resample(line, outline_points));
    }
    return curves;
}

Curve with_noise(const Curve& curve, double sigma_m, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, sigma_m);
    Curve noisy = curve;
    for (Position& p : noisy) p += Position{noise(random), noise(random)};
    noisy.back() = noisy.front();
    return noisy;
}

}  // namespace touchline::bench
