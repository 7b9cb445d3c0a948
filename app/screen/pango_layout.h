// Pango's objects, owned, in the screen's font. Only for sources that draw text.
// Threads: one at a time per Canvas.
#pragma once

#include <memory>

#include <pango/pangocairo.h>

namespace touchline {

struct PangoDeleter {
    void operator()(PangoLayout* layout) const { g_object_unref(layout); }

    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }

    void operator()(PangoAttrList* list) const { pango_attr_list_unref(list); }

    void operator()(char* text) const { g_free(text); }
};

using PangoLayoutPtr = std::unique_ptr<PangoLayout, PangoDeleter>;

/// An empty layout whose capital H is `cap_px` high, whatever the font.
[[nodiscard]] PangoLayoutPtr layout_of_cap(cairo_t* cr, double cap_px, bool is_bold);

}  // namespace touchline
