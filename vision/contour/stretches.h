// Cuts a line into stretches by where its points lie. Threads: pure function.
#pragma once

#include "vision/contour/chain.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace touchline {

/// Calls `add(Chain, place)` for every longest stretch of a line whose points have one place by
/// `place_of(point)`. Stretches are open, except for a closed line with a single place. A closed
/// line must have points. O(points).
template <class PlaceOf, class Add>
void cut_by_place(const Chain& line, PlaceOf place_of, Add add) {
    std::vector<EdgePoint> points = line.points;
    const auto is_first = [&](std::size_t i) {
        return place_of(points[i]) != place_of(points[(i + points.size() - 1) % points.size()]);
    };
    if (line.is_closed) {
        std::size_t start = 0;
        while (start < points.size() && !is_first(start)) {
            ++start;
        }
        if (start == points.size()) {
            return add(line, place_of(points.front()));
        }
        std::ranges::rotate(points, points.begin() + static_cast<std::ptrdiff_t>(start));
    }
    for (std::size_t first = 0; first < points.size();) {
        std::size_t last = first;
        while (last + 1 < points.size() && place_of(points[last + 1]) == place_of(points[first])) {
            ++last;
        }
        const auto at = [&](std::size_t i) {
            return points.begin() + static_cast<std::ptrdiff_t>(i);
        };
        add(Chain{{at(first), at(last + 1)}, false, line.width_px, line.of},
            place_of(points[first]));
        first = last + 1;
    }
}

}  // namespace touchline
