// Text of a given cap height, shaped by Pango: paragraphs, and single lines of known size to fill
// pages with.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/theme.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cairo.h>

namespace touchline {

/// A piece of a line in one colour and weight.
struct TextRun {
    std::string_view text;
    Colour colour = white_on_black.text;
    bool is_bold = false;
};

/// Draws one paragraph with its upper left corner at `at`, wrapped at `width_px`, and returns its
/// height. Invalid UTF-8 shows as replacement characters.
double paint_text(cairo_t* cr, PixelPoint at, double width_px, double cap_px,
                  std::span<const TextRun> runs);

/// The height that paint_text() would return.
[[nodiscard]] double text_height_px(cairo_t* cr, double width_px, double cap_px,
                                    std::span<const TextRun> runs);

struct LineStyle {
    double cap_px = 27.0;  // > 0
    bool is_bold = false;

    friend bool operator==(const LineStyle&, const LineStyle&) = default;
};

/// The height of a line's box: capitals with accents above the base line, descenders below.
[[nodiscard]] constexpr double line_height_px(double cap_px) {
    return 1.95 * cap_px;
}

/// The distance of the base line from the upper edge of a line's box.
[[nodiscard]] constexpr double base_line_px(double cap_px) {
    return 1.42 * cap_px;
}

/// Breaks the text into lines of at most `width_px`, between words, and inside a word only if it is
/// wider than a whole line. Invalid UTF-8 becomes replacement characters; control characters become
/// spaces. Empty if the text is.
[[nodiscard]] std::vector<std::string> broken_lines(cairo_t* cr, double width_px, LineStyle style,
                                                    std::string_view text);

[[nodiscard]] double line_width_px(cairo_t* cr, LineStyle style, std::string_view line);

/// Paints one line with the upper left corner of its box at `at`.
void paint_line(cairo_t* cr, PixelPoint at, LineStyle style, Colour colour, std::string_view line);

}  // namespace touchline
