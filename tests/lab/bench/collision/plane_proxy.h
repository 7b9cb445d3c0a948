// The plain proxy: a point that stops at the first edge in its way and goes on along that edge's
// line, at most four times a step. It is the same over every structure, so that their rows differ
// by the structure alone. It has no states: the 10 nm that it keeps tell which side it is on.
// Threads: one. No allocation beyond the structure's.
#pragma once

#include "tests/lab/bench/collision/crossing.h"

#include <cmath>

namespace touchline::bench {

/// Structure needs first_crossing(from, to) as in crossing.h.
template <class Structure>
class PlaneProxy {
  public:
    /// Both must outlive the proxy.
    PlaneProxy(const Structure& structure, ClosedCurve curve)
        : structure_(structure), curve_(curve) {}

    void start(Position hand) { proxy_ = hand; }

    void reset(Position hand) { proxy_ = hand; }

    /// Moves towards the hand. Returns the proxy.
    Position step(Position hand) {
        Position goal = hand;
        for (int cast = 0; cast < casts; ++cast) {
            const Position way = goal - proxy_;
            const double length_m = std::sqrt(dot(way, way));
            if (length_m < least_motion_m) break;
            const auto crossing = structure_.first_crossing(proxy_, goal);
            if (!crossing) {
                proxy_ = goal;
                break;
            }
            proxy_ += std::max(0.0, crossing->share - kept_m / length_m) * way;
            const Segment edge = edge_of(curve_, crossing->edge);
            const Position u = edge.b - edge.a;
            goal = proxy_ + (dot(hand - proxy_, u) / dot(u, u)) * u;
        }
        return proxy_;
    }

  private:
    static constexpr int casts = 4;
    static constexpr double least_motion_m = 1e-12;
    static constexpr double kept_m = 1e-8;  // short of the edge

    const Structure& structure_;
    ClosedCurve curve_;
    Position proxy_;
};

}  // namespace touchline::bench
