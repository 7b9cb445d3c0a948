#include "app/screen/paint.h"

#include "app/screen/rendered_path.h"

#include <algorithm>

namespace touchline {

namespace {

void set_source(cairo_t* cr, const Paint& paint) {
    const Colour& c = paint.colour;
    cairo_set_source_rgba(cr, c.red, c.green, c.blue, paint.alpha);
}

void set_pen(cairo_t* cr, double width_px, const Paint& paint) {
    set_source(cr, paint);
    cairo_set_line_width(cr, width_px);
    cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
}

void line_to(cairo_t* cr, PixelPoint p) {
    cairo_line_to(cr, p.x, p.y);
}

void paint_image(cairo_t* cr, const Rect& rect, const Canvas& image, double alpha) {
    cairo_save(cr);
    cairo_translate(cr, rect.x, rect.y);
    cairo_scale(cr, rect.width / image.width(), rect.height / image.height());
    cairo_set_source_surface(cr, image.surface(), 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_GOOD);
    cairo_rectangle(cr, 0.0, 0.0, image.width(), image.height());
    cairo_clip(cr);
    cairo_paint_with_alpha(cr, alpha);
    cairo_restore(cr);
}

}  // namespace

void fill(cairo_t* cr, const Rect& rect, const Paint& paint) {
    set_source(cr, paint);
    cairo_rectangle(cr, rect.x, rect.y, rect.width, rect.height);
    cairo_fill(cr);
}

void paint_frame(cairo_t* cr, const Rect& rect, double width_px, Colour colour) {
    set_pen(cr, width_px, {colour});
    cairo_rectangle(cr, rect.x, rect.y, rect.width, rect.height);
    cairo_stroke(cr);
}

void paint_picture(cairo_t* cr, const View& view, const Area& area, const Canvas& picture,
                   double alpha) {
    const Area fit = fitted(area, picture.width(), picture.height());
    paint_image(cr, area_rect(fit, view), picture, alpha);
}

void paint_preview(cairo_t* cr, const Rect& rect, const Canvas& frame) {
    const double scale = std::min(rect.width / frame.width(), rect.height / frame.height());
    const double width_px = scale * frame.width();
    const double height_px = scale * frame.height();
    paint_image(cr,
                {rect.x + (rect.width - width_px) / 2.0, rect.y + (rect.height - height_px) / 2.0,
                 width_px, height_px},
                frame, 1.0);
}

void paint_outlines(cairo_t* cr, const View& view, const CurveSet& curves, double level,
                    double width_px, const Paint& paint) {
    set_pen(cr, width_px, paint);
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        cairo_new_path(cr);
        for (const PixelPoint p : rendered_path(curves, piece, level, view)) line_to(cr, p);
        cairo_stroke(cr);
    }
}

void paint_path(cairo_t* cr, const View& view, std::span<const Position> path, double width_px,
                const Paint& paint) {
    set_pen(cr, width_px, paint);
    cairo_new_path(cr);
    for (const Position& p : path) {
        if (is_finite(p)) line_to(cr, view.to_px(p));
    }
    cairo_stroke(cr);
}

void paint_forces(cairo_t* cr, const View& view, std::span<const ForceMark> marks, double px_per_N,
                  double width_px) {
    constexpr double least_N = 0.02;
    for (const ForceMark& mark : marks) {
        if (!(norm(mark.force) >= least_N) || !is_finite(mark.at)) continue;
        const PixelPoint from = view.to_px(mark.at);
        const PixelPoint reach{px_per_N * mark.force.x, -px_per_N * mark.force.y};
        paint_arrow(cr, from, from + reach, width_px, {white_on_black.force});
    }
}

void paint_stroke(cairo_t* cr, PixelPoint from, PixelPoint to, double width_px,
                  const Paint& paint) {
    set_pen(cr, width_px, paint);
    cairo_new_path(cr);
    for (const PixelPoint p : {from, to}) line_to(cr, p);
    cairo_stroke(cr);
}

void paint_arrow(cairo_t* cr, PixelPoint from, PixelPoint to, double width_px, const Paint& paint) {
    set_pen(cr, width_px, paint);
    const Barbs barbs = barbs_of(from, to, 4.0 * width_px);
    cairo_new_path(cr);
    for (const PixelPoint p : {from, to, barbs.left}) line_to(cr, p);
    cairo_move_to(cr, to.x, to.y);
    line_to(cr, barbs.right);
    cairo_stroke(cr);
}

}  // namespace touchline
