#include "tests/app/screen/contact_sheet.h"

#include "app/screen/paint.h"
#include "app/screen/text.h"

#include <algorithm>

namespace touchline {

namespace {

constexpr double name_cap_px = 10.0;
constexpr double line_px = 4.0;

}  // namespace

void paint_at(const Canvas& onto, const Canvas& canvas, PixelPoint at, double scale) {
    cairo_t* const cr = onto.context();
    cairo_save(cr);
    cairo_translate(cr, at.x, at.y);
    cairo_scale(cr, scale, scale);
    cairo_set_source_surface(cr, canvas.surface(), 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_GOOD);
    cairo_paint(cr);
    cairo_restore(cr);
}

Canvas composed(const ScreenLayers& layers, int width_px, int height_px) {
    Canvas screen(width_px, height_px);
    const auto paint_layer = [&screen](const StillLayer& layer) {
        if (layer.rect.width > 0.0)
            paint_at(screen, layer.canvas, {layer.rect.x, layer.rect.y}, 1.0);
    };
    paint_layer(layers.picture());
    const ScreenContent& shown = layers.shown();
    if (layers.has_marks() && shown.shown.scene)
        paint_outlines(screen.context(), layers.view(), shown.shown.scene->curves, 0.0, line_px,
                       {palette_of(shown.palette).outline});
    for (const StillLayer* layer : layers.words()) paint_layer(*layer);
    return screen;
}

Canvas contact_sheet(const std::vector<Thumbnail>& screens, int columns, int width_px) {
    const double name_px = line_height_px(name_cap_px);
    double tallest = 1.0;
    for (const Thumbnail& each : screens) {
        const double scale = static_cast<double>(width_px) / each.canvas.width();
        tallest = std::max(tallest, scale * each.canvas.height());
    }
    const double cell_px = tallest + name_px;
    const int rows = (static_cast<int>(screens.size()) + columns - 1) / columns;
    constexpr int gap_px = 8;
    Canvas sheet(columns * (width_px + gap_px), static_cast<int>(rows * cell_px) + 1);
    fill(sheet.context(),
         {0.0, 0.0, static_cast<double>(sheet.width()), static_cast<double>(sheet.height())},
         {Colour{0.3, 0.3, 0.3}});
    for (std::size_t i = 0; i < screens.size(); ++i) {
        const auto column = static_cast<int>(i) % columns;
        const PixelPoint at{static_cast<double>(column * (width_px + gap_px)),
                            static_cast<int>(i) / columns * cell_px};
        paint_line(sheet.context(), at, {name_cap_px}, Colour{1.0, 1.0, 1.0}, screens[i].name);
        const Canvas& canvas = screens[i].canvas;
        paint_at(sheet, canvas, at + PixelPoint{0.0, name_px},
                 static_cast<double>(width_px) / canvas.width());
    }
    return sheet;
}

}  // namespace touchline
