// The band along the lower edge: what is being said, and a sign with words for every short sound.
// Threads: one at a time per Canvas.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/pages.h"
#include "app/screen/text.h"
#include "audio-cues/words/language.h"

#include <string>
#include <vector>

#include <cairo.h>

namespace touchline {

struct CaptionLayout {
    Rect rect;
    Rect text;  // of one page of the caption
    Rect foot;  // the sign of a sound at the left, the page number at the right
    TextSizes sizes;
    double sign_px = 27.0;  // cap height of a sign, unless it is long
    std::vector<SheetPage> pages = std::vector<SheetPage>(1);
};

/// `rect`: the band, as arrange() gives it for a screen of `screen_height_px`.
[[nodiscard]] CaptionLayout lay_out_caption(cairo_t* cr, const std::string& caption,
                                            const Rect& rect, int screen_height_px,
                                            const TextSizes& sizes);

/// The sign's words in the room beside its shape and the number of the last page. Long words become
/// smaller, and are never broken.
struct SignLine {
    PixelPoint at;
    LineStyle style;
    double width_px = 0.0;
    std::string text;
};

[[nodiscard]] SignLine sign_line(cairo_t* cr, const CaptionLayout& layout, const std::string& sign,
                                 const Language& language);

/// Fills the band. An empty sign has no shape.
void paint_captions(cairo_t* cr, const CaptionLayout& layout, std::size_t page,
                    const std::string& sign, const Palette& palette, const Language& language);

}  // namespace touchline
