#include "app/screen/sheet.h"

#include "app/screen/paint.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

/// "7 of 40": the place among the items, as spoken_item() says it.
std::string place_words(std::size_t item, std::size_t items, const Language& language) {
    return language.text("screen", "{0} of {1}", {std::to_string(item + 1), std::to_string(items)});
}

/// True if both fit side by side; otherwise they go one below the other.
bool are_beside(cairo_t* cr, double width_px, LineStyle style, const std::string& place,
                const std::string& page) {
    return line_width_px(cr, style, place) + style.cap_px + line_width_px(cr, style, page) <=
           width_px;
}

/// The most rows that the marks of a list of this length need.
int rows_of_marks(cairo_t* cr, std::size_t items, double width_px, LineStyle style,
                  const Language& language) {
    // Long names at the largest size need tens of pages each; a long list mostly has short ones.
    const std::size_t pages = std::max<std::size_t>(99, 3 * items);
    return are_beside(cr, width_px, style, place_words(items, items, language),
                      page_words(pages, pages, language))
               ? 1
               : 2;
}

constexpr double widest_caps = 50.0;        // longer lines are hard to follow
constexpr double margin_caps = 0.5;         // left and right
constexpr double upper_margin_caps = 0.25;  // and below
constexpr double gap_caps = 0.25;           // between title and text, text and list
constexpr double item_gap_caps = 0.1;
constexpr double item_inset_caps = 0.25;  // room for the focus frame
constexpr double pointer_caps = 1.2;      // room for its pointer

std::vector<PhraseRow> rows_of(cairo_t* cr, double width_px, LineStyle style,
                               const std::string& text) {
    std::vector<PhraseRow> rows;
    for (std::string& line : broken_lines(cr, width_px, style, text)) {
        const double line_px = line_width_px(cr, style, line);
        rows.push_back({Phrase{0.0, line_px, std::move(line), style.is_bold, PhraseMark::none}});
    }
    return rows;
}

/// The mark of row `row` of a value with `rows` rows: the first and the last have arrows.
PhraseMark mark_of(ItemRole role, std::size_t row, std::size_t rows) {
    if (role == ItemRole::toggle) return PhraseMark::frame;
    if (role != ItemRole::setting) return PhraseMark::none;
    if (rows == 1) return PhraseMark::arrows;
    if (row == 0) return PhraseMark::left_arrow;
    return row + 1 == rows ? PhraseMark::right_arrow : PhraseMark::none;
}

/// Puts the value beside the name if both fit in one line, else below it.
void add_value(std::vector<PhraseRow>& rows, cairo_t* cr, double width_px, double cap_px,
               const ScreenItem& item) {
    if (item.value.empty()) return;
    const double mark_px = mark_room_px(mark_of(item.role, 0, 1), cap_px);
    std::vector<PhraseRow> values =
        rows_of(cr, width_px - 2.0 * mark_px, {cap_px, true}, item.value);
    for (std::size_t row = 0; row < values.size(); ++row) {
        values[row].front().x_px = mark_px;
        values[row].front().mark = mark_of(item.role, row, values.size());
    }
    if (rows.size() == 1 && values.size() == 1) {
        Phrase& value = values.front().front();
        const Phrase& name = rows.front().front();
        const double beside_px = name.width_px + cap_px + mark_px;
        if (beside_px + value.width_px + mark_px <= width_px) {
            value.x_px = beside_px;
            rows.front().push_back(std::move(value));
            return;
        }
    }
    std::move(values.begin(), values.end(), std::back_inserter(rows));
}

std::vector<RowBlock> blocks_of_list(cairo_t* cr, const SpokenScreen& screen, double width_px,
                                     double cap_px) {
    std::vector<RowBlock> blocks;
    const double room_px = width_px - (2.0 * item_inset_caps + pointer_caps) * cap_px;
    for (std::size_t i = 0; i < screen.items.size(); ++i) {
        const ScreenItem& item = screen.items[i];
        RowBlock block{rows_of(cr, room_px, {cap_px, false}, item.name), i};
        add_value(block.rows, cr, room_px, cap_px, item);
        for (PhraseRow& row : block.rows) {
            for (Phrase& phrase : row) phrase.x_px += pointer_caps * cap_px;
        }
        blocks.push_back(std::move(block));
    }
    return blocks;
}

