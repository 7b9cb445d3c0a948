// A screen of the model as it is drawn: text above, items below, each in pages of its own, so that
// the item with the focus is always there and every word can be read.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/arrangement.h"
#include "app/screen/pages.h"
#include "app/screen/text_lines.h"
#include "app/session/screen_model.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <cairo.h>

namespace touchline {

/// Pages of text within their place, and the place of what is said about them.
struct PagedPart {
    Rect rect;
    Rect marks;  // below it; height 0: one page, and nothing to say
    double inset_px = 0.0;
    std::vector<SheetPage> pages = std::vector<SheetPage>(1);
};

struct SheetLayout {
    Rect rect;
    TextSizes sizes;
    PagedPart text;
    PagedPart list;
};

/// Lays out all but the focus, which changes no place. O(items); some 50 us an item.
[[nodiscard]] SheetLayout lay_out_sheet(cairo_t* cr, const SpokenScreen& screen, const Rect& rect,
                                        const TextSizes& sizes, const Language& language);

/// Which pages are shown.
struct SheetPages {
    std::size_t text = 0;
    std::size_t list = 0;

    friend bool operator==(const SheetPages&, const SheetPages&) = default;
};

/// Text turns by itself; the list shows the page of the focus. Times since the screen came and
/// since the focus moved.
[[nodiscard]] SheetPages sheet_pages(const SheetLayout& layout, std::optional<std::size_t> focus,
                                     std::int64_t screen_ns, std::int64_t focus_ns);

/// A line of the face of a sheet, on the screen.
struct FaceLine {
    PixelPoint at;  // upper left corner of its box
    LineStyle style;
    double width_px = 0.0;
    std::string text;
    PhraseMark mark = PhraseMark::none;
    Rect part;  // what it must not leave
};

/// Everything that a sheet shows.
struct SheetFace {
    std::vector<FaceLine> lines;
    std::optional<Rect> focus;  // its frame
};

[[nodiscard]] SheetFace face_of(cairo_t* cr, const SheetLayout& layout, const SpokenScreen& screen,
                                const SheetPages& pages, const Language& language);

/// How thick the frame of the focus is.
[[nodiscard]] double focus_width_px(const TextSizes& sizes);

/// Fills the rectangle of the layout.
void paint_sheet(cairo_t* cr, const SheetLayout& layout, const SheetFace& face,
                 const Palette& palette);

}  // namespace touchline
