// The place of a thing in a picture.
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

/// Returns whether it lies in the picture and is not empty; false if a side is NaN.
[[nodiscard]] constexpr bool is_sound(const ThingBox& box) {
    return box.left >= 0.0 && box.left < box.right && box.right <= 1.0 && box.top >= 0.0 &&
           box.top < box.bottom && box.bottom <= 1.0;
}

/// Returns the share of the picture that it covers.
[[nodiscard]] constexpr double area_of(const ThingBox& box) {
    return (box.right - box.left) * (box.bottom - box.top);
}

/// Returns the area of their intersection over that of their union: 1 if they are the same, 0 if
/// they do not meet.
[[nodiscard]] constexpr double overlap_of(const ThingBox& a, const ThingBox& b) {
    const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    if (!(width > 0.0 && height > 0.0)) return 0.0;
    return width * height / (area_of(a) + area_of(b) - width * height);
}

/// Returns the smallest box that holds both.
[[nodiscard]] constexpr ThingBox around(const ThingBox& a, const ThingBox& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
            std::max(a.bottom, b.bottom)};
}

}  // namespace touchline
