// A uniform grid over the edges of a closed curve: the plain structure that a better one must beat.
// Stores only the blocks of cells that the curve passes; a walk crosses an empty one at once.
// Threads: immutable once built; any thread may query.
#pragma once

#include "tests/lab/bench/collision/crossing.h"

#include <cstdint>
#include <vector>

namespace touchline::bench {

class Grid {
  public:
    /// Makes square cells, `edges_per_cell` mean edges wide, or as wide as 2048 by 2048 blocks of
    /// 16 by 16 cells allow. O(N + blocks). `curve` must outlive the grid.
    Grid(ClosedCurve curve, double edges_per_cell);

    /// Walks the cells that the motion passes, in order (after Amanatides and Woo, 1987), and stops
    /// after the first that holds a crossing. Finds none on a motion that is not finite or reaches
    /// beyond 1e9 cells.
    [[nodiscard]] std::optional<Crossing> first_crossing(Position from, Position to) const;

    [[nodiscard]] double cell_m() const { return cell_m_; }

  private:
    struct Cell {
        int x, y;
    };

    /// An edge in a cell, with its place, so that each edge takes one access to memory.
    struct Entry {
        Segment segment;
        std::uint32_t edge;
    };

    static constexpr int block = 16;  // cells, each way
    static constexpr std::uint32_t empty = 0xFFFFFFFF;

    // Defined here so that the compiler may inline them in position-independent code.

    /// Returns a position in cells, from the lowest corner of the grid.
    [[nodiscard]] Position in_cells(Position p) const { return cells_per_m_ * (p - low_); }

    /// Cuts off the fraction. The outermost cells stand for those just outside too: nothing but
    /// edges on their inner border is in them.
    [[nodiscard]] static Cell cell_at(Position in_cells) {
        return {static_cast<int>(in_cells.x), static_cast<int>(in_cells.y)};
    }

    [[nodiscard]] Cell cell_of(Position p) const { return cell_at(in_cells(p)); }

    [[nodiscard]] std::size_t block_index(Cell cell) const {
        return static_cast<std::size_t>(cell.y / block) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(cell.x / block);
    }

    /// Returns which of the stored blocks holds the cell; `empty` if none does.
    [[nodiscard]] std::uint32_t block_at(Cell cell) const {
        const bool is_inside =
            cell.x >= 0 && cell.y >= 0 && cell.x < columns_ * block && cell.y < rows_ * block;
        return is_inside ? blocks_[block_index(cell)] : empty;
    }

    [[nodiscard]] static std::size_t place_in_block(Cell cell) {
        return static_cast<std::size_t>((cell.y & (block - 1)) * block + (cell.x & (block - 1)));
    }

    template <class Visitor>
    void for_cells_of(const Segment& edge, const Visitor& visit) const;
    void fill();

    ClosedCurve curve_;
    double cell_m_ = 1.0;
    double cells_per_m_ = 1.0;
    Position low_;
    int columns_ = 1, rows_ = 1;         // of blocks
    std::vector<std::uint32_t> blocks_;  // index of the stored block; `empty` if there is none
    std::vector<std::uint32_t> first_;   // per cell of a stored block, in entries_; then one more
    std::vector<Entry> entries_;
};

}  // namespace touchline::bench
