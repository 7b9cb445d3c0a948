// Private to app/decode: decides which words form one text. Any unit, y downwards.
// Threads: pure functions.
#pragma once

#include <algorithm>

namespace touchline::decode {

struct TextBox {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;
};

/// The widest gap between words of one text, in line heights.
constexpr double widest_gap = 1.2;

/// True if `next` stands in the line of `text`, close behind it.
[[nodiscard]] constexpr bool continues(const TextBox& text, const TextBox& next) {
    constexpr double least_height = 1.0;
    const double height = std::max(text.bottom - text.top, least_height);
    return next.left - text.right < widest_gap * height && next.top < text.bottom &&
           next.bottom > text.top;
}

[[nodiscard]] constexpr TextBox around(const TextBox& a, const TextBox& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

}  // namespace touchline::decode
