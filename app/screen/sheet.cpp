#include "app/screen/sheet.h"

#include "app/screen/paint.h"
#include "app/screen/turned_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double widest_caps = 50.0;       // longer lines are hard to follow
constexpr double beside_from_caps = 40.0;  // so wide, text and list stand side by side
constexpr double text_share = 0.38;        // of the width, beside the list
constexpr double margin_caps = 0.5;        // left and right
constexpr double upper_margin_caps = 0.1;  // and below
constexpr double gap_caps = 0.25;          // between text and list, one below the other
constexpr double column_gap_caps = 1.5;    // between them side by side
constexpr double item_gap_caps = 0.1;
constexpr double item_inset_caps = 0.18;  // room for the focus frame
constexpr double pointer_caps = 1.2;      // room for its pointer
constexpr double item_end_caps = 0.6;     // after an item's words: a value's mark, or nothing
constexpr double picture_gap_caps = 0.5;  // after the small picture

std::vector<PhraseRow> rows_of(cairo_t* cr, double width_px, LineStyle style,
                               const std::string& text) {
    std::vector<PhraseRow> rows;
    for (std::string& line : broken_lines(cr, width_px, style, text)) {
        const double line_px = line_width_px(cr, style, line);
        rows.push_back({Phrase{0.0, line_px, std::move(line), style.is_bold, PhraseMark::none}});
    }
    return rows;
}

PhraseMark mark_of(ItemRole role) {
    if (role == ItemRole::toggle) return PhraseMark::frame;
    return role == ItemRole::setting ? PhraseMark::triangles : PhraseMark::none;
}

/// Puts the value at the right end of the name's line if both fit in it, else below the name.
void add_value(std::vector<PhraseRow>& rows, cairo_t* cr, double width_px, double cap_px,
               const ScreenItem& item) {
    if (item.value.empty()) return;
    const PhraseMark mark = mark_of(item.role);
    const double mark_px = mark_room_px(mark, cap_px);
    std::vector<PhraseRow> values = rows_of(cr, width_px - mark_px, {cap_px, true}, item.value);
    for (PhraseRow& row : values) {
        row.front().x_px = mark_px;
        row.front().mark = mark;
    }
    if (rows.size() == 1 && values.size() == 1) {
        Phrase& value = values.front().front();
        const double right_px = width_px - value.width_px;
        if (rows.front().front().width_px + cap_px + mark_px <= right_px) {
            value.x_px = right_px;
            rows.front().push_back(std::move(value));
            return;
        }
    }
    std::move(values.begin(), values.end(), std::back_inserter(rows));
}

double picture_width_px(double cap_px) {
    constexpr Area area;
    return line_height_px(cap_px) * area.width_m / area.height_m;
}

/// What stands before each name: the focus's pointer, and the small picture.
double before_name_px(double cap_px, double picture_px) {
    return pointer_caps * cap_px +
           (picture_px > 0.0 ? picture_px + picture_gap_caps * cap_px : 0.0);
}

std::vector<RowBlock> blocks_of_list(cairo_t* cr, const SpokenScreen& screen, double width_px,
                                     double cap_px, double picture_px) {
    std::vector<RowBlock> blocks;
    const double before_px = before_name_px(cap_px, picture_px);
    const double room_px = width_px - (2.0 * item_inset_caps + item_end_caps) * cap_px - before_px;
    for (std::size_t i = 0; i < screen.items.size(); ++i) {
        const ScreenItem& item = screen.items[i];
        RowBlock block{rows_of(cr, room_px, {cap_px, false}, item.name), i};
        add_value(block.rows, cr, room_px, cap_px, item);
        for (PhraseRow& row : block.rows) {
            for (Phrase& phrase : row) phrase.x_px += before_px;
        }
        blocks.push_back(std::move(block));
    }
    return blocks;
}

double height_of(const std::vector<RowBlock>& blocks, const PageMetrics& metrics) {
    double height_px = 0.0;
    for (const RowBlock& block : blocks) {
        if (block.rows.empty()) continue;
        if (height_px > 0.0) height_px += metrics.gap_px;
        height_px +=
            2.0 * metrics.inset_px + metrics.row_px * static_cast<double>(block.rows.size());
    }
    return height_px;
}

/// A part of a sheet before it has its height.
struct Draft {
    std::vector<RowBlock> blocks;
    PageMetrics metrics;
    double natural_px = 0.0;  // if all of it is on one page
    double least_px = 0.0;    // with a single row
    double bar_px = 0.0;      // below pages

    [[nodiscard]] double smallest_px() const { return std::min(natural_px, least_px + bar_px); }
};

