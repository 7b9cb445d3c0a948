#include "tests/lab/bench/collision/level_judge.h"

#include "tests/exact/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline::bench {
namespace {

constexpr double edges_per_cell = 4.0;
constexpr double smallest_cell_m = 1e-5;  // a thirtieth of a fast step
constexpr double largest_cell_m = 5e-4;

struct Extent {
    double low_x, high_x, low_y, high_y;
};

Extent extent_of(std::span<const Position> points) {
    const auto [left, right] = std::minmax_element(
        points.begin(), points.end(), [](Position a, Position b) { return a.x < b.x; });
    const auto [lowest, highest] = std::minmax_element(
        points.begin(), points.end(), [](Position a, Position b) { return a.y < b.y; });
    return {left->x, right->x, lowest->y, highest->y};
}

/// Calls visit(key) for every cell that the extent meets; stops if it returns false.
template <class Visitor>
bool for_cells(const Extent& extent, double cell_m, const Visitor& visit) {
    const auto index = [&](double v) { return static_cast<std::int64_t>(std::floor(v / cell_m)); };
    for (std::int64_t x = index(extent.low_x); x <= index(extent.high_x); ++x) {
        for (std::int64_t y = index(extent.low_y); y <= index(extent.high_y); ++y) {
            if (!visit(x * 1000003 + y)) return false;
        }
    }
    return true;
}

double mean_edge_m(const CurveSet& curves, double level) {
    double length_m = 0.0;
    int edges = 0;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
            const Segment s = curves.rendered_segment(piece, level, j);
            length_m += norm(s.b - s.a);
            ++edges;
        }
    }
    return length_m / std::max(edges, 1);
}

}  // namespace

/// A segment's ends run straight from their places at the whole level to those at the next, so the
/// extent of both holds it all the way.
const LevelJudge::Cells& LevelJudge::cells_of(double level) {
    const double finer = std::floor(level);
    const auto found = by_level_.find(static_cast<int>(finer));
    if (found != by_level_.end()) return found->second;
    Cells& cells = by_level_[static_cast<int>(finer)];
    const double blended = std::nextafter(finer + 1.0, finer);
    cells.cell_m =
        std::clamp(edges_per_cell * mean_edge_m(*curves_, finer), smallest_cell_m, largest_cell_m);
    for (int piece = 0; piece < static_cast<int>(curves_->pieces().size()); ++piece) {
        for (int j = 0; j < curves_->rendered_count(piece, finer); ++j) {
            const Segment s = curves_->rendered_segment(piece, finer, j);
            const Segment t = curves_->rendered_segment(piece, blended, j);
            const std::array corners{s.a, s.b, t.a, t.b};
            for_cells(extent_of(corners), cells.cell_m, [&](std::int64_t key) {
                cells.segments[key].push_back({piece, j});
                return true;
            });
        }
    }
    return cells;
}

bool LevelJudge::is_free(Position a, Position b, double level, const Cells& cells) const {
    // Grown by more than the rounding, so as not to miss a meeting on a border of cells.
    const Position margin{1e-12, 1e-12};
    const std::array ends{a - margin, a + margin, b - margin, b + margin};
    return for_cells(extent_of(ends), cells.cell_m, [&](std::int64_t key) {
        const auto cell = cells.segments.find(key);
        return cell == cells.segments.end() ||
               std::none_of(cell->second.begin(), cell->second.end(), [&](SegmentRef at) {
                   const Segment s = curves_->rendered_segment(at.piece, level, at.index);
                   return exact::meet(a, b, s.a, s.b);
               });
    });
}

bool LevelJudge::is_free(std::span<const Position> way, double level) {
    const Cells& cells = cells_of(level);
    for (std::size_t i = 1; i < way.size(); ++i) {
        if (!is_free(way[i - 1], way[i], level, cells)) return false;
    }
    return true;
}

}  // namespace touchline::bench
