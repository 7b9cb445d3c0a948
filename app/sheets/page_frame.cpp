#include "app/sheets/page_frame.h"

#include <fmt/core.h>

namespace touchline {
namespace {

constexpr double half_dot_mm = braille_dot_mm / 2.0;
constexpr double half_line_mm = thin_line_mm / 2.0;
constexpr double arrow_height_mm = 14.0;
constexpr double arrow_width_mm = 9.0;
constexpr double arrow_head_mm = 4.0;  // from the tip to the sides and down
constexpr double tick_mm = 5.0;
constexpr double apart_mm = 6.0;  // between frame and drawing
constexpr std::size_t cells_apart = 3;

SheetStroke line(PaperPoint from, PaperPoint to) {
    return {{from, to}, false, thin_line_mm, StrokeUse::furniture, 0};
}

/// Rows of a block whose upper left corner is `corner`.
BrailleBlock block_at(PaperPoint corner, const std::string& words,
                      const std::vector<BrailleCells>& lines) {
    BrailleBlock block{words, {}};
    PaperPoint first{corner.x_mm + half_dot_mm, corner.y_mm + half_dot_mm};
    for (const BrailleCells& cells : lines) {
        block.rows.push_back({first, cells});
        first.y_mm += braille_line_mm;
    }
    return block;
}

/// Its tip up, in the upper right corner of the area.
void add_arrow(const PaperBox& area, PaperPage& page) {
    const PaperPoint tip{area.right_mm - arrow_width_mm / 2.0, area.top_mm + half_line_mm};
    const double down_mm = tip.y_mm + arrow_head_mm;
    page.strokes.push_back(line(tip, {tip.x_mm, area.top_mm + arrow_height_mm - half_line_mm}));
    page.strokes.push_back(line(tip, {tip.x_mm - arrow_head_mm, down_mm}));
    page.strokes.push_back(line(tip, {tip.x_mm + arrow_head_mm, down_mm}));
}

/// Returns the lower end of title and arrow.
double add_head(const PaperBox& area, const FrameWords& words, PaperPage& page) {
    const double right_mm = area.right_mm - arrow_width_mm - least_clear_mm;
    const std::size_t width = cells_in(right_mm - area.left_mm);
    double title_mm = area.top_mm;
    if (!words.up_cells.empty()) {
        const auto lines = wrapped(words.up_cells, width);
        const double up_mm = right_mm - braille_width_mm(lines.front().size());
        page.blocks.push_back(block_at({up_mm, area.top_mm}, words.up, lines));
        if (words.title_cells.size() + cells_apart + words.up_cells.size() > width)
            title_mm += static_cast<double>(lines.size()) * braille_line_mm;
    }
    double bottom_mm = area.top_mm + arrow_height_mm;
    if (!words.title_cells.empty()) {
        const auto lines = wrapped(words.title_cells, width);
        page.blocks.push_back(block_at({area.left_mm, title_mm}, words.title, lines));
        bottom_mm = std::max(bottom_mm, title_mm + braille_height_mm(lines.size()));
    }
    return bottom_mm;
}

/// Returns the upper end of the scale.
double add_scale(const PaperBox& area, const FrameWords& words, PaperPage& page) {
    const double left_mm = area.left_mm + half_line_mm;
    const double words_mm = left_mm + scale_bar_mm + half_line_mm + least_clear_mm;
    const auto lines = wrapped(words.scale_cells, cells_in(area.right_mm - words_mm));
    const double bottom_mm = area.bottom_mm - foot_mm;
    const double top_mm = bottom_mm - braille_height_mm(std::max<std::size_t>(lines.size(), 1));
    const double bar_mm = top_mm + half_dot_mm + braille_pitch_mm;
    const PaperPoint from{left_mm, bar_mm};
    const PaperPoint to{left_mm + scale_bar_mm, bar_mm};
    page.strokes.push_back(line(from, to));
    for (const PaperPoint end : {from, to})
        page.strokes.push_back(
            line({end.x_mm, end.y_mm - tick_mm / 2.0}, {end.x_mm, end.y_mm + tick_mm / 2.0}));
    if (!lines.empty()) page.blocks.push_back(block_at({words_mm, top_mm}, words.scale, lines));
    return top_mm;
}

}  // namespace

PaperBox printable(PaperSize size) {
    return {paper_margin_mm, paper_margin_mm, size.width_mm - paper_margin_mm,
            size.height_mm - paper_margin_mm};
}

SheetPrint foot_of(PaperSize size, const std::string& title, std::size_t page, std::size_t pages) {
    const PaperBox area = printable(size);
    SheetPrint print;
    print.base = {area.left_mm, area.bottom_mm - 1.0};
    print.width_mm = area.width_mm();
    print.text = pages < 2 ? title : fmt::format("{}/{}  {}", page, pages, title);
    return print;
}

PageFrame page_frame(PaperSize size, const FrameWords& words) {
    PageFrame frame{{size, {}, {}, {}}, {}};
    const PaperBox area = printable(size);
    add_arrow(area, frame.page);
    const double top_mm = add_head(area, words, frame.page) + apart_mm;
    const double bottom_mm = add_scale(area, words, frame.page) - apart_mm;
    frame.zone = {area.left_mm, top_mm, area.right_mm, std::max(top_mm, bottom_mm)};
    return frame;
}

}  // namespace touchline
