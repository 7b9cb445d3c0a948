#include "app/screen/pango_layout.h"

namespace touchline {

namespace {

// Andika keeps l, I and 1 apart and has wide coverage; the others come with every Debian.
constexpr const char* families = "Andika, Noto Sans, DejaVu Sans, sans-serif";

PangoLayoutPtr layout_of_size(cairo_t* cr, double size_px, bool is_bold) {
    PangoLayoutPtr layout(pango_cairo_create_layout(cr));
    const std::unique_ptr<PangoFontDescription, PangoDeleter> font(pango_font_description_new());
    pango_font_description_set_family_static(font.get(), families);
    pango_font_description_set_absolute_size(font.get(), size_px * PANGO_SCALE);
    if (is_bold) pango_font_description_set_weight(font.get(), PANGO_WEIGHT_BOLD);
    pango_layout_set_font_description(layout.get(), font.get());
    return layout;
}

/// The font size whose capital H is `cap_px` high, whatever the font.
double font_size_px(cairo_t* cr, double cap_px) {
    constexpr double probe_px = 100.0;
    const PangoLayoutPtr layout = layout_of_size(cr, probe_px, false);
    pango_layout_set_text(layout.get(), "H", 1);
    PangoRectangle ink;
    pango_layout_get_pixel_extents(layout.get(), &ink, nullptr);
    return ink.height > 0 ? probe_px * cap_px / ink.height : cap_px / 0.7;
}

}  // namespace

PangoLayoutPtr layout_of_cap(cairo_t* cr, double cap_px, bool is_bold) {
    return layout_of_size(cr, font_size_px(cr, cap_px), is_bold);
}

}  // namespace touchline
