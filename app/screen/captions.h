// The band along the lower edge: what is being said, the keys that act, and a sign with words for
// every short sound. Threads: one at a time per Canvas.
#pragma once

#include "app/screen/key_legend.h"
#include "app/screen/turned_text.h"
#include "audio-cues/words/language.h"

#include <string>
#include <vector>

#include <cairo.h>

namespace touchline {

struct CaptionLayout {
    Rect rect;
    TurnedText text;
    Rect foot;  // the keys at the left, the sign of a sound at the right
    TextSizes sizes;
    bool has_key_names = true;  // there is room for them beside the longest sign
};

/// `rect`: the band, as arrange() gives it.
[[nodiscard]] CaptionLayout lay_out_caption(cairo_t* cr, const std::string& caption,
                                            const Rect& rect, const TextSizes& sizes,
                                            const Language& language);

/// The sign's words at the right end of the foot. Long words become smaller, and are never broken.
struct SignLine {
    PixelPoint at;
    LineStyle style;
    double width_px = 0.0;
    std::string text;
};

[[nodiscard]] SignLine sign_line(cairo_t* cr, const CaptionLayout& layout, const std::string& sign);

/// What the band shows.
struct CaptionFace {
    std::size_t page = 0;
    std::string sign;  // empty: no sound
    std::vector<LegendKey> keys;
};

/// Fills the band.
void paint_captions(cairo_t* cr, const CaptionLayout& layout, const CaptionFace& face,
                    const Palette& palette);

}  // namespace touchline
