// The places of things on the screen, of any size with letters of any size, and the map from W to
// pixels.
// Threads: pure functions.
#pragma once

#include "app/screen/theme.h"
#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

namespace touchline {

using PixelPoint = Vec2<struct Pixel>;  // x right, y down, from the top left corner

struct Rect {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;

    friend bool operator==(const Rect&, const Rect&) = default;
};

/// Maps W to pixels: one scale, with y turned over.
struct View {
    double px_per_m = 1.0;
    PixelPoint origin;  // the origin of W

    [[nodiscard]] PixelPoint to_px(Position p_W) const {
        return origin + PixelPoint{px_per_m * p_W.x, -px_per_m * p_W.y};
    }

    [[nodiscard]] Position to_W(PixelPoint p) const {
        const PixelPoint d = p - origin;
        return {d.x / px_per_m, -d.y / px_per_m};
    }
};

/// The whole drawing area, as large as fits in the middle of `rect` with a small margin.
[[nodiscard]] View view_of(const Area& area, const Rect& rect);

/// The drawing area's place on the screen.
[[nodiscard]] Rect area_rect(const Area& area, const View& view);

/// The largest rectangle with the proportions of a picture, centred in the drawing area: the
/// picture's place in W. Sizes > 0.
[[nodiscard]] Area fitted(const Area& area, double width, double height);

/// Cap heights of a screen, in pixels.
struct TextSizes {
    double normal_px = 27.0;  // the least height of any letter
    double cap_px = 27.0;     // the chosen height

    friend bool operator==(const TextSizes&, const TextSizes&) = default;
};

/// The sizes for a screen of this size; `normal_cap_px` is the cap height of TextSize::normal on
/// it. A screen too small for a title, a row of text, one item and one row of captions gets the
/// largest letters for which they have room.
[[nodiscard]] TextSizes text_sizes(TextSize size, double normal_cap_px, int width_px,
                                   int height_px);

/// The rows of the captions' text.
[[nodiscard]] int caption_rows(int height_px, const TextSizes& sizes);

/// What a screen shows beside its items.
struct Beside {
    bool has_picture = false;
    bool has_panel = false;  // the staff's live view
};

/// The parts of a screen.
struct Arrangement {
    Rect header;    // along the upper edge: the title, and the place in the list
    Rect sheet;     // text and items
    Rect captions;  // along the lower edge; always there, so that a new caption moves nothing
    Rect picture;   // width 0: no picture
    Rect panel;     // width 0: no live view

    friend bool operator==(const Arrangement&, const Arrangement&) = default;
};

/// Covers the screen without gap or overlap; edges lie on whole pixels. The sheet first gets what
/// its letters need; a picture smaller than a stamp is left out. A panel takes half of what the
/// picture has, or all of it on a small screen; without a picture, half of the sheet.
[[nodiscard]] Arrangement arrange(int width_px, int height_px, const TextSizes& sizes,
                                  const Beside& beside);

}  // namespace touchline
