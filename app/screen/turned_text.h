// A text in a box of one size: in letters as large as its room allows, and in pages that turn by
// themselves where even the smallest letters have no room.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/pages.h"
#include "app/screen/text.h"

#include <string>
#include <vector>

#include <cairo.h>

namespace touchline {

struct TurnedText {
    Rect rect;
    LineStyle style;
    std::vector<SheetPage> pages = std::vector<SheetPage>(1);
};

/// `most`: the style if there is room; its letters shrink to `least_px` before there are pages.
[[nodiscard]] TurnedText turned_text(cairo_t* cr, const std::string& text, const Rect& rect,
                                     LineStyle most, double least_px);

void paint_turned(cairo_t* cr, const TurnedText& text, std::size_t page, Colour colour);

/// The height of a bar that tells which page is shown.
[[nodiscard]] double bar_height_px(const TextSizes& sizes);

/// Paints a bar along the upper edge of `rect`: its whole width is all pages, its thick part is the
/// one that is shown. Paints nothing for a single page.
void paint_page_bar(cairo_t* cr, const Rect& rect, std::size_t page, std::size_t pages,
                    const TextSizes& sizes, const Palette& palette);

}  // namespace touchline
