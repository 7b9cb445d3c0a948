// The picture that a tour leaves: map, way of the hand, forces, and what it came to in words.
// Threads: pure functions.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/paint.h"
#include "haptics/collision/scene.h"

#include <string>
#include <vector>

namespace touchline {

/// A stretch of the way without a break.
struct TourStretch {
    bool is_lifted = false;  // nothing is felt
    std::vector<Position> handle;
    std::vector<Position> proxy;
};

struct TourFigure {
    std::string title;
    std::vector<std::string> lines;  // what it came to
    std::vector<TourStretch> way;
    std::vector<ForceMark> forces;  // few enough to be told apart
};

/// 1600 px wide: the drawing area above, legend and words below. `picture` is as from canvas_of().
[[nodiscard]] Canvas paint_tour(const TourFigure& figure, const Scene& scene,
                                const Canvas& picture);

}  // namespace touchline
