#include "app/screen/paint.h"

#include "app/screen/marks.h"

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

void stroke_rect(cairo_t* cr, const Rect& rect, double width_px, Colour colour) {
    cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue);
    cairo_set_line_width(cr, width_px);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_MITER);
    cairo_rectangle(cr, rect.x + width_px / 2.0, rect.y + width_px / 2.0, rect.width - width_px,
                    rect.height - width_px);
    cairo_stroke(cr);
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
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const PixelLine line = rendered_path(curves, piece, level, view);
        paint_lines(cr, {&line, 1}, width_px, paint);
    }
}

void paint_path(cairo_t* cr, const View& view, std::span<const Position> path, double width_px,
                const Paint& paint) {
    PixelLine line;
    for (const Position& p : path) {
        if (is_finite(p)) line.push_back(view.to_px(p));
    }
    paint_lines(cr, {&line, 1}, width_px, paint);
}

void paint_forces(cairo_t* cr, const View& view, std::span<const ForceMark> marks, double px_per_N,
                  double width_px) {
    constexpr double least_N = 0.02;
    for (const ForceMark& mark : marks) {
        if (!(norm(mark.force) >= least_N) || !is_finite(mark.at)) continue;
        paint_lines(cr, force_arrow(view.to_px(mark.at), mark.force, px_per_N, width_px), width_px,
                    {white_on_black.force});
    }
}

void paint_lines(cairo_t* cr, std::span<const PixelLine> lines, double width_px,
                 const Paint& paint) {
    set_pen(cr, width_px, paint);
    cairo_new_path(cr);
    for (const PixelLine& line : lines) {
        cairo_new_sub_path(cr);
        for (const PixelPoint p : line) cairo_line_to(cr, p.x, p.y);
    }
    cairo_stroke(cr);
}

}  // namespace touchline
