// Looks at every edge, every time: the yardstick that is obviously right.
// Threads: immutable once built; any thread may query.
#pragma once

#include "tests/lab/bench/collision/crossing.h"

namespace touchline::bench {

class BruteForce {
  public:
    /// `curve` must outlive this object.
    explicit BruteForce(ClosedCurve curve) : curve_(curve) {}

    /// O(N).
    [[nodiscard]] std::optional<Crossing> first_crossing(Position from, Position to) const;
    [[nodiscard]] Nearest nearest(Position p) const;

  private:
    ClosedCurve curve_;
};

}  // namespace touchline::bench
