// The upright rectangle around points of the picture frame W. Threads: values.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <algorithm>
#include <limits>

namespace touchline {

/// From `low` to `high`; without a point these are infinite, and `low` is beyond `high`.
struct Extent {
    Position low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Position high = -low;

    void add(Position p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }

    void add(const Outline& outline) {
        for (const Position& p : outline.points) add(p);
    }

    [[nodiscard]] bool is_finite() const { return touchline::is_finite(high - low); }

    [[nodiscard]] Position middle() const { return low + 0.5 * (high - low); }
};

/// O(points).
[[nodiscard]] inline Extent extent_of(const Outline& outline) {
    Extent extent;
    extent.add(outline);
    return extent;
}

/// Of all outlines, without the labels. O(points).
[[nodiscard]] inline Extent extent_of(const TactileMap& map) {
    Extent extent;
    for (const Outline& outline : map.outlines) extent.add(outline);
    return extent;
}

}  // namespace touchline
