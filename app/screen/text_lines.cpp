#include "app/screen/text_lines.h"

#include "app/screen/pango_layout.h"

#include <algorithm>

namespace touchline {

namespace {

constexpr double base_line_caps = 1.42;  // below the upper edge of the box

/// Valid UTF-8 that breaks only where a line is full.
std::string clean(std::string_view text) {
    const std::unique_ptr<char, PangoDeleter> valid(
        g_utf8_make_valid(text.data(), static_cast<gssize>(text.size())));
    std::string cleaned = valid.get();
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
    const double base_line_px =
        static_cast<double>(pango_layout_get_baseline(layout.get())) / PANGO_SCALE;
    cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue);
    cairo_move_to(cr, at.x, at.y + base_line_caps * style.cap_px - base_line_px);
    pango_cairo_show_layout(cr, layout.get());
}

}  // namespace touchline
