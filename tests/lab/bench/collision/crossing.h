// What every structure under test answers, with the same arithmetic, so that a comparison is one of
// structures alone; and the proxy that is the same over all of them. Threads: pure functions; one
// for a proxy.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/touch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

namespace touchline::bench {

/// What every structure under test answers, with the same arithmetic, so that a comparison is one
/// of structures alone. Threads: pure functions. The corners of a closed polyline; edge i runs from
/// corner i to the next.
using ClosedCurve = std::span<const Position>;

[[nodiscard]] inline Segment edge_of(ClosedCurve curve, std::size_t edge) {
    return {curve[edge], curve[edge + 1 == curve.size() ? 0 : edge + 1]};
}

/// Where a motion crosses the curve first.
struct Crossing {
    double share = 1.0;  // of the motion, 0 ... 1
    std::uint32_t edge = 0;
};

struct Nearest {
    Position point;
    double distance_m = 0.0;
};

/// Returns the share of the motion from `from` by `way` at which it meets a segment; both are
/// closed. Parallel ones do not meet.
[[nodiscard]] inline std::optional<double> crossing_share(Position from, Position way,
                                                          const Segment& segment) {
    const Position along = segment.b - segment.a;
    const Position offset = segment.a - from;
    const double area = cross(way, along);
    const double sign = std::copysign(1.0, area);
    const double whole = std::abs(area);
    const double on_segment = sign * cross(offset, way);
    const double on_motion = sign * cross(offset, along);
    // Nearly always they do not meet, and this needs no division. Joined by & because which of the
    // five fails is chance: one branch is foreseen, five are not.
    const bool is_met = (on_segment >= 0.0) & (on_segment <= whole) & (on_motion >= 0.0) &
                        (on_motion <= whole) & (whole > 0.0);
    return is_met ? std::optional(on_motion / whole) : std::nullopt;
}

/// Keeps the earlier of `first` and the motion's crossing with an edge.
inline void keep_first(std::optional<Crossing>& first, Position from, Position way,
                       const Segment& segment, std::uint32_t edge) {
    const auto share = crossing_share(from, way, segment);
    if (share && (!first || *share < first->share)) first = Crossing{*share, edge};
}

/// The square of the distance from p to a segment longer than 0, and the nearest point.
struct SquaredFoot {
    Position point;
    double squared_m2 = 0.0;
};

[[nodiscard]] inline SquaredFoot squared_foot(Position p, const Segment& segment) {
    const Position along = segment.b - segment.a;
    const double share = std::clamp(dot(p - segment.a, along) / dot(along, along), 0.0, 1.0);
    const Position point = segment.a + share * along;
    return {point, dot(p - point, p - point)};
}

/// The plain proxy: a point that stops at the first edge in its way and goes on along that edge's
/// line, at most four times a step. It is the same over every structure, so that their rows differ
/// by the structure alone. It has no states: the 10 nm that it keeps tell which side it is on.
/// Threads: one. No allocation beyond the structure's.
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
