// A stretch with a round thickness, and how two straight stretches lie to each other: the bound and
// the leaf test of a shape against the tree. Threads: pure functions, no allocation.
#pragma once

#include "config/types/vec2.h"
#include "haptics/collision/box.h"
#include "haptics/curve/segment.h"

#include <algorithm>
#include <cmath>

namespace touchline {

/// Everything within `thickness_m` of the chord.
struct Capsule {
    Segment chord;
    double thickness_m = 0.0;
};

/// Returns a capsule that holds the box; its chord runs along the longer side.
[[nodiscard]] inline Capsule capsule_of(const Box& box) {
    const double along_m = box.along_high - box.along_low;
    const double across_m = box.across_high - box.across_low;
    const double length = norm(box.axis);
    const Position across = left_of(box.axis);
    if (along_m >= across_m) {
        const Position middle = box.origin + 0.5 * (box.across_low + box.across_high) * across;
        return {{middle + box.along_low * box.axis, middle + box.along_high * box.axis},
                0.5 * across_m * length};
    }
    const Position middle = box.origin + 0.5 * (box.along_low + box.along_high) * box.axis;
    return {{middle + box.across_low * across, middle + box.across_high * across},
            0.5 * along_m * length};
}

/// Returns the point at a share along a segment; beyond its ends, exactly the end.
[[nodiscard]] inline Position point_at(const Segment& s, double share) {
    if (share >= 1.0) return s.b;
    return s.a + std::max(share, 0.0) * (s.b - s.a);
}

/// The nearest points of two segments.
struct Separation {
    double distance_m = 0.0;
    Direction normal;   // from the second to the first; {0, 0} where they meet
    Position on_first;  // the points nearest to each other
    Position on_second;
};

/// About 40 operations and a root. Of segments that do not cross, one end is always among the
/// nearest points.
[[nodiscard]] inline Separation separation(const Segment& first, const Segment& second) {
    const Position e = first.b - first.a;
    const Position f = second.b - second.a;
    const Position w = second.a - first.a;
    const double ee = dot(e, e);
    const double ff = dot(f, f);
    const double ew = dot(e, w);
    const double fw = dot(f, w);
    const double ef = dot(e, f);
    const double per_ee = ee > 0.0 ? 1.0 / ee : 0.0;
    const double per_ff = ff > 0.0 ? 1.0 / ff : 0.0;
    Separation best;
    double least = INFINITY;
    const auto offer = [&](Position p, Position q) {
        const Position by = p - q;
        const double square = dot(by, by);
        if (square < least) {
            least = square;
            best.on_first = p;
            best.on_second = q;
        }
    };
    offer(first.a, point_at(second, -fw * per_ff));
    offer(first.b, point_at(second, (ef - fw) * per_ff));
    offer(point_at(first, ew * per_ee), second.a);
    offer(point_at(first, (ew + ef) * per_ee), second.b);
    const double turn = cross(e, f);
    const double s = cross(w, f);  // of the lines' common point, times `turn`
    const double t = cross(w, e);
    const double size = turn * turn;
    const bool do_cross =
        turn != 0.0 && s * turn >= 0.0 && s * turn <= size && t * turn >= 0.0 && t * turn <= size;
    if (do_cross) return {0.0, {0.0, 0.0}, best.on_first, best.on_first};
    best.distance_m = std::sqrt(least);
    const double per_distance = best.distance_m > 0.0 ? 1.0 / best.distance_m : 0.0;
    best.normal = along<Direction>(best.on_first - best.on_second, per_distance);
    return best;
}

}  // namespace touchline