std::vector<RowBlock> blocks_of_text(cairo_t* cr, const SpokenScreen& screen, double width_px,
                                     double cap_px) {
    return {{rows_of(cr, width_px, {cap_px, true}, screen.title), {}, true},
            {rows_of(cr, width_px, {cap_px, false}, screen.text), {}, true}};
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
    double marks_px = 0.0;    // for the marks below a single page
    double paged_marks_px = 0.0;

    [[nodiscard]] bool is_empty() const { return natural_px <= 0.0; }

    [[nodiscard]] double whole_px() const { return natural_px + (is_empty() ? 0.0 : marks_px); }

    [[nodiscard]] double smallest_px() const {
        return is_empty() ? 0.0 : std::min(whole_px(), least_px + paged_marks_px);
    }
};

Draft draft_of(std::vector<RowBlock> blocks, double inset_px, double gap_px, double cap_px) {
    Draft draft{std::move(blocks), {0.0, line_height_px(cap_px), inset_px, gap_px}};
    draft.natural_px = height_of(draft.blocks, draft.metrics);
    draft.least_px = draft.metrics.row_px + 2.0 * inset_px;
    return draft;
}

/// `height_px`: the most that it may take.
PagedPart placed(const Draft& draft, const Rect& column, double top_px, double height_px) {
    PagedPart part;
    constexpr double rounding = 1e-6;
    const bool is_whole = draft.whole_px() <= height_px + rounding;
    const double marks_px = is_whole ? draft.marks_px : draft.paged_marks_px;
    const double page_px = is_whole ? draft.natural_px : height_px - marks_px;
    part.rect = {column.x, top_px, column.width, page_px};
    part.marks = {column.x, top_px + page_px, column.width, draft.is_empty() ? 0.0 : marks_px};
    part.inset_px = draft.metrics.inset_px;
    PageMetrics metrics = draft.metrics;
    metrics.height_px = page_px + rounding;
    part.pages = pages_of(draft.blocks, metrics);
    return part;
}

Rect column_of(const Rect& rect, double cap_px) {
    const double margin_px = margin_caps * cap_px;
    const double width_px =
        std::max(std::min(rect.width - 2.0 * margin_px, widest_caps * cap_px), 1.0);
    const double upper_px = upper_margin_caps * cap_px;
    return {std::round(rect.x + (rect.width - width_px) / 2.0), rect.y + upper_px, width_px,
            std::max(rect.height - 2.0 * upper_px, 1.0)};
}

/// The part of `room_px` for the text: everything it needs if the list has room for that, else two
/// fifths, but never the list's only row.
double height_of_text(const Draft& text, const Draft& list, double room_px) {
    constexpr double share = 0.4;
    if (text.whole_px() + list.whole_px() <= room_px) return text.whole_px();
    const double spared_px = room_px - list.whole_px();
    const double wanted_px = std::max({share * room_px, spared_px, text.smallest_px()});
    const double most_px = std::max(room_px - list.smallest_px(), text.smallest_px());
    const double given_px = std::min(wanted_px, most_px);
    if (given_px >= text.whole_px()) return text.whole_px();
    // Rounds down to whole rows, so that the items can use the rest.
    const double rows_px = given_px - text.paged_marks_px - text.metrics.gap_px;
    const double rows = std::floor(rows_px / text.metrics.row_px);
    if (rows < 2.0) return text.paged_marks_px + text.metrics.row_px;
    return text.paged_marks_px + rows * text.metrics.row_px + text.metrics.gap_px;
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

SheetLayout lay_out_sheet(cairo_t* cr, const SpokenScreen& screen, const Rect& rect,
                          const TextSizes& sizes, const Language& language) {
    const double cap_px = sizes.cap_px;
    const Rect column = column_of(rect, cap_px);
    Draft text =
        draft_of(blocks_of_text(cr, screen, column.width, cap_px), 0.0, gap_caps * cap_px, cap_px);
    Draft list = draft_of(blocks_of_list(cr, screen, column.width, cap_px),
                          item_inset_caps * cap_px, item_gap_caps * cap_px, cap_px);
    const double mark_row_px = line_height_px(sizes.mark_px);
    text.paged_marks_px = mark_row_px;
    list.marks_px = mark_row_px;
    list.paged_marks_px = mark_row_px * rows_of_marks(cr, screen.items.size(), column.width,
                                                      {sizes.mark_px}, language);
    const double gap_px = list.is_empty() ? 0.0 : gap_caps * cap_px;
    const double room_px = column.height - gap_px;
    const double text_px = height_of_text(text, list, room_px);
    SheetLayout layout{rect, sizes, placed(text, column, column.y, text_px), {}};
    const double top_px = layout.text.marks.y + layout.text.marks.height + gap_px;
    if (!list.is_empty())
        layout.list = placed(list, column, top_px, column.y + column.height - top_px);
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
