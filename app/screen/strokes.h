// Moving marks as a list of vertices: lines with round ends, dots, rings and arrows. One shader
// draws them all (stroke_renderer.h); this file knows no OpenGL.
// Threads: plain values.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/theme.h"

#include <array>
#include <cstdint>
#include <vector>

namespace touchline {

/// A corner of the rectangle around a stroke. (along, across) is its place in the stroke's own
/// axes, from the stroke's first end. The fragment shader rounds the ends and smooths the rim.
struct StrokeVertex {
    float x = 0.0F, y = 0.0F;           // on the screen (px)
    float along = 0.0F, across = 0.0F;  // px
    float length = 0.0F;                // between the ends (px)
    float half_width = 0.0F;            // px
    std::array<std::uint8_t, 4> rgba{};
};

class Strokes {
  public:
    static constexpr int vertices_per_stroke = 6;  // two triangles

    void clear() { vertices_.clear(); }

    /// Adds a line with round ends; a dot if a = b. Adds nothing if an end is not finite.
    void add_line(PixelPoint a, PixelPoint b, double width_px, const Paint& paint);

    void add_dot(PixelPoint centre, double radius_px, const Paint& paint) {
        add_line(centre, centre, 2.0 * radius_px, paint);
    }

    void add_ring(PixelPoint centre, double radius_px, double width_px, const Paint& paint);

    /// Adds an arrow with a head; nothing if it is shorter than a pixel.
    void add_arrow(PixelPoint from, PixelPoint to, double width_px, const Paint& paint);

    [[nodiscard]] const std::vector<StrokeVertex>& vertices() const { return vertices_; }

  private:
    std::vector<StrokeVertex> vertices_;
};

}  // namespace touchline
