#include "app/screen/key_legend.h"

#include "app/screen/paint.h"
#include "app/screen/text.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace touchline {
namespace {

// Lengths are in capitals of the normal size.
constexpr double key_caps = 1.5;       // side of a key
constexpr double name_gap_caps = 0.3;  // between a key and its name
constexpr double key_gap_caps = 0.9;   // between a name and the next key

LegendKey key_of(KeyRole role, const Language& language) {
    constexpr std::array names{"Up", "Down", "Back", "Repeat", "Select", "Help"};
    return {role, language.text("keys", names.at(static_cast<std::size_t>(role)))};
}

void paint_triangle(cairo_t* cr, PixelPoint centre, double reach_px, double turn_rad) {
    cairo_save(cr);
    cairo_translate(cr, centre.x, centre.y);
    cairo_rotate(cr, turn_rad);
    cairo_move_to(cr, 0.0, -reach_px);
    cairo_line_to(cr, reach_px, 0.7 * reach_px);
    cairo_line_to(cr, -reach_px, 0.7 * reach_px);
    cairo_close_path(cr);
    cairo_fill(cr);
    cairo_restore(cr);
}

/// Three quarters of a ring with a head: once more.
void paint_turn(cairo_t* cr, PixelPoint centre, double radius_px) {
    constexpr double pi = std::numbers::pi;
    cairo_set_line_width(cr, 0.35 * radius_px);
    cairo_new_sub_path(cr);
    cairo_arc(cr, centre.x, centre.y, radius_px, 0.0, 1.5 * pi);
    cairo_stroke(cr);
    paint_triangle(cr, centre - PixelPoint{0.0, radius_px}, 0.6 * radius_px, pi / 2.0);
}

void paint_question(cairo_t* cr, PixelPoint centre, double cap_px, Colour colour) {
    const LineStyle style{cap_px, true};
    const double half_px = line_width_px(cr, style, "?") / 2.0;
    constexpr double middle_caps = 0.92;  // of a capital, from the upper edge of its line's box
    paint_line(cr, centre - PixelPoint{half_px, middle_caps * cap_px}, style, colour, "?");
}

/// What Braille keypads and remote controls show: arrows, a dot, a turn, a question mark.
void paint_shape(cairo_t* cr, PixelPoint centre, KeyRole role, double cap_px, Colour colour) {
    constexpr double pi = std::numbers::pi;
    const double reach_px = 0.42 * cap_px;
    cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue);
    switch (role) {
        case KeyRole::up:
            return paint_triangle(cr, centre, reach_px, 0.0);
        case KeyRole::down:
            return paint_triangle(cr, centre, reach_px, pi);
        case KeyRole::back:
            return paint_triangle(cr, centre, reach_px, -pi / 2.0);
        case KeyRole::repeat:
            return paint_turn(cr, centre, reach_px);
        case KeyRole::select:
            cairo_arc(cr, centre.x, centre.y, reach_px, 0.0, 2.0 * pi);
            return cairo_fill(cr);
        case KeyRole::help:
            return paint_question(cr, centre, 0.85 * cap_px, colour);
        case KeyRole::louder:
        case KeyRole::softer:
            break;  // they are in no legend
    }
}

double name_width_px(cairo_t* cr, const LegendKey& key, double cap_px) {
    return name_gap_caps * cap_px + line_width_px(cr, {cap_px}, key.name);
}

}  // namespace

std::vector<LegendKey> legend_of(const SpokenScreen& screen, SwitchUse switches,
                                 const Language& language) {
    const bool has_switches = switches != SwitchUse::none;
    if (screen.takes_any_key)
        return {{{}, language.text("screen", has_switches ? "Any switch" : "Any key")}};
    std::vector<LegendKey> keys;
    if (has_switches) {
        if (switches == SwitchUse::move_and_select)
            keys.push_back({KeyRole::down, language.text("screen", "Move on")});
        keys.push_back(key_of(KeyRole::select, language));
        return keys;
    }
    for (const KeyRole role : acting_keys(screen)) keys.push_back(key_of(role, language));
    return keys;
}

std::vector<LegendKey> whole_legend(const Language& language) {
    std::vector<LegendKey> keys;
    for (std::size_t role = 0; role < needed_role_count; ++role)
        keys.push_back(key_of(static_cast<KeyRole>(role), language));
    return keys;
}

double legend_width_px(cairo_t* cr, const std::vector<LegendKey>& keys, const TextSizes& sizes) {
    double width_px = 0.0;
    for (const LegendKey& key : keys)
        width_px +=
            (key_caps + key_gap_caps) * sizes.normal_px + name_width_px(cr, key, sizes.normal_px);
    return width_px;
}

void paint_legend(cairo_t* cr, const Rect& row, const std::vector<LegendKey>& keys, bool has_names,
                  const TextSizes& sizes, const Palette& palette) {
    const double cap_px = sizes.normal_px;
    const double side_px = key_caps * cap_px;
    const double middle_px = row.y + row.height / 2.0;
    double x_px = row.x;
    for (const LegendKey& key : keys) {
        if (key.role) {
            stroke_rect(cr, {x_px, middle_px - side_px / 2.0, side_px, side_px},
                        std::max(0.07 * cap_px, 1.0), palette.text);
            paint_shape(cr, {x_px + side_px / 2.0, middle_px}, *key.role, cap_px, palette.text);
            x_px += side_px;
        }
        if (has_names || !key.role) {
            paint_line(cr,
                       {x_px + name_gap_caps * cap_px, middle_px - line_height_px(cap_px) / 2.0},
                       {cap_px}, palette.text, key.name);
            x_px += name_width_px(cr, key, cap_px);
        }
        x_px += (has_names ? key_gap_caps : name_gap_caps) * cap_px;
    }
}

}  // namespace touchline
