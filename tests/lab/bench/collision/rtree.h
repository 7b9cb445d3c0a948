// Boost.Geometry's R-tree over the edges.
// Threads: immutable once built; any thread may query.
#pragma once

#include "tests/lab/bench/collision/crossing.h"

#include <memory>

namespace touchline::bench {

class RTree {
  public:
    /// Packed (sort-tile-recursive), 16 values a node. O(N log N). `curve` must outlive the tree.
    explicit RTree(ClosedCurve curve);
    RTree(RTree&&) noexcept;
    RTree(const RTree&) = delete;
    RTree& operator=(RTree&&) = delete;
    RTree& operator=(const RTree&) = delete;
    ~RTree();

    /// Looks at every edge that the library finds on the motion, because it has no ordered walk
    /// along one.
    [[nodiscard]] std::optional<Crossing> first_crossing(Position from, Position to) const;

    [[nodiscard]] Nearest nearest(Position p) const;

  private:
    struct Index;
    ClosedCurve curve_;
    std::unique_ptr<Index> index_;
};

}  // namespace touchline::bench
