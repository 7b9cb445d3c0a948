// The places of things on the screen, and the map from W to pixels.
// Threads: pure functions.
#pragma once

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

/// The picture is at the left and the panel at the right of a wide screen; on any other the picture
/// is above the panel.
struct ScreenLayout {
    Rect picture;
    Rect panel;

    friend bool operator==(const ScreenLayout&, const ScreenLayout&) = default;
};

/// Sizes in pixels, > 0; edges lie on whole pixels.
[[nodiscard]] ScreenLayout lay_out(int width_px, int height_px);

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

/// The ends of the two barbs of an arrow's head, `head_px` long.
struct Barbs {
    PixelPoint left, right;
};

[[nodiscard]] Barbs barbs_of(PixelPoint from, PixelPoint to, double head_px);

/// The largest rectangle with the proportions of a picture, centred in the drawing area: the
/// picture's place in W. Sizes > 0.
[[nodiscard]] Area fitted(const Area& area, double width, double height);

}  // namespace touchline
