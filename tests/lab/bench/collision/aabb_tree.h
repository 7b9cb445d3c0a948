// CGAL's tree of axis-aligned boxes over the edges, taken as segments in space with z = 0, because
// this version has no tree for the plane. Threads: immutable once built; any thread may query.
#pragma once

#include "tests/lab/bench/collision/crossing.h"

#include <memory>

namespace touchline::bench {

class AabbTree {
  public:
    /// Also builds the search structure that the library wants for nearest points. O(N log N).
    /// `curve` must outlive the tree.
    explicit AabbTree(ClosedCurve curve);
    AabbTree(AabbTree&&) noexcept;
    AabbTree(const AabbTree&) = delete;
    AabbTree& operator=(AabbTree&&) = delete;
    AabbTree& operator=(const AabbTree&) = delete;
    ~AabbTree();

    /// Uses the library's traversal and box test. Cuts the motion at every crossing found, so that
    /// it skips the boxes behind it.
    [[nodiscard]] std::optional<Crossing> first_crossing(Position from, Position to) const;

    [[nodiscard]] Nearest nearest(Position p) const;

  private:
    struct Index;
    ClosedCurve curve_;
    std::unique_ptr<Index> index_;
};

}  // namespace touchline::bench
