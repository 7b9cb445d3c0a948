#include "app/screen/theme.h"

#include "config/types/angle.h"

#include <algorithm>
#include <cmath>

namespace touchline {

namespace {

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(Colour c) {
    return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

}  // namespace

double contrast(Colour a, Colour b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

double cap_height_px(double distance_m, double mm_per_px) {
    constexpr double angle_rad = radians(cap_angle_deg(TextSize::normal));
    constexpr double fallback_px = 27.0;  // 0.6 m in front of 0.27 mm pixels
    const double height_px = 2000.0 * distance_m * std::tan(angle_rad / 2.0) / mm_per_px;
    if (!(height_px > 0.0) || !std::isfinite(height_px)) return fallback_px;
    return std::clamp(height_px, 12.0, 80.0);
}

}  // namespace touchline
