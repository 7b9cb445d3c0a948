#include "app/screen/turned_text.h"

#include "app/screen/paint.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

std::vector<SheetPage> turned_pages(cairo_t* cr, const std::string& text, const Rect& rect,
                                    LineStyle style) {
    RowBlock block;
    block.is_running = true;
    for (std::string& line : broken_lines(cr, rect.width, style, text))
        block.rows.push_back({Phrase{0.0, 0.0, std::move(line)}});
    constexpr double rounding = 1e-6;
    return pages_of(std::span(&block, 1), {rect.height + rounding, line_height_px(style.cap_px)});
}

}  // namespace

TurnedText turned_text(cairo_t* cr, const std::string& text, const Rect& rect, LineStyle most,
                       double least_px) {
    constexpr double step = 0.94;
    TurnedText turned{rect, most, turned_pages(cr, text, rect, most)};
    while (turned.pages.size() > 1 && turned.style.cap_px > least_px) {
        turned.style.cap_px = std::max(step * turned.style.cap_px, least_px);
        turned.pages = turned_pages(cr, text, rect, turned.style);
    }
    return turned;
}

void paint_turned(cairo_t* cr, const TurnedText& text, std::size_t page, Colour colour) {
    for (const PlacedPhrase& placed : text.pages.at(page).phrases)
        paint_line(cr, PixelPoint{text.rect.x, text.rect.y} + placed.at, text.style, colour,
                   placed.phrase.text);
}

double bar_height_px(const TextSizes& sizes) {
    return 0.5 * sizes.normal_px;
}

void paint_page_bar(cairo_t* cr, const Rect& rect, std::size_t page, std::size_t pages,
                    const TextSizes& sizes, const Palette& palette) {
    if (pages < 2) return;
    const double thick_px = std::max(0.2 * sizes.normal_px, 3.0);
    const double thin_px = std::max(0.06 * sizes.normal_px, 1.0);
    const double page_px = rect.width / static_cast<double>(pages);
    const double middle_px = rect.y + bar_height_px(sizes) / 2.0;
    fill(cr, {rect.x, middle_px - thin_px / 2.0, rect.width, thin_px}, {palette.frame});
    fill(cr,
         {rect.x + static_cast<double>(page) * page_px, middle_px - thick_px / 2.0, page_px,
          thick_px},
         {palette.text});
}

}  // namespace touchline
