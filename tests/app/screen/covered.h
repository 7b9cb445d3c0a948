// Which pixels strokes cover, as the shader fills them.
#pragma once

#include "app/screen/marks.h"

#include <algorithm>
#include <cmath>

namespace touchline {

inline const View view{10'000.0, {580.0, 420.0}};

inline int stroke_count(const Strokes& strokes) {
    return static_cast<int>(strokes.vertices().size()) / Strokes::vertices_per_stroke;
}

/// Returns true if the shader would fill the pixel at p for some stroke of this colour.
inline bool covers(const Strokes& strokes, PixelPoint p, Colour colour) {
    const auto& vertices = strokes.vertices();
    for (std::size_t i = 0; i < vertices.size(); i += Strokes::vertices_per_stroke) {
        const StrokeVertex& first = vertices[i];
        const StrokeVertex& second = vertices[i + 1];
        if (first.rgba[0] != std::lround(255.0 * colour.red)) continue;
        if (first.rgba[2] != std::lround(255.0 * colour.blue)) continue;
        const PixelPoint corner{first.x, first.y};
        const Direction ahead = direction_of(PixelPoint{second.x, second.y} - corner);
        const PixelPoint from_corner = p - corner;
        const double along_px = dot(from_corner, ahead) + double{first.along};
        const double across_px = dot(from_corner, left_of(ahead)) + double{first.across};
        const double beyond = std::max({-along_px, along_px - double{first.length}, 0.0});
        if (std::hypot(beyond, across_px) <= double{first.half_width}) return true;
    }
    return false;
}

}  // namespace touchline