Draft draft_of(std::vector<RowBlock> blocks, double inset_px, double gap_px,
               const TextSizes& sizes) {
    Draft draft{std::move(blocks), {0.0, line_height_px(sizes.cap_px), inset_px, gap_px}};
    draft.natural_px = height_of(draft.blocks, draft.metrics);
    draft.least_px = draft.metrics.row_px + 2.0 * inset_px;
    draft.bar_px = bar_height_px(sizes);
    return draft;
}

/// The part at the upper edge of `room`, no higher than it needs.
PagedPart placed(const Draft& draft, const Rect& room) {
    PagedPart part;
    constexpr double rounding = 1e-6;
    const bool is_whole = draft.natural_px <= room.height + rounding;
    const double bar_px = is_whole ? 0.0 : draft.bar_px;
    const double page_px = is_whole ? draft.natural_px : room.height - bar_px;
    part.rect = {room.x, room.y, room.width, page_px};
    part.bar = {room.x, room.y + page_px, room.width, bar_px};
    part.inset_px = draft.metrics.inset_px;
    PageMetrics metrics = draft.metrics;
    metrics.height_px = page_px + rounding;
    part.pages = pages_of(draft.blocks, metrics);
    return part;
}

/// The sheet without its margins, as wide as lines may be.
Rect column_of(const Rect& rect, double cap_px, double most_px) {
    const double margin_px = margin_caps * cap_px;
    const double upper_px = upper_margin_caps * cap_px;
    return {rect.x + margin_px, rect.y + upper_px,
            std::max(std::min(rect.width - 2.0 * margin_px, most_px), 1.0),
            std::max(rect.height - 2.0 * upper_px, 1.0)};
}

/// The part of `room_px` for the text: everything it needs if the list has room for that, else two
/// fifths, but never the list's only row.
double height_of_text(const Draft& text, const Draft& list, double room_px) {
    constexpr double share = 0.4;
    if (text.natural_px + list.natural_px <= room_px) return text.natural_px;
    const double spared_px = room_px - list.natural_px;
    const double wanted_px = std::max({share * room_px, spared_px, text.smallest_px()});
    const double most_px = std::max(room_px - list.smallest_px(), text.smallest_px());
    const double given_px = std::min(wanted_px, most_px);
    if (given_px >= text.natural_px) return text.natural_px;
    // Rounds down to whole rows, so that the items can use the rest.
    const double rows = std::floor((given_px - text.bar_px) / text.metrics.row_px);
    return text.bar_px + std::max(rows, 1.0) * text.metrics.row_px;
}

struct SheetRooms {
    Rect text;
    Rect list;
};

SheetRooms side_by_side(const Rect& column, double cap_px) {
    const double text_px = text_share * column.width;
    const double list_x_px = column.x + text_px + column_gap_caps * cap_px;
    return {{column.x, column.y, text_px, column.height},
            {list_x_px, column.y, column.x + column.width - list_x_px, column.height}};
}

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

void add_pictures(SheetFace& face, const SheetLayout& layout, std::size_t page) {
    if (layout.picture_px <= 0.0) return;
    const PagedPart& list = layout.list;
    const double x_px = list.rect.x + list.inset_px + pointer_caps * layout.sizes.cap_px;
    for (const PlacedItem& placed : list.pages.at(page).items)
        face.pictures.push_back({placed.item,
                                 {x_px, list.rect.y + placed.top_px + list.inset_px,
                                  layout.picture_px, line_height_px(layout.sizes.cap_px)}});
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

void paint_toggle_frame(cairo_t* cr, const FaceLine& line, Colour colour) {
    const double cap_px = line.style.cap_px;
    const double height_px = 1.85 * cap_px;
    const double middle_px = line.at.y + line_height_px(cap_px) / 2.0;
    stroke_rect(
        cr,
        {line.at.x - 0.5 * cap_px, middle_px - height_px / 2.0, line.width_px + cap_px, height_px},
        std::max(0.07 * cap_px, 1.0), colour);
}

/// One triangle above the other, after the value that the keys Up and Down change.
void paint_turning(cairo_t* cr, const FaceLine& line, Colour colour) {
    const double cap_px = line.style.cap_px;
    const double x_px = line.at.x + line.width_px + 0.35 * cap_px;
    const double middle_px = line.at.y + line_height_px(cap_px) / 2.0;
    for (const double up : {-1.0, 1.0}) {
        cairo_move_to(cr, x_px, middle_px + up * 0.8 * cap_px);
        cairo_line_to(cr, x_px - 0.25 * cap_px, middle_px + up * 0.2 * cap_px);
        cairo_line_to(cr, x_px + 0.25 * cap_px, middle_px + up * 0.2 * cap_px);
        cairo_close_path(cr);
    }
    cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue);
    cairo_fill(cr);
}

