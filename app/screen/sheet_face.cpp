#include "app/screen/page_marks.h"
#include "app/screen/paint.h"
#include "app/screen/sheet.h"

#include <algorithm>
#include <utility>

namespace touchline {

namespace {

void add_page(SheetFace& face, const PagedPart& part, std::size_t page, double cap_px) {
    for (const PlacedPhrase& placed : part.pages.at(page).phrases) {
        const Phrase& phrase = placed.phrase;
        face.lines.push_back({PixelPoint{part.rect.x, part.rect.y} + placed.at,
                              {cap_px, phrase.is_bold},
                              phrase.width_px,
                              phrase.text,
                              phrase.mark,
                              part.rect});
    }
}

/// Puts it at the right end of its row, or at the left.
void add_mark(SheetFace& face, cairo_t* cr, const Rect& row, LineStyle style, bool is_right,
              std::string words) {
    if (words.empty()) return;
    const double width_px = line_width_px(cr, style, words);
    const double x_px = is_right ? row.x + row.width - width_px : row.x;
    face.lines.push_back({{x_px, row.y}, style, width_px, std::move(words), {}, row});
}

void add_list_marks(SheetFace& face, cairo_t* cr, const SheetLayout& layout,
                    const SpokenScreen& screen, std::size_t page, const Language& language) {
    const LineStyle style{layout.sizes.mark_px};
    const std::string place =
        screen.focus ? place_words(*screen.focus, screen.items.size(), language) : std::string{};
    const std::string pages = page_words(page, layout.list.pages.size(), language);
    Rect row = layout.list.marks;
    row.height = line_height_px(style.cap_px);
    add_mark(face, cr, row, style, false, place);
    if (!are_beside(cr, row.width, style, place, pages)) row.y += row.height;
    add_mark(face, cr, row, style, true, pages);
}

/// The frame around the item's part on the page.
std::optional<Rect> frame_of(const PagedPart& part, std::size_t page, std::size_t item) {
    for (const PlacedItem& placed : part.pages.at(page).items) {
        if (placed.item != item) continue;
        return Rect{part.rect.x, part.rect.y + placed.top_px, part.rect.width, placed.height_px};
    }
    return std::nullopt;
}

void fill_triangle(cairo_t* cr, PixelPoint tip, PixelPoint base, double half_height_px,
                   Colour colour) {
    cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue);
    cairo_move_to(cr, tip.x, tip.y);
    cairo_line_to(cr, base.x, base.y - half_height_px);
    cairo_line_to(cr, base.x, base.y + half_height_px);
    cairo_close_path(cr);
    cairo_fill(cr);
}

void stroke_rect(cairo_t* cr, const Rect& rect, double width_px, Colour colour) {
    cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue);
    cairo_set_line_width(cr, width_px);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_MITER);
    cairo_rectangle(cr, rect.x + width_px / 2.0, rect.y + width_px / 2.0, rect.width - width_px,
                    rect.height - width_px);
    cairo_stroke(cr);
}

/// Paints the shape that tells how a value can be changed.
void paint_mark(cairo_t* cr, const FaceLine& line, Colour colour) {
    const double cap_px = line.style.cap_px;
    const double middle_px = line.at.y + line_height_px(cap_px) / 2.0;
    const double right_px = line.at.x + line.width_px;
    const double near_px = 0.35 * cap_px;
    const double far_px = 0.85 * cap_px;
    const bool is_setting = line.mark == PhraseMark::arrows;
    if (is_setting || line.mark == PhraseMark::left_arrow)
        fill_triangle(cr, {line.at.x - far_px, middle_px}, {line.at.x - near_px, middle_px},
                      0.4 * cap_px, colour);
    if (is_setting || line.mark == PhraseMark::right_arrow)
        fill_triangle(cr, {right_px + far_px, middle_px}, {right_px + near_px, middle_px},
                      0.4 * cap_px, colour);
    if (line.mark == PhraseMark::frame) {
        const double height_px = 1.85 * cap_px;
        stroke_rect(cr,
                    {line.at.x - 0.5 * cap_px, middle_px - height_px / 2.0, line.width_px + cap_px,
                     height_px},
                    std::max(0.07 * cap_px, 1.0), colour);
    }
}

void paint_focus(cairo_t* cr, const SheetLayout& layout, const Rect& frame, Colour colour) {
    const double cap_px = layout.sizes.cap_px;
    stroke_rect(cr, frame, focus_width_px(layout.sizes), colour);
    const double left_px = frame.x + layout.list.inset_px;
    const double middle_px = frame.y + layout.list.inset_px +
                             line_height_px(cap_px) / 2.0;  // the middle of the first row
    fill_triangle(cr, {left_px + 0.85 * cap_px, middle_px}, {left_px + 0.1 * cap_px, middle_px},
                  0.55 * cap_px, colour);
}

}  // namespace

double focus_width_px(const TextSizes& sizes) {
    return std::max(0.2 * sizes.cap_px, 4.0);
}

SheetFace face_of(cairo_t* cr, const SheetLayout& layout, const SpokenScreen& screen,
                  const SheetPages& pages, const Language& language) {
    SheetFace face;
    add_page(face, layout.text, pages.text, layout.sizes.cap_px);
    add_mark(face, cr, layout.text.marks, {layout.sizes.mark_px}, true,
             page_words(pages.text, layout.text.pages.size(), language));
    if (screen.items.empty()) return face;
    add_page(face, layout.list, pages.list, layout.sizes.cap_px);
    add_list_marks(face, cr, layout, screen, pages.list, language);
    if (screen.focus) face.focus = frame_of(layout.list, pages.list, *screen.focus);
    return face;
}

void paint_sheet(cairo_t* cr, const SheetLayout& layout, const SheetFace& face,
                 const Palette& palette) {
    fill(cr, layout.rect, {palette.background});
    for (const FaceLine& line : face.lines) {
        paint_line(cr, line.at, line.style, palette.text, line.text);
        paint_mark(cr, line, palette.text);
    }
    if (face.focus) paint_focus(cr, layout, *face.focus, palette.focus);
}

}  // namespace touchline
