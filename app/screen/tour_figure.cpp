#include "app/screen/tour_figure.h"

#include "app/screen/text.h"

#include <algorithm>
#include <array>

namespace touchline {

namespace {

constexpr int figure_width_px = 1600;
constexpr double picture_height_px = 1160.0;
constexpr double figure_margin_px = 40.0;
constexpr double figure_cap_px = 20.0;
constexpr double px_per_N = 60.0;

constexpr double outline_px = 3.5;
constexpr double way_px = 2.0;
constexpr double force_px = 2.0;

constexpr Paint outline_paint{white_on_black.outline};
constexpr Paint handle_paint{white_on_black.handle};
constexpr Paint proxy_paint{white_on_black.proxy};
constexpr Paint lifted_paint{white_on_black.frame};

void paint_map(cairo_t* cr, const TourFigure& figure, const Scene& scene, const Canvas& picture) {
    const View view = view_of(scene.area, {0.0, 0.0, figure_width_px, picture_height_px});
    paint_picture(cr, view, scene.area, picture);
    paint_frame(cr, area_rect(scene.area, view), 1.0);
    paint_outlines(cr, view, scene.curves, 0.0, outline_px, outline_paint);
    for (const TourStretch& stretch : figure.way) {
        paint_path(cr, view, stretch.handle, way_px,
                   stretch.is_lifted ? lifted_paint : handle_paint);
        if (!stretch.is_lifted) paint_path(cr, view, stretch.proxy, way_px, proxy_paint);
    }
    paint_forces(cr, view, figure.forces, px_per_N, force_px);
}

struct LegendEntry {
    const char* words;
    Paint paint;
    double width_px;
    bool is_arrow = false;
};

constexpr std::array legend{
    LegendEntry{"outline", outline_paint, outline_px}, LegendEntry{"handle", handle_paint, way_px},
    LegendEntry{"proxy", proxy_paint, way_px}, LegendEntry{"handle, lifted", lifted_paint, way_px},
    LegendEntry{"force, this long: 1 N", {white_on_black.force}, force_px, true}};

void paint_legend(cairo_t* cr, double top_px) {
    const double column_px =
        (figure_width_px - 2.0 * figure_margin_px) / static_cast<double>(legend.size());
    PixelPoint at{figure_margin_px, top_px};
    for (const LegendEntry& entry : legend) {
        const PixelPoint from = at + PixelPoint{0.0, 0.8 * figure_cap_px};
        const PixelPoint to = from + PixelPoint{px_per_N, 0.0};
        const auto lines =
            entry.is_arrow ? arrow(from, to, entry.width_px) : std::vector<PixelLine>{{from, to}};
        paint_lines(cr, lines, entry.width_px, entry.paint);
        const std::array<TextRun, 1> words{TextRun{entry.words}};
        paint_text(cr, {to.x + 0.7 * figure_cap_px, at.y}, column_px, 0.8 * figure_cap_px, words);
        at.x += column_px;
    }
}

/// Paints title, legend and lines from `top_px` on, or only measures them; returns the lower end.
double paint_words(cairo_t* cr, const TourFigure& figure, double top_px) {
    constexpr double text_width_px = figure_width_px - 2.0 * figure_margin_px;
    PixelPoint at{figure_margin_px, top_px};
    const std::array<TextRun, 1> title{TextRun{figure.title, white_on_black.name, true}};
    at.y += paint_text(cr, at, text_width_px, 1.3 * figure_cap_px, title) + 0.5 * figure_cap_px;
    paint_legend(cr, at.y);
    at.y += 2.5 * figure_cap_px;
    for (const std::string& line : figure.lines) {
        const std::array<TextRun, 1> words{TextRun{line}};
        at.y += paint_text(cr, at, text_width_px, figure_cap_px, words) + 0.3 * figure_cap_px;
    }
    return at.y;
}

}  // namespace

Canvas paint_tour(const TourFigure& figure, const Scene& scene, const Canvas& picture) {
    const Canvas probe(1, 1);
    const double height_px =
        paint_words(probe.context(), figure, picture_height_px) + figure_margin_px;
    Canvas canvas(figure_width_px, static_cast<int>(height_px));
    cairo_t* const cr = canvas.context();
    fill(cr, {0.0, 0.0, figure_width_px, height_px}, {white_on_black.background});
    paint_map(cr, figure, scene, picture);
    paint_words(cr, figure, picture_height_px);
    return canvas;
}

}  // namespace touchline
