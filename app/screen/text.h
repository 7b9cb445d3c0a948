// Text of a given cap height, shaped and wrapped by Pango.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/theme.h"

#include <span>
#include <string>
#include <string_view>

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

}  // namespace touchline
