// Colours and text sizes. Text keeps a contrast of at least 10:1, marks of at least 3:1; what a
// colour says is also said by a shape or a word.
// Threads: constants and pure functions.
#pragma once

namespace touchline {

/// sRGB, 0 ... 1.
struct Colour {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
};

/// Opaque where alpha is 1.
struct Paint {
    Colour colour;
    double alpha = 1.0;
};

namespace theme {

inline constexpr Colour background{0.0, 0.0, 0.0};
inline constexpr Colour text{1.0, 1.0, 1.0};
inline constexpr Colour name{1.0, 0.85, 0.30};
inline constexpr Colour alert{1.0, 0.72, 0.62};
inline constexpr Colour frame{0.55, 0.55, 0.55};
inline constexpr Colour outline{1.0, 0.83, 0.0};
inline constexpr Colour box{0.36, 0.78, 1.0};
inline constexpr Colour handle{1.0, 1.0, 1.0};
inline constexpr Colour proxy{0.18, 0.95, 0.78};
inline constexpr Colour force{1.0, 0.50, 0.95};

/// How much of the picture shows under the outlines: dark enough for all marks on white paper.
inline constexpr double picture_alpha = 0.35;

}  // namespace theme

/// Contrast of two colours, 1 ... 21 (WCAG 2: relative luminance).
[[nodiscard]] double contrast(Colour a, Colour b);

/// Height of a capital H that subtends 0.7 degrees at `distance_m` on a screen of `mm_per_px`
/// (EN 301 549, 5.1.4), in pixels; 12 ... 80, so that a screen that lies about its size stays
/// readable.
[[nodiscard]] double cap_height_px(double distance_m, double mm_per_px);

}  // namespace touchline
