// The picture of a tour: map, path of the hand, forces, and the result in words.
// Threads: pure functions.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/paint.h"
#include "haptics/collision/scene.h"

#include <string>
#include <vector>

namespace touchline {

/// A stretch of the path without a break.
struct TourStretch {
    bool is_lifted = false;  // nothing is felt
    std::vector<Position> handle;
    std::vector<Position> proxy;
};

struct TourFigure {
    std::string title;
    std::vector<std::string> lines;  // the result in words
    std::vector<TourStretch> way;
    std::vector<ForceMark> forces;  // few enough to be told apart
};

/// Paints 1600 px wide: the drawing area above, legend and words below. `picture` comes from
/// canvas_of().
[[nodiscard]] Canvas paint_tour(const TourFigure& figure, const Scene& scene,
                                const Canvas& picture);

}  // namespace touchline
