#include "app/screen/layout.h"

#include <algorithm>
#include <cmath>

namespace touchline {

ScreenLayout lay_out(int width_px, int height_px) {
    constexpr double share_beside = 0.32;  // of the width; fits the words on usual screens
    constexpr double share_below = 0.36;   // of the height
    constexpr double wide = 1.5;           // true for 16:9 and 16:10, not for 4:3, 5:4 or upright
    const double width = width_px;
    const double height = height_px;
    if (width / height >= wide) {
        const double split = std::round(width * (1.0 - share_beside));
        return {{0.0, 0.0, split, height}, {split, 0.0, width - split, height}};
    }
    const double split = std::round(height * (1.0 - share_below));
    return {{0.0, 0.0, width, split}, {0.0, split, width, height - split}};
}

View view_of(const Area& area, const Rect& rect) {
    constexpr double margin = 0.03;  // of the shorter side
    const double inset = 2.0 * margin * std::min(rect.width, rect.height);
    const double scale =
        std::min((rect.width - inset) / area.width_m, (rect.height - inset) / area.height_m);
    return {scale, {rect.x + rect.width / 2.0, rect.y + rect.height / 2.0}};
}

Rect area_rect(const Area& area, const View& view) {
    const PixelPoint corner = view.to_px({-area.width_m / 2.0, area.height_m / 2.0});
    return {corner.x, corner.y, area.width_m * view.px_per_m, area.height_m * view.px_per_m};
}

Barbs barbs_of(PixelPoint from, PixelPoint to, double head_px) {
    const Direction ahead = direction_of(to - from);
    const PixelPoint back = to - along<PixelPoint>(ahead, head_px);
    const PixelPoint aside = along<PixelPoint>(left_of(ahead), 0.6 * head_px);
    return {back + aside, back - aside};
}

Area fitted(const Area& area, double width, double height) {
    const double scale = std::min(area.width_m / width, area.height_m / height);
    return {scale * width, scale * height};
}

}  // namespace touchline
