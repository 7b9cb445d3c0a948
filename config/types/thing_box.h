// Where in a picture a thing is.
// Threads: plain values and pure functions.
#pragma once

#include <algorithm>

namespace touchline {

/// A thing's place, as shares of the picture's width and height from its upper left corner.
struct ThingBox {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;

    friend bool operator==(const ThingBox&, const ThingBox&) = default;
};

/// Whether it lies in the picture and is not empty; never where a side is not a number.
[[nodiscard]] constexpr bool is_sound(const ThingBox& box) {
    return box.left >= 0.0 && box.left < box.right && box.right <= 1.0 && box.top >= 0.0 &&
           box.top < box.bottom && box.bottom <= 1.0;
}

/// The share of the picture that it covers.
[[nodiscard]] constexpr double area_of(const ThingBox& box) {
    return (box.right - box.left) * (box.bottom - box.top);
}

/// The area of both over that of either: 1 where they are the same, 0 where they do not meet.
[[nodiscard]] constexpr double overlap_of(const ThingBox& a, const ThingBox& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    if (!(width > 0.0 && height > 0.0)) return 0.0;
    return width * height / (area_of(a) + area_of(b) - width * height);
}

/// The least box that holds both.
[[nodiscard]] constexpr ThingBox around(const ThingBox& a, const ThingBox& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

}  // namespace touchline