bool is_in_focus(const SheetFace& face, const FaceLine& line) {
    return face.focus && line.at.y >= face.focus->y &&
           line.at.y < face.focus->y + face.focus->height;
}

void paint_mark(cairo_t* cr, const SheetFace& face, const FaceLine& line, Colour colour) {
    if (line.mark == PhraseMark::frame) paint_toggle_frame(cr, line, colour);
    if (line.mark == PhraseMark::triangles && face.is_turning && is_in_focus(face, line))
        paint_turning(cr, line, colour);
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

SheetLayout lay_out_sheet(cairo_t* cr, const SpokenScreen& screen, const Rect& rect,
                          const TextSizes& sizes, bool has_pictures) {
    const double cap_px = sizes.cap_px;
    SheetLayout layout{rect, sizes, {}, {}, has_pictures ? picture_width_px(cap_px) : 0.0};
    const bool is_beside =
        rect.width >= beside_from_caps * cap_px && !screen.text.empty() && !screen.items.empty();
    const double most_px = (is_beside ? 2.0 : 1.0) * widest_caps * cap_px;
    const Rect column = column_of(rect, cap_px, most_px);
    SheetRooms rooms = is_beside ? side_by_side(column, cap_px) : SheetRooms{column, column};
    const Draft text = draft_of(
        {{rows_of(cr, rooms.text.width, {cap_px, false}, screen.text), {}, true}}, 0.0, 0.0, sizes);
    const Draft list =
        draft_of(blocks_of_list(cr, screen, rooms.list.width, cap_px, layout.picture_px),
                 item_inset_caps * cap_px, item_gap_caps * cap_px, sizes);
    if (!is_beside) {
        const bool has_both = text.natural_px > 0.0 && list.natural_px > 0.0;
        const double gap_px = has_both ? gap_caps * cap_px : 0.0;
        rooms.text.height = height_of_text(text, list, column.height - gap_px);
        rooms.list.y += rooms.text.height + gap_px;
        rooms.list.height -= rooms.text.height + gap_px;
    }
    layout.text = placed(text, rooms.text);
    layout.list = placed(list, rooms.list);
    return layout;
}

SheetPages sheet_pages(const SheetLayout& layout, std::optional<std::size_t> focus,
                       std::int64_t screen_ns, std::int64_t focus_ns) {
    const auto all = [](const PagedPart& part) { return PageRange{0, part.pages.size()}; };
    SheetPages pages;
    pages.text = page_at(layout.text.pages, all(layout.text), screen_ns);
    const PageRange with_focus = focus ? pages_with(layout.list.pages, *focus) : all(layout.list);
    pages.list = page_at(layout.list.pages, with_focus, focus ? focus_ns : screen_ns);
    return pages;
}

double focus_width_px(const TextSizes& sizes) {
    return std::max(item_inset_caps * sizes.cap_px, 4.0);
}

SheetFace face_of(const SheetLayout& layout, const SpokenScreen& screen, const SheetPages& pages) {
    SheetFace face;
    face.pages = pages;
    add_page(face, layout.text, pages.text, layout.sizes.cap_px);
    if (screen.items.empty()) return face;
    add_page(face, layout.list, pages.list, layout.sizes.cap_px);
    add_pictures(face, layout, pages.list);
    if (screen.focus) face.focus = frame_of(layout.list, pages.list, *screen.focus);
    face.is_turning = screen.is_turning;
    return face;
}

void paint_sheet(cairo_t* cr, const SheetLayout& layout, const SheetFace& face,
                 const std::vector<LineDrawingPtr>& pictures, const Palette& palette) {
    fill(cr, layout.rect, {palette.background});
    for (const FaceLine& line : face.lines) {
        paint_line(cr, line.at, line.style, palette.text, line.text);
        paint_mark(cr, face, line, palette.text);
    }
    const double line_px = std::max(0.07 * layout.sizes.cap_px, 1.5);
    for (const FacePicture& small : face.pictures)
        if (small.item < pictures.size() && pictures[small.item])
            paint_line_drawing(cr, small.rect, *pictures[small.item], line_px, palette.outline);
    paint_page_bar(cr, layout.text.bar, face.pages.text, layout.text.pages.size(), layout.sizes,
                   palette);
    paint_page_bar(cr, layout.list.bar, face.pages.list, layout.list.pages.size(), layout.sizes,
                   palette);
    if (face.focus) paint_focus(cr, layout, *face.focus, palette.focus);
}

}  // namespace touchline
