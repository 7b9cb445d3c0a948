// One straight stretch of a curve, and its nearest point to a place. Threads: pure functions.
#pragma once

#include "config/types/vec2.h"

#include <algorithm>

namespace touchline {

struct Segment {
    Position a, b;
};

/// True if shorter than 1e-13 m: the segment has ends, but rounding decides its direction.
[[nodiscard]] inline bool is_point(const Segment& segment) {
    const Position e = segment.b - segment.a;
    return dot(e, e) <= 1e-26;
}

/// The nearest point of a segment.
struct Foot {
    double parameter = 0.0;  // 0 ... 1; 0 if the segment is one point
    Position point;
    double distance_m = 0.0;
};

[[nodiscard]] inline Foot foot(Position p, const Segment& segment) {
    const Position e = segment.b - segment.a;
    const double square = dot(e, e);
    const double t = square > 0.0 ? std::clamp(dot(p - segment.a, e) / square, 0.0, 1.0) : 0.0;
    const Position point = segment.a + t * e;
    return {t, point, norm(p - point)};
}

}  // namespace touchline
