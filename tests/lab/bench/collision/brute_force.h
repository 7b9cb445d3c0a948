// The yardsticks that are obviously right. Threads: immutable once built; any thread may ask.
#pragma once

#include "tests/lab/bench/collision/crossing.h"

#include <vector>

namespace touchline::bench {

/// Looks at every edge, every time.
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

/// Whether a point lies inside a closed curve, by the even-odd rule. Judges proxies that report
/// only places, no way.
class Inside {
  public:
    /// Sorts the edges into horizontal bands. O(N + bands crossed). `curve` must outlive this
    /// object.
    explicit Inside(ClosedCurve curve);

    [[nodiscard]] bool operator()(Position p) const;

  private:
    [[nodiscard]] std::size_t band_of(double y) const;

    ClosedCurve curve_;
    double low_ = 0.0, high_ = 0.0;
    std::vector<std::vector<std::uint32_t>> bands_;
};

}  // namespace touchline::bench
