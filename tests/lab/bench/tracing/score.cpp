#include "tests/lab/bench/tracing/score.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline::bench {
namespace {

constexpr double furthest_m = 0.01;
constexpr double covered_m = 0.002;
constexpr double places_apart_m = 5e-4;

double mean_distance(const DistanceField& field, std::span<const Position> places) {
    double sum_m = 0.0;
    for (const Position p : places) sum_m += field.at(p);
    return sum_m / static_cast<double>(places.size());
}

void add_edge(Position a, Position b, std::vector<Position>& places) {
    const int parts = std::max(1, static_cast<int>(std::ceil(norm(b - a) / places_apart_m)));
    for (int i = 0; i < parts; ++i) places.push_back(a + (i + 0.5) / parts * (b - a));
}

}  // namespace

std::vector<Position> places_on(const TactileMap& map) {
    std::vector<Position> places;
    for (const Outline& outline : map.outlines) {
        const auto& points = outline.points;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            add_edge(points[i], points[i + 1], places);
        if (outline.is_closed) add_edge(points.back(), points.front(), places);
    }
    return places;
}

double length_of(const TactileMap& map) {
    double sum_m = 0.0;
    for (const Outline& outline : map.outlines) {
        const auto& points = outline.points;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            sum_m += norm(points[i + 1] - points[i]);
        if (outline.is_closed) sum_m += norm(points.front() - points.back());
    }
    return sum_m;
}

DistanceField::DistanceField(std::span<const Position> places)
    : cells_(static_cast<std::size_t>(4 * half * half), static_cast<float>(furthest_m)) {
    const int reach = static_cast<int>(furthest_m / cell_m);
    for (const Position p : places) {
        const int px = static_cast<int>(std::floor(p.x / cell_m)) + half;
        const int py = static_cast<int>(std::floor(p.y / cell_m)) + half;
        for (int y = std::max(0, py - reach); y <= std::min(2 * half - 1, py + reach); ++y) {
            for (int x = std::max(0, px - reach); x <= std::min(2 * half - 1, px + reach); ++x) {
                const Position centre{(x - half + 0.5) * cell_m, (y - half + 0.5) * cell_m};
                float& cell = cells_[static_cast<std::size_t>(y * 2 * half + x)];
                cell = std::min(cell, static_cast<float>(norm(centre - p)));
            }
        }
    }
}

double DistanceField::at(Position p) const {
    const double x = p.x / cell_m + half - 0.5;
    const double y = p.y / cell_m + half - 0.5;
    const int most = 2 * half - 2;
    if (!(x >= 0.0 && y >= 0.0 && x <= most && y <= most)) return furthest_m;
    const int ix = static_cast<int>(x);
    const int iy = static_cast<int>(y);
    const auto cell = [&](int dx, int dy) {
        return double{cells_[static_cast<std::size_t>((iy + dy) * 2 * half + ix + dx)]};
    };
    const double u = x - ix;
    const double v = y - iy;
    return (1 - v) * ((1 - u) * cell(0, 0) + u * cell(1, 0)) +
           v * ((1 - u) * cell(0, 1) + u * cell(1, 1));
}

Score score(const DistanceField& outlines, std::span<const Position> on_outlines,
            std::span<const Position> path) {
    if (path.empty()) return {1.0, 0.0};
    std::vector<double> off_m;
    off_m.reserve(path.size());
    for (const Position p : path) off_m.push_back(outlines.at(p));
    const auto at =
        off_m.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(path.size() - 1));
    std::nth_element(off_m.begin(), at, off_m.end());
    const DistanceField near_path(path);
    const auto covered = std::count_if(on_outlines.begin(), on_outlines.end(),
                                       [&](Position p) { return near_path.at(p) <= covered_m; });
    return {*at, static_cast<double>(covered) / static_cast<double>(on_outlines.size())};
}

int most_like(std::span<const DistanceField> pictures,
              std::span<const std::vector<Position>> on_outlines, std::span<const Position> path) {
    if (path.empty()) return -1;
    const DistanceField near_path(path);
    int best = -1;
    double best_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const double off_m =
            mean_distance(pictures[i], path) + mean_distance(near_path, on_outlines[i]);
        if (!(off_m < best_m)) continue;
        best_m = off_m;
        best = static_cast<int>(i);
    }
    return best;
}

}  // namespace touchline::bench
