// Pictograms that exist as strokes and as filled shapes, with known middle lines.
// Threads: pure functions.
#pragma once

#include "tests/vision/pictures/canvas.h"

#include <string>
#include <vector>

namespace touchline::testing {

/// Lies on a square of 24 units. The first line is closed; filled, it is the shape.
struct Pictogram {
    std::string name;
    std::vector<Polyline> lines;
};

/// Returns twenty-five pictograms: house, heart, star, bell, key, ...
[[nodiscard]] std::vector<Pictogram> pictograms();

/// Returns the greatest distance from any point of `from` to the nearest of `to`; infinite if `to`
/// is empty.
[[nodiscard]] double farthest_px(const std::vector<Polyline>& from,
                                 const std::vector<Polyline>& to);

}  // namespace touchline::testing
