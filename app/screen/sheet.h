// Draws text and items of a screen of the model, side by side or one below the other, each in its
// own pages, so that the item with the focus is always visible and every word can be read.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/line_drawing.h"
#include "app/screen/pages.h"
#include "app/screen/text.h"
#include "app/visit/screen_model.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <cairo.h>

namespace touchline {

/// A part in pages.
struct PagedPart {
    Rect rect;  // of each page
    Rect bar;   // below the pages; height 0: there is one page
    double inset_px = 0.0;
    std::vector<SheetPage> pages = std::vector<SheetPage>(1);
};

struct SheetLayout {
    Rect rect;
    TextSizes sizes;
    PagedPart text;
    PagedPart list;
    double picture_px = 0.0;  // width of the small picture before each name; 0: there are none
};

/// Lays out everything except the focus, which changes no place. O(items); some 50 us per item.
[[nodiscard]] SheetLayout lay_out_sheet(cairo_t* cr, const SpokenScreen& screen, const Rect& rect,
                                        const TextSizes& sizes, bool has_pictures);

/// The pages shown.
struct SheetPages {
    std::size_t text = 0;
    std::size_t list = 0;

    friend bool operator==(const SheetPages&, const SheetPages&) = default;
};

/// The text turns pages by itself; the list shows the page with the focus. `screen_ns`, `focus_ns`:
/// time since the screen came and since the focus moved.
[[nodiscard]] SheetPages sheet_pages(const SheetLayout& layout, std::optional<std::size_t> focus,
                                     std::int64_t screen_ns, std::int64_t focus_ns);

/// A line of a sheet's face, in the screen's pixels.
struct FaceLine {
    PixelPoint at;  // upper left corner of its box
    LineStyle style;
    double width_px = 0.0;
    std::string text;
    PhraseMark mark = PhraseMark::none;
    Rect part;  // the rectangle that contains it
};

/// The place of an item's small picture.
struct FacePicture {
    std::size_t item = 0;
    Rect rect;
};

/// Everything that a sheet shows.
struct SheetFace {
    SheetPages pages;
    std::vector<FaceLine> lines;
    std::vector<FacePicture> pictures;
    std::optional<Rect> focus;  // its frame
    bool is_turning = false;    // Up and Down change the value in the frame
};

[[nodiscard]] SheetFace face_of(const SheetLayout& layout, const SpokenScreen& screen,
                                const SheetPages& pages);

/// The thickness of the focus frame.
[[nodiscard]] double focus_width_px(const TextSizes& sizes);

/// Fills the layout's rectangle. `pictures`: of each item, null where it has none; may be empty.
void paint_sheet(cairo_t* cr, const SheetLayout& layout, const SheetFace& face,
                 const std::vector<LineDrawingPtr>& pictures, const Palette& palette);

}  // namespace touchline
