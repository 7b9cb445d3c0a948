// Crossings as a map has them: on its nanometre grid, in whole numbers.
// Threads: pure functions, O(1).
#pragma once

#include "vision/simplify/segment_grid.h"

#include <cmath>
#include <cstdint>

namespace touchline {

/// A point where a map will have it.
struct GridPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

[[nodiscard]] inline GridPoint on_map_grid(cv::Point2d p_mm) {
    constexpr double kNanometres = 1e6;  // per millimetre
    return {std::llround(kNanometres * p_mm.x), std::llround(kNanometres * p_mm.y)};
}

/// Returns on which side of a b the point c lies; exact within an area of a metre.
[[nodiscard]] inline int side_of(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    const std::int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// Returns whether two segments cross once their points are on the grid; false if they only touch.
[[nodiscard]] inline bool cross_on_map_grid(const LineSegment& s, const LineSegment& t) {
    const GridPoint a = on_map_grid(s.a);
    const GridPoint b = on_map_grid(s.b);
    const GridPoint c = on_map_grid(t.a);
    const GridPoint d = on_map_grid(t.b);
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

}  // namespace touchline
