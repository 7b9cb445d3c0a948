#include "app/screen/strokes.h"

#include <cmath>
#include <numbers>

namespace touchline {

namespace {

std::uint8_t byte_of(double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * share));
}

}  // namespace

void Strokes::add_line(PixelPoint a, PixelPoint b, double width_px, const Paint& paint) {
    if (!is_finite(a) || !is_finite(b)) return;
    const double length = norm(b - a);
    const Direction ahead = direction_of(b - a);
    const double half = width_px / 2.0;
    const double reach = half + 1.0;  // room for the smooth rim
    const std::array<std::uint8_t, 4> rgba{byte_of(paint.colour.red), byte_of(paint.colour.green),
                                           byte_of(paint.colour.blue), byte_of(paint.alpha)};
    const auto corner = [&](double along_px, double across_px) {
        const PixelPoint p =
            a + along<PixelPoint>(ahead, along_px) + along<PixelPoint>(left_of(ahead), across_px);
        vertices_.push_back({static_cast<float>(p.x), static_cast<float>(p.y),
                             static_cast<float>(along_px), static_cast<float>(across_px),
                             static_cast<float>(length), static_cast<float>(half), rgba});
    };
    corner(-reach, -reach);
    corner(length + reach, -reach);
    corner(length + reach, reach);
    corner(-reach, -reach);
    corner(length + reach, reach);
    corner(-reach, reach);
}

void Strokes::add_ring(PixelPoint centre, double radius_px, double width_px, const Paint& paint) {
    constexpr int parts = 24;
    const auto point = [&](int i) {
        const double angle_rad = 2.0 * std::numbers::pi * i / parts;
        return centre +
               PixelPoint{radius_px * std::cos(angle_rad), radius_px * std::sin(angle_rad)};
    };
    for (int i = 0; i < parts; ++i) add_line(point(i), point(i + 1), width_px, paint);
}

void Strokes::add_arrow(PixelPoint from, PixelPoint to, double width_px, const Paint& paint) {
    const double length = norm(to - from);
    if (!(length >= 1.0)) return;
    add_line(from, to, width_px, paint);
    const Barbs barbs = barbs_of(from, to, 4.0 * width_px);
    add_line(to, barbs.left, width_px, paint);
    add_line(to, barbs.right, width_px, paint);
}

}  // namespace touchline
