// Converts a line to a map's outline. Threads: pure function.
#pragma once

#include "config/types/map_frame.h"
#include "vision/contour/chain.h"

namespace touchline {

/// Converts a line in millimetres of the viewBox, with each place on the map's grid only once. A
/// closed line must have points. O(points).
[[nodiscard]] inline Outline outline_of(const Chain& line, const Area& area) {
    Outline outline;
    outline.is_closed = line.is_closed;
    for (const EdgePoint& point : line.points) {
        const Position p = canonical_point(point.at.x, point.at.y, area);
        if (outline.points.empty() || !(outline.points.back() == p)) {
            outline.points.push_back(p);
        }
    }
    if (outline.is_closed && outline.points.front() == outline.points.back()) {
        outline.points.pop_back();
    }
    return outline;
}

}  // namespace touchline
