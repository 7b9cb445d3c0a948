// The band along the upper edge: the titles that lead to the screen, its own title, and the place
// in its list. Threads: one at a time per Canvas.
#pragma once

#include "app/screen/turned_text.h"
#include "app/visit/screen_model.h"

#include <string>

#include <cairo.h>

namespace touchline {

struct HeaderLayout {
    Rect rect;
    TextSizes sizes;
    TurnedText title;
    std::string way;  // before the title, if there is room for both; else empty
    PixelPoint way_at;
};

/// Lays out everything except the place in the list, for which it leaves the room that the
/// longest one needs.
[[nodiscard]] HeaderLayout lay_out_header(cairo_t* cr, const SpokenScreen& screen, const Rect& rect,
                                          const TextSizes& sizes, const Language& language);

/// Fills the band.
void paint_header(cairo_t* cr, const HeaderLayout& layout, const SpokenScreen& screen,
                  std::size_t page, const Palette& palette, const Language& language);

}  // namespace touchline
