// Where sheet, picture and captions lie, on a screen of any size with letters of any size.
// Threads: pure functions.
#pragma once

#include "app/screen/layout.h"
#include "app/screen/theme.h"

namespace touchline {

/// Cap heights of a screen, in pixels.
struct TextSizes {
    double normal_px = 27.0;  // the least height of any letter
    double cap_px = 27.0;     // the chosen height
    double mark_px = 27.0;    // of page numbers: half of cap_px if there is room, else normal_px

    friend bool operator==(const TextSizes&, const TextSizes&) = default;
};

/// The sizes for a screen of this size; `normal_cap_px` is the cap height of TextSize::normal on
/// it. A screen too small for a row of text, one item and one row of captions gets the largest
/// letters for which they have room.
[[nodiscard]] TextSizes text_sizes(TextSize size, double normal_cap_px, int width_px,
                                   int height_px);

/// The rows of the captions' band.
struct CaptionRows {
    int rows = 1;         // of the caption
    double sign_px = 27;  // cap height of the sign of a sound
};

[[nodiscard]] CaptionRows caption_rows(int height_px, const TextSizes& sizes);

struct Arrangement {
    Rect sheet;
    Rect captions;  // along the lower edge; always there, so that a new caption moves nothing
    Rect picture;   // width 0: no picture

    friend bool operator==(const Arrangement&, const Arrangement&) = default;
};

/// Covers the screen without gap or overlap; edges lie on whole pixels. The sheet first gets what
/// its letters need; a picture smaller than a stamp is left out.
[[nodiscard]] Arrangement arrange(int width_px, int height_px, const TextSizes& sizes,
                                  bool has_picture);

}  // namespace touchline
