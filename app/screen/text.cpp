#include "app/screen/text.h"

#include "app/screen/pango_layout.h"

#include <cmath>
#include <string>

namespace touchline {

namespace {

guint16 channel(double share) {
    return static_cast<guint16>(std::lround(65535.0 * share));
}

void add_attribute(PangoAttrList* list, PangoAttribute* attribute, std::size_t from,
                   std::size_t to) {
    attribute->start_index = static_cast<guint>(from);
    attribute->end_index = static_cast<guint>(to);
    pango_attr_list_insert(list, attribute);  // takes ownership
}

PangoLayoutPtr lay_out_text(cairo_t* cr, double width_px, double cap_px,
                            std::span<const TextRun> runs) {
    PangoLayoutPtr layout = layout_of_cap(cr, cap_px, false);
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
    const PangoLayoutPtr layout = lay_out_text(cr, width_px, cap_px, runs);
    cairo_move_to(cr, at.x, at.y);
    pango_cairo_show_layout(cr, layout.get());
    return height_of(layout.get());
}

double text_height_px(cairo_t* cr, double width_px, double cap_px, std::span<const TextRun> runs) {
    return height_of(lay_out_text(cr, width_px, cap_px, runs).get());
}

}  // namespace touchline
