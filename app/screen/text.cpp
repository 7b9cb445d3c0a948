#include "app/screen/text.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <pango/pangocairo.h>

namespace touchline {
namespace {

struct PangoDeleter {
    void operator()(PangoLayout* layout) const { g_object_unref(layout); }

    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }

    void operator()(PangoAttrList* list) const { pango_attr_list_unref(list); }

    void operator()(char* text) const { g_free(text); }
};

using PangoLayoutPtr = std::unique_ptr<PangoLayout, PangoDeleter>;

// Andika keeps l, I and 1 apart and has wide coverage; the others come with every Debian.
constexpr const char* families = "Andika, Noto Sans, DejaVu Sans, sans-serif";

PangoLayoutPtr layout_of_size(cairo_t* cr, double size_px, bool is_bold) {
    PangoLayoutPtr layout(pango_cairo_create_layout(cr));
    const std::unique_ptr<PangoFontDescription, PangoDeleter> font(pango_font_description_new());
    pango_font_description_set_family_static(font.get(), families);
    pango_font_description_set_absolute_size(font.get(), size_px * PANGO_SCALE);
    if (is_bold) pango_font_description_set_weight(font.get(), PANGO_WEIGHT_BOLD);
    pango_layout_set_font_description(layout.get(), font.get());
    return layout;
}

/// The font size whose capital H is `cap_px` high, whatever the font.
double font_size_px(cairo_t* cr, double cap_px) {
    constexpr double probe_px = 100.0;
    const PangoLayoutPtr layout = layout_of_size(cr, probe_px, false);
    pango_layout_set_text(layout.get(), "H", 1);
    PangoRectangle ink;
    pango_layout_get_pixel_extents(layout.get(), &ink, nullptr);
    return ink.height > 0 ? probe_px * cap_px / ink.height : cap_px / 0.7;
}

/// An empty layout whose capital H is `cap_px` high, whatever the font.
PangoLayoutPtr layout_of_cap(cairo_t* cr, double cap_px, bool is_bold) {
    return layout_of_size(cr, font_size_px(cr, cap_px), is_bold);
}

/// Invalid UTF-8 becomes replacement characters.
std::string valid_utf8(std::string_view text) {
    const std::unique_ptr<char, PangoDeleter> valid(
        g_utf8_make_valid(text.data(), static_cast<gssize>(text.size())));
    return valid.get();
}

guint16 channel(double share) {
    return static_cast<guint16>(std::lround(65535.0 * share));
}

void add_attribute(PangoAttrList* list, PangoAttribute* attribute, std::size_t from,
                   std::size_t to) {
    attribute->start_index = static_cast<guint>(from);
    attribute->end_index = static_cast<guint>(to);
    pango_attr_list_insert(list, attribute);  // takes ownership
}

PangoLayoutPtr lay_out_text(cairo_t* cr, double width_px, double cap_px,
                            std::span<const TextRun> runs) {
    PangoLayoutPtr layout = layout_of_cap(cr, cap_px, false);
    std::unique_ptr<PangoAttrList, PangoDeleter> attributes(pango_attr_list_new());
    std::string text;
    for (const TextRun& run : runs) {
        const std::size_t from = text.size();
        text += valid_utf8(run.text);
        const Colour& c = run.colour;
        add_attribute(attributes.get(),
                      pango_attr_foreground_new(channel(c.red), channel(c.green), channel(c.blue)),
                      from, text.size());
        if (run.is_bold)
            add_attribute(attributes.get(), pango_attr_weight_new(PANGO_WEIGHT_BOLD), from,
                          text.size());
    }
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    pango_layout_set_attributes(layout.get(), attributes.get());
    pango_layout_set_width(layout.get(), static_cast<int>(width_px * PANGO_SCALE));
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    return layout;
}

double height_of(PangoLayout* layout) {
    PangoRectangle logical;
    pango_layout_get_pixel_extents(layout, nullptr, &logical);
    return logical.height;
}

/// Valid UTF-8 that breaks only where a line is full.
std::string clean(std::string_view text) {
    std::string cleaned = valid_utf8(text);
    std::replace_if(
        cleaned.begin(), cleaned.end(),
        [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
    return cleaned;
}

PangoLayoutPtr layout_of(cairo_t* cr, LineStyle style, const std::string& text) {
    PangoLayoutPtr layout = layout_of_cap(cr, style.cap_px, style.is_bold);
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    return layout;
}

std::string trimmed(std::string_view line) {
    const auto first = line.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return std::string(line.substr(first, line.find_last_not_of(' ') - first + 1));
}

}  // namespace

double paint_text(cairo_t* cr, PixelPoint at, double width_px, double cap_px,
                  std::span<const TextRun> runs) {
    const PangoLayoutPtr layout = lay_out_text(cr, width_px, cap_px, runs);
    cairo_move_to(cr, at.x, at.y);
    pango_cairo_show_layout(cr, layout.get());
    return height_of(layout.get());
}

double text_height_px(cairo_t* cr, double width_px, double cap_px, std::span<const TextRun> runs) {
    return height_of(lay_out_text(cr, width_px, cap_px, runs).get());
}

std::vector<std::string> broken_lines(cairo_t* cr, double width_px, LineStyle style,
                                      std::string_view text) {
    const std::string cleaned = clean(text);
    const PangoLayoutPtr layout = layout_of(cr, style, cleaned);
    pango_layout_set_width(layout.get(), static_cast<int>(std::max(width_px, 1.0) * PANGO_SCALE));
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    std::vector<std::string> lines;
    for (const GSList* at = pango_layout_get_lines_readonly(layout.get()); at != nullptr;
         at = at->next) {
        const auto* const line = static_cast<const PangoLayoutLine*>(at->data);
        std::string words = trimmed(std::string_view(cleaned).substr(
            static_cast<std::size_t>(line->start_index), static_cast<std::size_t>(line->length)));
        if (!words.empty()) lines.push_back(std::move(words));
    }
    return lines;
}

double line_width_px(cairo_t* cr, LineStyle style, std::string_view line) {
    PangoRectangle logical;
    pango_layout_get_pixel_extents(layout_of(cr, style, clean(line)).get(), nullptr, &logical);
    return logical.width;
}

void paint_line(cairo_t* cr, PixelPoint at, LineStyle style, Colour colour, std::string_view line) {
    const PangoLayoutPtr layout = layout_of(cr, style, clean(line));
    const double ascent_px =
        static_cast<double>(pango_layout_get_baseline(layout.get())) / PANGO_SCALE;
    cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue);
    cairo_move_to(cr, at.x, at.y + base_line_px(style.cap_px) - ascent_px);
    pango_cairo_show_layout(cr, layout.get());
}

}  // namespace touchline
