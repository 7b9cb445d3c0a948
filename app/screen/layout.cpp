#include "app/screen/layout.h"

#include "app/screen/text.h"
#include "config/types/tactile_map.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double least_picture_px = 160.0;  // a stamp
constexpr double least_sheet_caps = 12.0;   // width: a short word and the pointer
constexpr double least_sheet_rows = 3.2;    // height: one row of text, and an item with its frame
constexpr double good_sheet_caps = 16.0;    // width: a long word too, if there is room
constexpr double sheet_share_beside = 0.36;
constexpr double most_share_beside = 0.55;
constexpr double sheet_share_below = 0.40;

/// Pixels per metre of the drawing area; 0 if it is too small to be of use.
double usefulness(const Rect& picture) {
    if (std::min(picture.width, picture.height) < least_picture_px) return 0.0;
    return view_of(Area{}, picture).px_per_m;
}

struct Parts {
    Rect picture;
    Rect sheet;
};

Parts beside(const Rect& rect, const TextSizes& sizes) {
    const double good_px = std::min(good_sheet_caps * sizes.cap_px, most_share_beside * rect.width);
    const double width = std::round(
        std::max({sheet_share_beside * rect.width, least_sheet_caps * sizes.cap_px, good_px}));
    const double split = rect.width - width;
    return {{0.0, 0.0, split, rect.height}, {split, 0.0, width, rect.height}};
}

Parts below(const Rect& rect, const TextSizes& sizes) {
    const double least =
        least_sheet_rows * line_height_px(sizes.cap_px) + 3.0 * line_height_px(sizes.mark_px);
    const double height = std::round(std::max(sheet_share_below * rect.height, least));
    const double split = rect.height - height;
    return {{0.0, 0.0, rect.width, split}, {0.0, split, rect.width, height}};
}

}  // namespace

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

Area fitted(const Area& area, double width, double height) {
    const double scale = std::min(area.width_m / width, area.height_m / height);
    return {scale * width, scale * height};
}

TextSizes text_sizes(TextSize size, double normal_cap_px, int width_px, int height_px) {
    // The least that sheet_layout.cpp and captions.cpp need, in capitals of each size.
    constexpr double needed_normal = 8.5;
    constexpr double needed_chosen = 7.3;
    constexpr double needed_across = 10.0;
    constexpr double roomy = 14.0;
    const double normal = std::min(
        {normal_cap_px, height_px / (needed_normal + needed_chosen), width_px / needed_across});
    // At these angles the tangent differs from the angle by at most 0.1 %.
    const double wanted = normal * cap_angle_deg(size) / cap_angle_deg(TextSize::normal);
    const double cap = std::min(
        {wanted, (height_px - needed_normal * normal) / needed_chosen, width_px / needed_across});
    const bool is_roomy = height_px >= roomy * cap;
    return {normal, cap, is_roomy ? std::max(normal, cap / 2.0) : normal};
}

CaptionRows caption_rows(int height_px, const TextSizes& sizes) {
    constexpr double share = 0.36;  // of the screen's height, at most
    const double room_px = share * height_px - line_height_px(sizes.mark_px);
    const double row_px = line_height_px(sizes.cap_px);
    const bool is_sign_large = room_px >= 2.0 * row_px;
    const double sign_px = is_sign_large ? sizes.cap_px : sizes.mark_px;
    const double left_px = share * height_px - line_height_px(sign_px);
    return {std::clamp(static_cast<int>(left_px / row_px), 1, 2), sign_px};
}

Arrangement arrange(int width_px, int height_px, const TextSizes& sizes, bool has_picture) {
    const CaptionRows captions = caption_rows(height_px, sizes);
    const double band = std::ceil(captions.rows * line_height_px(sizes.cap_px) +
                                  line_height_px(captions.sign_px) + 0.5 * sizes.normal_px);
    const double width = width_px;
    const double rest = std::max(height_px - band, 1.0);
    Arrangement arrangement{{0.0, 0.0, width, rest}, {0.0, rest, width, height_px - rest}, {}};
    if (!has_picture) return arrangement;
    const Parts left = beside(arrangement.sheet, sizes);
    const Parts above = below(arrangement.sheet, sizes);
    const Parts& better = usefulness(left.picture) >= usefulness(above.picture) ? left : above;
    if (usefulness(better.picture) <= 0.0) return arrangement;
    arrangement.picture = better.picture;
    arrangement.sheet = better.sheet;
    return arrangement;
}

}  // namespace touchline
