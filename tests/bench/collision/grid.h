// A uniform grid over the edges of a closed curve: the plain structure that a better one must beat.
// Threads: immutable once built; any thread may query.
#pragma once

#include "tests/bench/collision/crossing.h"

#include <cstdint>
#include <vector>

namespace touchline::bench {

class Grid {
  public:
    /// Square cells, about `cells_per_edge` times as many as edges. O(N + cells). `curve` must
    /// outlive it.
    Grid(ClosedCurve curve, double cells_per_edge);

    /// Walks the cells that the motion passes, in order (Amanatides and Woo, 1987), and stops after
    /// the first that holds a crossing.
    [[nodiscard]] std::optional<Crossing> first_crossing(Position from, Position to) const;

    [[nodiscard]] double cell_m() const { return cell_m_; }

  private:
    struct Cell {
        int x, y;
    };

    [[nodiscard]] Cell cell_of(Position p) const;
    [[nodiscard]] std::size_t index_of(Cell cell) const;
    template <class Visitor>
    void for_cells_of(const Segment& edge, const Visitor& visit) const;
    void fill();

    ClosedCurve curve_;
    double cell_m_ = 1.0;
    double cells_per_m_ = 1.0;
    Position low_;
    int columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> first_;  // per cell, in edges_; one more at the end
    std::vector<std::uint32_t> edges_;
};

}  // namespace touchline::bench
