#include "tests/lab/bench/collision/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline::bench {
namespace {

// Edges are entered into every cell that they pass nearer than this. It is far more than the
// rounding, so the walk finds a crossing on a border from whichever cell it is in.
constexpr double border_m = 1e-12;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_blocks = 2048.0;  // each way

/// The walk of a motion along one axis.
struct Axis {
    double from, low, cell_m;
    double shares_per_m = 0.0;  // of the motion
    int step = 0;

    Axis(double from_m, double way_m, double low_m, double cell)
        : from(from_m), low(low_m), cell_m(cell) {
        if (way_m == 0.0) return;
        shares_per_m = 1.0 / way_m;
        step = way_m > 0.0 ? 1 : -1;
    }

    /// Returns the share of the motion at which it leaves the first of `cells` cells, seen along
    /// the motion.
    [[nodiscard]] double leaves(int lowest_cell, int cells) const {
        if (step == 0) return infinity;
        const int border = step > 0 ? lowest_cell + cells : lowest_cell;
        return (low + border * cell_m - from) * shares_per_m;
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
    const Position way = to - from;
    const Axis x(from.x, way.x, low_.x, cell_m_);
    const Axis y(from.y, way.y, low_.y, cell_m_);
    const double cell_x = cell_m_ * std::abs(x.shares_per_m);
    const double cell_y = cell_m_ * std::abs(y.shares_per_m);
    Cell cell = cell_of(from);
    std::optional<Crossing> first;
    while (true) {
        const Cell low{cell.x & -block, cell.y & -block};  // of its block
        const std::uint32_t stored = block_at(cell);
        if (stored == empty) {
            const double leaves_x = x.leaves(low.x, block);
            const double leaves_y = y.leaves(low.y, block);
            const double leaves = std::min(leaves_x, leaves_y);
            if (!(leaves <= 1.0)) return first;
            // Across the border exactly; along it, where the motion is.
            const Cell there = cell_of(from + leaves * way);
            const bool is_x = leaves_x <= leaves_y;
            cell = is_x ? Cell{x.step > 0 ? low.x + block : low.x - 1,
                               std::clamp(there.y, low.y, low.y + block - 1)}
                        : Cell{std::clamp(there.x, low.x, low.x + block - 1),
                               y.step > 0 ? low.y + block : low.y - 1};
            continue;
        }
        double leaves_x = x.leaves(cell.x, 1);
        double leaves_y = y.leaves(cell.y, 1);
        const std::uint32_t* const block_first =
            &first_[static_cast<std::size_t>(stored) * block * block];
        for (bool is_in_block = true; is_in_block;) {
            const std::uint32_t* const at = block_first + place_in_block(cell);
            for (std::uint32_t k = at[0]; k < at[1]; ++k) {
                keep_first(first, from, way, entries_[k].segment, entries_[k].edge);
            }
            const double leaves = std::min(leaves_x, leaves_y);
            if (!(leaves <= 1.0) || (first && first->share <= leaves)) return first;
            if (leaves_x <= leaves_y) {
                cell.x += x.step;
                leaves_x += cell_x;
            } else {
                cell.y += y.step;
                leaves_y += cell_y;
            }
            is_in_block = (cell.x & -block) == low.x && (cell.y & -block) == low.y;
        }
    }
}

}  // namespace touchline::bench
