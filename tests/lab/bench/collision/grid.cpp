#include "tests/lab/bench/collision/grid.h"

#include <algorithm>
#include <cmath>

namespace touchline::bench {
namespace {

// Edges are entered into every cell that they pass nearer than this. It is far more than the
// rounding, so the walk finds a crossing on a border from whichever cell it is in.
constexpr double border_m = 1e-12;
constexpr double most_blocks = 2048.0;  // each way
constexpr double farthest_cells = 1e9;  // so that a cell's number fits an int

/// The walk of a motion along one axis, in cells. Without branches: which way a motion goes, no
/// processor can foresee.
struct Axis {
    double from;
    double share_of_cell;  // of the motion; infinite if it does not go along this axis
    int step;              // 1 or -1
    int ahead;             // 1 if it leaves a cell at its upper border, otherwise 0

    Axis(double from_cells, double way_cells)
        : from(from_cells),
          share_of_cell(1.0 / std::abs(way_cells)),
          step(way_cells < 0.0 ? -1 : 1),
          ahead(way_cells < 0.0 ? 0 : 1) {}

    /// Returns the share of the motion at which it leaves `cells` cells that begin at `lowest`.
    [[nodiscard]] double leaves(int lowest, int cells) const {
        return std::abs(lowest + ahead * cells - from) * share_of_cell;
    }

    /// Returns the cell that follows on them.
    [[nodiscard]] int after(int lowest, int cells) const {
        return ahead == 1 ? lowest + cells : lowest - 1;
    }
};

}  // namespace

Grid::Grid(ClosedCurve curve, double edges_per_cell) : curve_(curve) {
    low_ = curve[0];
    Position high = curve[0];
    double length_m = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Segment edge = edge_of(curve, i);
        low_ = {std::min(low_.x, edge.a.x), std::min(low_.y, edge.a.y)};
        high = {std::max(high.x, edge.a.x), std::max(high.y, edge.a.y)};
        length_m += norm(edge.b - edge.a);
    }
    const double extent_m = std::max(high.x - low_.x, high.y - low_.y);
    const double finest_m = extent_m / (most_blocks * block);
    cell_m_ = edges_per_cell * std::max(length_m / static_cast<double>(curve.size()), finest_m);
    cells_per_m_ = 1.0 / cell_m_;
    low_ = low_ - Position{cell_m_, cell_m_};  // a margin, so that borders are inside
    const Cell last = cell_of(high + Position{cell_m_, cell_m_});
    columns_ = last.x / block + 1;
    rows_ = last.y / block + 1;
    fill();
}

/// Calls visit(cell) for the cells that the edge passes: in each row of cells, those between the
/// places where the edge enters and leaves it.
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
        if (first.y != last.y && b.y > a.y) {
            const double bottom = low_.y + y * cell_m_ - border_m;
            const double top = low_.y + (y + 1) * cell_m_ + border_m;
            enter = a.x + (std::clamp(bottom, a.y, b.y) - a.y) * slope;
            leave = a.x + (std::clamp(top, a.y, b.y) - a.y) * slope;
        }
        const int from = cell_of({std::min(enter, leave) - border_m, a.y}).x;
        const int to = cell_of({std::max(enter, leave) + border_m, a.y}).x;
        for (int x = from; x <= to; ++x) visit(Cell{x, y});
    }
}

void Grid::fill() {
    constexpr std::size_t cells_of_block = block * block;
    blocks_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), empty);
    std::uint32_t stored = 0;
    const auto for_all = [&](const auto& visit) {
        for (std::uint32_t edge = 0; edge < curve_.size(); ++edge) {
            for_cells_of(edge_of(curve_, edge), [&](Cell cell) { visit(cell, edge); });
        }
    };
    for_all([&](Cell cell, std::uint32_t /*edge*/) {
        std::uint32_t& at = blocks_[block_index(cell)];
        if (at == empty) at = stored++;
    });
    first_.assign(stored * cells_of_block + 1, 0);
    const auto index_of = [&](Cell cell) {
        return blocks_[block_index(cell)] * cells_of_block + place_in_block(cell);
    };
    for_all([&](Cell cell, std::uint32_t /*edge*/) { ++first_[index_of(cell) + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    entries_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for_all([&](Cell cell, std::uint32_t edge) {
        entries_[next[index_of(cell)]++] = {edge_of(curve_, edge), edge};
    });
}

std::optional<Crossing> Grid::first_crossing(Position from, Position to) const {
    // The only object returned: with a second one each answer is copied, about 20 ns a query.
    std::optional<Crossing> first;
    const Position way = to - from;
    const Position begin = in_cells(from);
    const Position along = cells_per_m_ * way;
    const double reach =
        std::abs(begin.x) + std::abs(begin.y) + std::abs(along.x) + std::abs(along.y);
    if (!(reach < farthest_cells)) return first;
    const Axis x(begin.x, along.x);
    const Axis y(begin.y, along.y);
    Cell cell = cell_at(begin);
    double leaves_x = x.leaves(cell.x, 1);
    double leaves_y = y.leaves(cell.y, 1);
    while (true) {
        const std::uint32_t stored = block_at(cell);
        if (stored == empty) {
            const Cell low{cell.x & -block, cell.y & -block};  // of its block
            leaves_x = x.leaves(low.x, block);
            leaves_y = y.leaves(low.y, block);
            const double leaves = std::min(leaves_x, leaves_y);
            if (!(leaves <= 1.0)) return first;
            // Across the border exactly; along it, where the motion is.
            const Cell there = cell_at(begin + leaves * along);
            cell = leaves_x <= leaves_y
                       ? Cell{x.after(low.x, block), std::clamp(there.y, low.y, low.y + block - 1)}
                       : Cell{std::clamp(there.x, low.x, low.x + block - 1), y.after(low.y, block)};
            leaves_x = x.leaves(cell.x, 1);
            leaves_y = y.leaves(cell.y, 1);
            continue;
        }
        const std::uint32_t* const at =
            &first_[static_cast<std::size_t>(stored) * block * block + place_in_block(cell)];
        for (std::uint32_t k = at[0]; k < at[1]; ++k) {
            keep_first(first, from, way, entries_[k].segment, entries_[k].edge);
        }
        const double leaves = std::min(leaves_x, leaves_y);
        if (!(leaves <= 1.0) || (first && first->share <= leaves)) return first;
        if (leaves_x <= leaves_y) {
            cell.x += x.step;
            leaves_x += x.share_of_cell;
        } else {
            cell.y += y.step;
            leaves_y += y.share_of_cell;
        }
    }
}

}  // namespace touchline::bench
