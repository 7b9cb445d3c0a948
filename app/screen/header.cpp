#include "app/screen/header.h"

#include "app/screen/paint.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr double header_margin_caps = 0.5;  // of the normal size, left and right

std::string way_words(const std::vector<std::string>& titles) {
    std::string words;
    for (const std::string& title : titles) words += title + " \xE2\x80\xBA ";  // ›
    return words;
}

/// A line of normal letters whose base line is that of larger ones in the band.
PixelPoint on_base_line(const HeaderLayout& layout, double x_px) {
    const double lower_px = base_line_px(layout.title.style.cap_px);
    return {x_px, layout.title.rect.y + lower_px - base_line_px(layout.sizes.normal_px)};
}

/// What the longest place of an item takes, with the gap before it.
double room_of_place_px(cairo_t* cr, const SpokenScreen& screen, const TextSizes& sizes,
                        const Language& language) {
    double widest_px = 0.0;
    for (std::size_t item = 0; item < screen.items.size(); ++item)
        widest_px = std::max(
            widest_px, line_width_px(cr, {sizes.normal_px}, told_place(screen, item, language)));
    return widest_px > 0.0 ? sizes.normal_px + widest_px : 0.0;
}

}  // namespace

HeaderLayout lay_out_header(cairo_t* cr, const SpokenScreen& screen, const Rect& rect,
                            const TextSizes& sizes, const Language& language) {
    const double margin_px = header_margin_caps * sizes.normal_px;
    const LineStyle bold{sizes.cap_px, true};
    HeaderLayout layout{rect, sizes, {}, way_words(screen.way), {}};
    Rect room{rect.x + margin_px, rect.y + margin_px / 2.0, rect.width - 2.0 * margin_px,
              line_height_px(sizes.cap_px)};
    room.width = std::max(room.width - room_of_place_px(cr, screen, sizes, language), 1.0);
    const double way_px = line_width_px(cr, {sizes.normal_px}, layout.way);
    const double left_px = room.x;
    if (way_px + line_width_px(cr, bold, screen.title) <= room.width) {
        room.x += way_px;
        room.width -= way_px;
    } else {
        layout.way.clear();
    }
    layout.title = turned_text(cr, screen.title, room, bold, sizes.normal_px);
    layout.way_at = on_base_line(layout, left_px);
    return layout;
}

void paint_header(cairo_t* cr, const HeaderLayout& layout, const SpokenScreen& screen,
                  std::size_t page, const Palette& palette, const Language& language) {
    const Rect& rect = layout.rect;
    const double rim_px = std::max(0.06 * layout.sizes.normal_px, 1.0);
    const LineStyle small{layout.sizes.normal_px};
    fill(cr, rect, {palette.background});
    fill(cr, {rect.x, rect.y + rect.height - rim_px, rect.width, rim_px}, {palette.frame});
    paint_line(cr, layout.way_at, small, palette.name, layout.way);
    paint_turned(cr, layout.title, page, palette.text);
    const double bar_px = bar_height_px(layout.sizes);
    paint_page_bar(cr, {rect.x, rect.y + rect.height - bar_px, rect.width, bar_px}, page,
                   layout.title.pages.size(), layout.sizes, palette);
    if (!screen.focus) return;
    const std::string place = told_place(screen, *screen.focus, language);
    const double right_px = rect.x + rect.width - header_margin_caps * layout.sizes.normal_px;
    paint_line(cr, on_base_line(layout, right_px - line_width_px(cr, small, place)), small,
               palette.text, place);
}

}  // namespace touchline
