// The lines of a picture, few enough to be drawn small beside its name. Threads: immutable values;
// painting: one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "config/types/tactile_map.h"

#include <memory>
#include <vector>

#include <cairo.h>

namespace touchline {

struct LineDrawing {
    Area area;
    std::vector<std::vector<Position>> lines;  // a closed one ends where it begins
};

using LineDrawingPtr = std::shared_ptr<const LineDrawing>;

/// Keeps the shape of all outlines with some 300 points, and two more for each. O(points).
[[nodiscard]] LineDrawing line_drawing(const TactileMap& map);

/// Paints them as large as fits in the rectangle.
void paint_line_drawing(cairo_t* cr, const Rect& rect, const LineDrawing& picture, double width_px,
                        Colour colour);

}  // namespace touchline
