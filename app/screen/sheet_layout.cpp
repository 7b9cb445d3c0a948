#include "app/screen/page_marks.h"
#include "app/screen/sheet.h"

#include <algorithm>
#include <cmath>

namespace touchline {

namespace {

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

}  // namespace touchline
