// What the tests of the screen share: the usual letter size, reading pixels of a canvas, and
// comparing words.
#pragma once

#include "app/screen/canvas.h"
#include "app/screen/layout.h"
#include "app/screen/theme.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace touchline {

inline constexpr double usual_cap_px = 27.0;  // at 0.6 m from pixels of 0.27 mm
inline constexpr std::int64_t one_second_ns = 1'000'000'000;

/// Returns the colour of the pixel at p, drawn over black.
inline Colour colour_at(const Canvas& canvas, PixelPoint p) {
    const unsigned char* pixel = canvas.pixels() +
                                 static_cast<std::ptrdiff_t>(p.y) * canvas.stride() +
                                 4 * static_cast<std::ptrdiff_t>(p.x);
    return {pixel[2] / 255.0, pixel[1] / 255.0, pixel[0] / 255.0};
}

inline bool is_near(Colour a, Colour b) {
    constexpr double tolerance = 0.02;
    return std::abs(a.red - b.red) < tolerance && std::abs(a.green - b.green) < tolerance &&
           std::abs(a.blue - b.blue) < tolerance;
}

inline bool is_black(Colour c) {
    return is_near(c, {0.0, 0.0, 0.0});
}

/// Returns the rectangle of rows and columns with any ink; width 0 if there is none.
inline Rect ink_of(const Canvas& canvas) {
    int left = canvas.width(), right = -1, top = canvas.height(), bottom = -1;
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x) {
            if (is_black(colour_at(canvas, {x + 0.5, y + 0.5}))) continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    }
    if (right < left) return {};
    return {static_cast<double>(left), static_cast<double>(top),
            static_cast<double>(right - left + 1), static_cast<double>(bottom - top + 1)};
}

/// Nor with spaces that do not break.
inline std::string without_spaces(std::string text) {
    constexpr std::string_view no_break_space = "\xC2\xA0";
    for (std::size_t at = text.find(no_break_space); at != std::string::npos;
         at = text.find(no_break_space))
        text.erase(at, no_break_space.size());
    std::erase(text, ' ');
    return text;
}

}  // namespace touchline
