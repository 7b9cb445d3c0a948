// Marks over the picture: what they look like, as lines that Cairo (paint.h) and OpenGL
// (gl_drawing.h) draw alike, and those that move as vertices. Knows no OpenGL.
// Threads: values and pure functions.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/theme.h"
#include "config/types/hand_state.h"
#include "haptics/collision/collision_tree.h"
#include "haptics/curve/curve_set.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline {

/// Points joined by lines with round ends and corners.
using PixelLine = std::vector<PixelPoint>;

/// A piece at `level`, closed if the piece is. Leaves out points less than two pixels from the last
/// one kept, but never an end: nobody sees them, and a traced photograph has tens of thousands.
/// O(segments).
[[nodiscard]] PixelLine rendered_path(const CurveSet& curves, int piece, double level,
                                      const View& view);

/// An arrow with a head for lines of this width: the shaft with one barb, and the other barb. Empty
/// if it is shorter than a pixel or its length is NaN.
[[nodiscard]] std::vector<PixelLine> arrow(PixelPoint from, PixelPoint to, double width_px);

/// The arrow of a force, which points the way the hand is pushed.
[[nodiscard]] std::vector<PixelLine> force_arrow(PixelPoint from, const Force& force,
                                                 double px_per_N, double width_px);

/// A corner of the rectangle around a stroke. (along, across) is its place in the stroke's own
/// axes, from the stroke's first end. The fragment shader rounds the ends and smooths the rim.
struct StrokeVertex {
    float x = 0.0F, y = 0.0F;           // on the screen (px)
    float along = 0.0F, across = 0.0F;  // px
    float length = 0.0F;                // between the ends (px)
    float half_width = 0.0F;            // px
    std::array<std::uint8_t, 4> rgba{};

    friend bool operator==(const StrokeVertex&, const StrokeVertex&) = default;
};

class Strokes {
  public:
    static constexpr int vertices_per_stroke = 6;  // two triangles

    void clear() { vertices_.clear(); }

    /// Adds a line with round ends; a dot if a = b. Adds nothing if an end is not finite.
    void add_line(PixelPoint a, PixelPoint b, double width_px, const Paint& paint);

    /// Adds the lines one after the other.
    void add(std::span<const PixelLine> lines, double width_px, const Paint& paint);

    [[nodiscard]] const std::vector<StrokeVertex>& vertices() const { return vertices_; }

  private:
    std::vector<StrokeVertex> vertices_;
};

/// All pieces as rendered at `level`. O(segments).
void add_outlines(Strokes& strokes, const View& view, const CurveSet& curves, double level,
                  double width_px, const Palette& palette = white_on_black);

/// The edges of the boxes.
void add_boxes(Strokes& strokes, const View& view, std::span<const ErrorBox> boxes, double width_px,
               const Palette& palette = white_on_black);

/// Handle (ring), proxy (a disc of its radius, or the held shape), the spring between them and the
/// force on the hand (an arrow from the handle). The shapes differ, so nobody has to tell colours
/// apart. `unit_px`: width of a thin line.
void add_hand(Strokes& strokes, const View& view, const HandState& hand, double proxy_radius_m,
              double unit_px, const Palette& palette = white_on_black);

/// A stroke of the pen (W) that is not finished; a dot if it has one point. Leaves out points less
/// than two pixels from the last one kept. O(points).
void add_pen(Strokes& strokes, const View& view, std::span<const Position> stroke_W,
             double width_px, const Palette& palette = white_on_black);

/// Draws it bold where lines hold it, thin where the hand wants it, and its torque as an arc with a
/// head around the handle: a third of a turn for 15 mN m. Draws nothing for a point.
void add_shape(Strokes& strokes, const View& view, const HandState& hand, double unit_px,
               const Palette& palette);

}  // namespace touchline
