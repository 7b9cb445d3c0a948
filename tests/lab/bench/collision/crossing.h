// What every structure under test answers, with the same arithmetic, so that a comparison is one of
// structures alone. Threads: pure functions.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/touch.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

namespace touchline::bench {

/// The corners of a closed polyline; edge i runs from corner i to the next.
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
    const double sign = area < 0.0 ? -1.0 : 1.0;
    const double whole = sign * area;
    const double on_segment = sign * cross(offset, way);
    const double on_motion = sign * cross(offset, along);
    // Nearly always they do not meet, and this needs no division.
    const bool is_met = on_segment >= 0.0 && on_segment <= whole && on_motion >= 0.0 &&
                        on_motion <= whole && whole > 0.0;
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

}  // namespace touchline::bench
