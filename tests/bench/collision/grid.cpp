#include "tests/bench/collision/grid.h"

#include <cmath>
#include <limits>

namespace touchline::bench {
namespace {

// Edges are entered into every cell that they pass nearer than this: far more than rounding, so
// that a crossing on a border is found in whichever cell the walk is.
constexpr double border_m = 1e-12;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The walk of a motion along one axis.
struct Axis {
    int step = 0;
    double next = infinity;   // share of the motion at the next border
    double width = infinity;  // share from border to border
};

Axis axis_of(double from, double way, double low, int cell, double cell_m) {
    if (way == 0.0) return {};
    const int step = way > 0.0 ? 1 : -1;
    const double border = low + (cell + (step > 0 ? 1 : 0)) * cell_m;
    return {step, (border - from) / way, cell_m / std::abs(way)};
}

}  // namespace

Grid::Grid(ClosedCurve curve, double cells_per_edge) : curve_(curve) {
    low_ = curve[0];
    Position high = curve[0];
    for (const Position p : curve) {
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double cells = cells_per_edge * static_cast<double>(curve.size());
    cell_m_ = std::sqrt((high.x - low_.x) * (high.y - low_.y) / cells);
    cells_per_m_ = 1.0 / cell_m_;
    low_ = low_ - Position{cell_m_, cell_m_};  // a margin, so that borders lie inside
    columns_ = static_cast<int>((high.x - low_.x) * cells_per_m_) + 2;
    rows_ = static_cast<int>((high.y - low_.y) * cells_per_m_) + 2;
    fill();
}

Grid::Cell Grid::cell_of(Position p) const {
    return {static_cast<int>(std::floor((p.x - low_.x) * cells_per_m_)),
            static_cast<int>(std::floor((p.y - low_.y) * cells_per_m_))};
}

std::size_t Grid::index_of(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(cell.x);
}

/// Calls visit(cell index) for the cells that the edge passes: in each row of cells, those between
/// the places where the edge enters and leaves it.
template <class Visitor>
void Grid::for_cells_of(const Segment& edge, const Visitor& visit) const {
    const Position a = edge.a.y <= edge.b.y ? edge.a : edge.b;
    const Position b = edge.a.y <= edge.b.y ? edge.b : edge.a;
    const Position margin{border_m, border_m};
    const Cell first = cell_of(a - margin);
    const Cell last = cell_of(b + margin);
    const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0.0;
    for (int y = first.y; y <= last.y; ++y) {
        double enter = a.x;
        double leave = b.x;
        if (first.y != last.y) {
            const double bottom = std::clamp(low_.y + y * cell_m_ - border_m, a.y, b.y);
            const double top = std::clamp(low_.y + (y + 1) * cell_m_ + border_m, a.y, b.y);
            enter = b.y > a.y ? a.x + (bottom - a.y) * slope : a.x;
            leave = b.y > a.y ? a.x + (top - a.y) * slope : b.x;
        }
        const int from = cell_of({std::min(enter, leave) - border_m, a.y}).x;
        const int to = cell_of({std::max(enter, leave) + border_m, a.y}).x;
        for (int x = from; x <= to; ++x) visit(index_of({x, y}));
    }
}

void Grid::fill() {
    const std::size_t cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    first_.assign(cells + 1, 0);
    for (std::size_t edge = 0; edge < curve_.size(); ++edge) {
        for_cells_of(edge_of(curve_, edge), [&](std::size_t cell) { ++first_[cell + 1]; });
    }
    for (std::size_t cell = 0; cell < cells; ++cell) first_[cell + 1] += first_[cell];
    edges_.resize(first_[cells]);
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t edge = 0; edge < curve_.size(); ++edge) {
        for_cells_of(edge_of(curve_, edge), [&](std::size_t cell) { edges_[next[cell]++] = edge; });
    }
}

std::optional<Crossing> Grid::first_crossing(Position from, Position to) const {
    const Position way = to - from;
    Cell cell = cell_of(from);
    Axis x = axis_of(from.x, way.x, low_.x, cell.x, cell_m_);
    Axis y = axis_of(from.y, way.y, low_.y, cell.y, cell_m_);
    std::optional<Crossing> first;
    for (double entered = 0.0; entered <= 1.0;) {
        const bool is_inside = cell.x >= 0 && cell.y >= 0 && cell.x < columns_ && cell.y < rows_;
        if (is_inside) {
            const std::size_t index = index_of(cell);
            for (std::uint32_t k = first_[index]; k < first_[index + 1]; ++k) {
                keep_first(first, from, way, curve_, edges_[k]);
            }
        }
        const double leaves = std::min(x.next, y.next);
        if (first && first->share <= leaves) break;
        Axis& crossed = x.next <= y.next ? x : y;
        (&crossed == &x ? cell.x : cell.y) += crossed.step;
        entered = leaves;
        crossed.next += crossed.width;
    }
    return first;
}

}  // namespace touchline::bench
