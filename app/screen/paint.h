// The map, the hand's path and its forces, painted with Cairo: for the still layer of the kiosk
// window and for the picture that a tour leaves.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/layout.h"
#include "app/screen/theme.h"
#include "config/types/vec2.h"
#include "haptics/curve/curve_set.h"

#include <span>

namespace touchline {

void fill(cairo_t* cr, const Rect& rect, const Paint& paint);

/// The edge of the drawing area.
void paint_frame(cairo_t* cr, const Rect& rect, double width_px,
                 Colour colour = white_on_black.frame);

/// The picture, dimmed, centred in the drawing area as large as it fits.
void paint_picture(cairo_t* cr, const View& view, const Area& area, const Canvas& picture,
                   double alpha = white_on_black.picture_alpha);

/// A frame of the camera, as bright as it is, centred in `rect` as large as it fits.
void paint_preview(cairo_t* cr, const Rect& rect, const Canvas& frame);

/// Every piece as rendered at `level`. O(segments).
void paint_outlines(cairo_t* cr, const View& view, const CurveSet& curves, double level,
                    double width_px, const Paint& paint);

/// A path through points of W. Points that are not finite are left out.
void paint_path(cairo_t* cr, const View& view, std::span<const Position> path, double width_px,
                const Paint& paint);

/// A force where it acts.
struct ForceMark {
    Position at;
    Force force;
};

/// Arrows of px_per_N pixels for a newton, pointing the way the hand is pushed; forces under
/// 0.02 N are left out.
void paint_forces(cairo_t* cr, const View& view, std::span<const ForceMark> marks, double px_per_N,
                  double width_px);

void paint_stroke(cairo_t* cr, PixelPoint from, PixelPoint to, double width_px, const Paint& paint);

/// An arrow from one point of the screen to another.
void paint_arrow(cairo_t* cr, PixelPoint from, PixelPoint to, double width_px, const Paint& paint);

}  // namespace touchline
