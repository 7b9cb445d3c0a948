#include "app/screen/captions.h"

#include "app/screen/paint.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace touchline {

namespace {

constexpr double caption_margin_caps = 0.5;
constexpr double caption_widest_caps = 60.0;
constexpr double shape_caps = 1.8;  // width of the sign's shape with its gap

/// A disc with two waves.
void paint_sound_shape(cairo_t* cr, PixelPoint left, double cap_px, Colour colour) {
    constexpr double half_angle_rad = std::numbers::pi / 4.0;
    const PixelPoint centre = left + PixelPoint{0.35 * cap_px, 0.0};
    cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue);
    cairo_arc(cr, centre.x, centre.y, 0.3 * cap_px, 0.0, 2.0 * std::numbers::pi);
    cairo_fill(cr);
    cairo_set_line_width(cr, 0.14 * cap_px);
    for (const double radius : {0.65, 1.0}) {
        cairo_new_sub_path(cr);
        cairo_arc(cr, centre.x, centre.y, radius * cap_px, -half_angle_rad, half_angle_rad);
        cairo_stroke(cr);
    }
}

std::vector<SheetPage> pages_of_caption(cairo_t* cr, const std::string& caption,
                                        const CaptionLayout& layout) {
    RowBlock block;
    block.is_running = true;
    for (std::string& line : broken_lines(cr, layout.text.width, {layout.sizes.cap_px}, caption))
        block.rows.push_back({Phrase{0.0, 0.0, std::move(line)}});
    constexpr double rounding = 1e-6;
    const PageMetrics metrics{layout.text.height + rounding, line_height_px(layout.sizes.cap_px)};
    return pages_of(std::span(&block, 1), metrics);
}

}  // namespace

CaptionLayout lay_out_caption(cairo_t* cr, const std::string& caption, const Rect& rect,
                              int screen_height_px, const TextSizes& sizes) {
    const CaptionRows rows = caption_rows(screen_height_px, sizes);
    const double margin_px = caption_margin_caps * sizes.cap_px;
    const double width_px =
        std::max(std::min(rect.width - 2.0 * margin_px, caption_widest_caps * sizes.cap_px), 1.0);
    const double left_px = rect.x + (rect.width - width_px) / 2.0;
    const double top_px = rect.y + 0.25 * sizes.normal_px;
    const double text_px = rows.rows * line_height_px(sizes.cap_px);
    CaptionLayout layout;
    layout.rect = rect;
    layout.text = {left_px, top_px, width_px, text_px};
    layout.foot = {left_px, top_px + text_px, width_px, line_height_px(rows.sign_px)};
    layout.sizes = sizes;
    layout.sign_px = rows.sign_px;
    layout.pages = pages_of_caption(cr, caption, layout);
    return layout;
}

SignLine sign_line(cairo_t* cr, const CaptionLayout& layout, const std::string& sign,
                   const Language& language) {
    constexpr double step = 0.96;
    constexpr double least_px = 6.0;
    const LineStyle mark{layout.sizes.mark_px};
    const double room_px =
        layout.foot.width - layout.sizes.mark_px -
        line_width_px(cr, mark, page_words(layout.pages.size() - 1, layout.pages.size(), language));
    double cap_px = layout.sign_px;
    double width_px = line_width_px(cr, {cap_px, true}, sign);
    while (cap_px > least_px && shape_caps * cap_px + width_px > room_px) {
        cap_px *= step;
        width_px = line_width_px(cr, {cap_px, true}, sign);
    }
    const double above_px = (layout.foot.height - line_height_px(cap_px)) / 2.0;
    return {{layout.foot.x + shape_caps * cap_px, layout.foot.y + above_px},
            {cap_px, true},
            width_px,
            sign};
}

void paint_captions(cairo_t* cr, const CaptionLayout& layout, std::size_t page,
                    const std::string& sign, const Palette& palette, const Language& language) {
    fill(cr, layout.rect, {palette.background});
    const double rim_px = std::max(0.06 * layout.sizes.normal_px, 1.0);
    fill(cr, {layout.rect.x, layout.rect.y, layout.rect.width, rim_px}, {palette.frame});
    for (const PlacedPhrase& placed : layout.pages.at(page).phrases)
        paint_line(cr, PixelPoint{layout.text.x, layout.text.y} + placed.at, {layout.sizes.cap_px},
                   palette.text, placed.phrase.text);
    if (!sign.empty()) {
        const SignLine line = sign_line(cr, layout, sign, language);
        const double middle_px = layout.foot.y + layout.foot.height / 2.0;
        paint_sound_shape(cr, {layout.foot.x, middle_px}, line.style.cap_px, palette.text);
        paint_line(cr, line.at, line.style, palette.text, line.text);
    }
    const std::string words = page_words(page, layout.pages.size(), language);
    const LineStyle style{layout.sizes.mark_px};
    const double x_px = layout.foot.x + layout.foot.width - line_width_px(cr, style, words);
    const double above_px = (layout.foot.height - line_height_px(style.cap_px)) / 2.0;
    paint_line(cr, {x_px, layout.foot.y + above_px}, style, palette.text, words);
}

}  // namespace touchline
