#include "app/screen/captions.h"

#include "app/screen/paint.h"
#include "audio-cues/words/language.h"

#include <algorithm>
#include <numbers>

namespace touchline {

namespace {

constexpr double caption_margin_caps = 0.5;  // of the normal size
constexpr double caption_widest_caps = 60.0;
constexpr double sound_caps = 1.8;  // width of the sign's shape with its gap

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

double sign_width_px(cairo_t* cr, const std::string& sign, double cap_px) {
    return sound_caps * cap_px + line_width_px(cr, {cap_px, true}, sign);
}

double widest_sign_px(cairo_t* cr, double cap_px, const Language& language) {
    double widest_px = 0.0;
    for (std::size_t cue = 0; cue < cue_count; ++cue)
        widest_px = std::max(widest_px,
                             sign_width_px(cr, words_of(static_cast<Cue>(cue), language), cap_px));
    return widest_px;
}

/// Keeps the last words in one line: "1 of 5" says little in two, and less on two pages.
std::string with_whole_end(std::string caption) {
    constexpr std::size_t longest = 16;  // "no. 1234 of 5678"
    constexpr const char* no_break_space = "\xC2\xA0";
    const std::size_t comma = caption.rfind(", ");
    if (comma == std::string::npos || caption.size() - comma > longest) return caption;
    for (std::size_t at = caption.rfind(' '); at > comma + 1; at = caption.rfind(' ', at))
        caption.replace(at, 1, no_break_space);
    return caption;
}

}  // namespace

CaptionLayout lay_out_caption(cairo_t* cr, const std::string& caption, const Rect& rect,
                              const TextSizes& sizes, const Language& language) {
    const double margin_px = caption_margin_caps * sizes.normal_px;
    const double foot_px = line_height_px(sizes.normal_px);
    const double across_px = std::max(rect.width - 2.0 * margin_px, 1.0);
    const Rect room{rect.x + margin_px, rect.y + margin_px,
                    std::min(across_px, caption_widest_caps * sizes.cap_px),
                    rect.height - margin_px - foot_px};
    CaptionLayout layout;
    layout.rect = rect;
    layout.text = turned_text(cr, with_whole_end(caption), room, {sizes.cap_px}, sizes.normal_px);
    layout.foot = {room.x, room.y + room.height, across_px, foot_px};
    layout.sizes = sizes;
    layout.has_key_names = legend_width_px(cr, whole_legend(language), sizes) +
                               widest_sign_px(cr, sizes.normal_px, language) <=
                           across_px;
    return layout;
}

SignLine sign_line(cairo_t* cr, const CaptionLayout& layout, const std::string& sign) {
    constexpr double step = 0.96;
    constexpr double least_px = 6.0;
    double cap_px = layout.sizes.normal_px;
    while (cap_px > least_px && sign_width_px(cr, sign, cap_px) > layout.foot.width) cap_px *= step;
    const LineStyle style{cap_px, true};
    const double width_px = line_width_px(cr, style, sign);
    const double above_px = (layout.foot.height - line_height_px(cap_px)) / 2.0;
    return {{layout.foot.x + layout.foot.width - width_px, layout.foot.y + above_px},
            style,
            width_px,
            sign};
}

void paint_captions(cairo_t* cr, const CaptionLayout& layout, const CaptionFace& face,
                    const Palette& palette) {
    fill(cr, layout.rect, {palette.background});
    const double rim_px = std::max(0.06 * layout.sizes.normal_px, 1.0);
    fill(cr, {layout.rect.x, layout.rect.y, layout.rect.width, rim_px}, {palette.frame});
    paint_page_bar(cr, {layout.text.rect.x, layout.rect.y, layout.text.rect.width, 0.0}, face.page,
                   layout.text.pages.size(), layout.sizes, palette);
    paint_turned(cr, layout.text, face.page, palette.text);
    paint_legend(cr, layout.foot, face.keys, layout.has_key_names, layout.sizes, palette);
    if (face.sign.empty()) return;
    const SignLine line = sign_line(cr, layout, face.sign);
    const double shape_px = sound_caps * line.style.cap_px;
    fill(cr, {line.at.x - shape_px, layout.foot.y, line.width_px + shape_px, layout.foot.height},
         {palette.background});
    paint_sound_shape(cr, {line.at.x - shape_px, layout.foot.y + layout.foot.height / 2.0},
                      line.style.cap_px, palette.text);
    paint_line(cr, line.at, line.style, palette.text, line.text);
}

}  // namespace touchline
