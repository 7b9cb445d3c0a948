// Palettes and text sizes. Text has a contrast of at least 7:1, marks of at least 3:1. What a
// colour says is also said by a shape or a word.
// Threads: constants and pure functions.
#pragma once

#include "config/types/choices.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace touchline {

/// sRGB, 0 ... 1.
struct Colour {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
};

/// Opaque if alpha is 1.
struct Paint {
    Colour colour;
    double alpha = 1.0;
};

/// The colours of everything drawn, by purpose.
struct Palette {
    Colour background;
    Colour text;
    Colour name;   // of a fact's name in the staff's panel
    Colour alert;  // what went wrong
    Colour frame;  // around the drawing area
    Colour focus;  // frame and pointer of the item with the focus
    Colour outline;
    Colour box;
    Colour handle;
    Colour proxy;
    Colour force;
    Colour pen;  // a stroke that is not finished
    /// How much of the picture shows over the background: little enough that every mark stands out
    /// on white paper and on black alike.
    double picture_alpha = 0.35;
};

inline constexpr std::size_t palette_count = 4;

inline constexpr Palette white_on_black{
    .background = {0.0, 0.0, 0.0},
    .text = {1.0, 1.0, 1.0},
    .name = {1.0, 0.85, 0.30},
    .alert = {1.0, 0.72, 0.62},
    .frame = {0.55, 0.55, 0.55},
    .focus = {1.0, 0.83, 0.0},
    .outline = {1.0, 0.83, 0.0},
    .box = {0.36, 0.78, 1.0},
    .handle = {1.0, 1.0, 1.0},
    .proxy = {0.18, 0.95, 0.78},
    .force = {1.0, 0.50, 0.95},
    .pen = {0.36, 0.78, 1.0},
};

inline constexpr Palette black_on_white{
    .background = {1.0, 1.0, 1.0},
    .text = {0.0, 0.0, 0.0},
    .name = {0.0, 0.16, 0.42},
    .alert = {0.45, 0.0, 0.0},
    .frame = {0.35, 0.35, 0.35},
    .focus = {0.0, 0.0, 0.0},
    .outline = {0.10, 0.10, 0.50},
    .box = {0.0, 0.25, 0.35},
    .handle = {0.0, 0.0, 0.0},
    .proxy = {0.45, 0.0, 0.0},
    .force = {0.35, 0.0, 0.35},
    .pen = {0.0, 0.25, 0.35},
};

inline constexpr Palette yellow_on_black{
    .background = {0.0, 0.0, 0.0},
    .text = {1.0, 1.0, 0.0},
    .name = {1.0, 1.0, 0.0},
    .alert = {1.0, 0.80, 0.30},
    .frame = {0.60, 0.60, 0.0},
    .focus = {1.0, 1.0, 0.0},
    .outline = {1.0, 1.0, 0.0},
    .box = {0.36, 0.78, 1.0},
    .handle = {1.0, 1.0, 1.0},
    .proxy = {0.18, 0.95, 0.78},
    .force = {1.0, 0.50, 0.95},
    .pen = {0.36, 0.78, 1.0},
};

/// Neither background nor letters use the screen's full range, for eyes that light hurts.
inline constexpr Palette low_glare_grey{
    .background = {0.13, 0.13, 0.13},
    .text = {0.82, 0.82, 0.80},
    .name = {0.82, 0.78, 0.62},
    .alert = {0.90, 0.74, 0.66},
    .frame = {0.58, 0.58, 0.58},
    .focus = {0.82, 0.82, 0.80},
    .outline = {0.88, 0.80, 0.45},
    .box = {0.55, 0.80, 0.92},
    .handle = {0.90, 0.90, 0.88},
    .proxy = {0.50, 0.90, 0.78},
    .force = {0.95, 0.72, 0.92},
    .pen = {0.55, 0.80, 0.92},
    .picture_alpha = 0.25,
};

[[nodiscard]] constexpr const Palette& palette_of(PaletteName name) {
    switch (name) {
        case PaletteName::black_on_white:
            return black_on_white;
        case PaletteName::yellow_on_black:
            return yellow_on_black;
        case PaletteName::low_glare_grey:
            return low_glare_grey;
        case PaletteName::white_on_black:
            break;
    }
    return white_on_black;
}

/// The contrast of two colours, 1 ... 21 (WCAG 2: relative luminance).
[[nodiscard]] double contrast(Colour a, Colour b);

inline constexpr std::size_t text_size_count = 4;

/// The angle that a capital H subtends at the eye, in degrees.
[[nodiscard]] constexpr double cap_angle_deg(TextSize size) {
    constexpr std::array<double, text_size_count> angles{0.7, 1.0, 1.4, 2.0};
    return angles.at(static_cast<std::size_t>(size));
}

/// The height in pixels of a capital H that subtends 0.7 degrees at `distance_m`, on a screen of
/// `mm_per_px`. Limited to 12 ... 80, so that a screen that reports a wrong size stays readable.
[[nodiscard]] double cap_height_px(double distance_m, double mm_per_px);

}  // namespace touchline
