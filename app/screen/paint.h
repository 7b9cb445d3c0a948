// Paints the map, the hand's path and its forces with Cairo, for the still layer of the kiosk
// window and for the picture of a tour.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/layout.h"
#include "app/screen/marks.h"
#include "app/screen/theme.h"
#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <span>

namespace touchline {

void fill(cairo_t* cr, const Rect& rect, const Paint& paint);

/// Paints a line of this width along the inner side of the rectangle's edge.
void stroke_rect(cairo_t* cr, const Rect& rect, double width_px, Colour colour);

/// Paints the edge of the drawing area.
void paint_frame(cairo_t* cr, const Rect& rect, double width_px,
                 Colour colour = white_on_black.frame);

/// Paints the picture, dimmed and centred, as large as fits in the drawing area.
void paint_picture(cairo_t* cr, const View& view, const Area& area, const Canvas& picture,
                   double alpha = white_on_black.picture_alpha);

/// Paints a frame of the camera, undimmed and centred, as large as fits in `rect`.
void paint_preview(cairo_t* cr, const Rect& rect, const Canvas& frame);

/// Paints every piece as rendered at `level`. O(segments).
void paint_outlines(cairo_t* cr, const View& view, const CurveSet& curves, double level,
                    double width_px, const Paint& paint);

/// Paints a path through points of W. Leaves out points that are not finite.
void paint_path(cairo_t* cr, const View& view, std::span<const Position> path, double width_px,
                const Paint& paint);

/// A force and where it acts.
struct ForceMark {
    Position at;
    Force force;
};

/// Paints arrows of px_per_N pixels per newton. Leaves out forces under 0.02 N.
void paint_forces(cairo_t* cr, const View& view, std::span<const ForceMark> marks, double px_per_N,
                  double width_px);

/// Paints lines (marks.h) in one stroke.
void paint_lines(cairo_t* cr, std::span<const PixelLine> lines, double width_px,
                 const Paint& paint);

}  // namespace touchline
