#include "app/screen/text.h"

#include <cmath>
#include <memory>

#include <pango/pangocairo.h>

namespace touchline {

namespace {

// Andika keeps l, I and 1 apart and has wide coverage; then what every Debian has.
constexpr const char* families = "Andika, Noto Sans, DejaVu Sans, sans-serif";

struct PangoDeleter {
    void operator()(PangoLayout* layout) const { g_object_unref(layout); }

    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }

    void operator()(PangoAttrList* list) const { pango_attr_list_unref(list); }

    void operator()(char* text) const { g_free(text); }
};

using Layout = std::unique_ptr<PangoLayout, PangoDeleter>;

Layout layout_of_size(cairo_t* cr, double size_px) {
    Layout layout(pango_cairo_create_layout(cr));
    std::unique_ptr<PangoFontDescription, PangoDeleter> font(pango_font_description_new());
    pango_font_description_set_family_static(font.get(), families);
    pango_font_description_set_absolute_size(font.get(), size_px * PANGO_SCALE);
    pango_layout_set_font_description(layout.get(), font.get());
    return layout;
}

/// Font size at which a capital H is `cap_px` high, whatever the font.
double font_size_px(cairo_t* cr, double cap_px) {
    constexpr double probe_px = 100.0;
    const Layout layout = layout_of_size(cr, probe_px);
    pango_layout_set_text(layout.get(), "H", 1);
    PangoRectangle ink;
    pango_layout_get_pixel_extents(layout.get(), &ink, nullptr);
    return ink.height > 0 ? probe_px * cap_px / ink.height : cap_px / 0.7;
}

guint16 channel(double share) {
    return static_cast<guint16>(std::lround(65535.0 * share));
}

void add_attribute(PangoAttrList* list, PangoAttribute* attribute, std::size_t from,
                   std::size_t to) {
    attribute->start_index = static_cast<guint>(from);
    attribute->end_index = static_cast<guint>(to);
    pango_attr_list_insert(list, attribute);  // takes it
}

Layout lay_out_text(cairo_t* cr, double width_px, double cap_px, std::span<const TextRun> runs) {
    Layout layout = layout_of_size(cr, font_size_px(cr, cap_px));
    std::unique_ptr<PangoAttrList, PangoDeleter> attributes(pango_attr_list_new());
    std::string text;
    for (const TextRun& run : runs) {
        const std::unique_ptr<char, PangoDeleter> valid(
            g_utf8_make_valid(run.text.data(), static_cast<gssize>(run.text.size())));
        const std::size_t from = text.size();
        text += valid.get();
        const Colour& c = run.colour;
        add_attribute(attributes.get(),
                      pango_attr_foreground_new(channel(c.red), channel(c.green), channel(c.blue)),
                      from, text.size());
        if (run.is_bold)
            add_attribute(attributes.get(), pango_attr_weight_new(PANGO_WEIGHT_BOLD), from,
                          text.size());
    }
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    pango_layout_set_attributes(layout.get(), attributes.get());
    pango_layout_set_width(layout.get(), static_cast<int>(width_px * PANGO_SCALE));
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    return layout;
}

double height_of(PangoLayout* layout) {
    PangoRectangle logical;
    pango_layout_get_pixel_extents(layout, nullptr, &logical);
    return logical.height;
}

}  // namespace

double paint_text(cairo_t* cr, PixelPoint at, double width_px, double cap_px,
                  std::span<const TextRun> runs) {
    const Layout layout = lay_out_text(cr, width_px, cap_px, runs);
    cairo_move_to(cr, at.x, at.y);
    pango_cairo_show_layout(cr, layout.get());
    return height_of(layout.get());
}

double text_height_px(cairo_t* cr, double width_px, double cap_px, std::span<const TextRun> runs) {
    return height_of(lay_out_text(cr, width_px, cap_px, runs).get());
}

}  // namespace touchline
