#include "app/screen/layout.h"

#include "app/screen/text.h"
#include "config/types/tactile_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double least_picture_px = 160.0;  // a stamp
constexpr double least_panel_px = 240.0;
constexpr double sheet_caps = 16.0;       // width: a long word and the pointer
constexpr double least_sheet_rows = 3.2;  // height: one row of text, and an item with its frame
constexpr double sheet_share_beside = 0.36;
constexpr double sheet_share_below = 0.40;
constexpr double band_margin = 0.5;  // of header and captions, in capitals of the normal size

/// Pixels per metre of the drawing area; 0 if it is too small to be of use.
double usefulness(const Rect& picture) {
    if (std::min(picture.width, picture.height) < least_picture_px) return 0.0;
    return view_of(Area{}, picture).px_per_m;
}

struct Parts {
    Rect first;
    Rect second;
};

Parts split_across(const Rect& rect, double first_px) {
    return {{rect.x, rect.y, first_px, rect.height},
            {rect.x + first_px, rect.y, rect.width - first_px, rect.height}};
}

Parts split_down(const Rect& rect, double first_px) {
    return {{rect.x, rect.y, rect.width, first_px},
            {rect.x, rect.y + first_px, rect.width, rect.height - first_px}};
}

/// The picture beside the sheet or above it, where it is larger; an empty one if it is too small.
Parts picture_and_sheet(const Rect& rect, const TextSizes& sizes) {
    const double width =
        std::round(std::max(sheet_share_beside * rect.width, sheet_caps * sizes.cap_px));
    const double height = std::round(
        std::max(sheet_share_below * rect.height, least_sheet_rows * line_height_px(sizes.cap_px)));
    const Parts beside = split_across(rect, rect.width - width);
    const Parts above = split_down(rect, rect.height - height);
    const bool is_beside = usefulness(beside.first) >= usefulness(above.first);
    const Parts& better = is_beside ? beside : above;
    return usefulness(better.first) > 0.0 ? better : Parts{{}, rect};
}

void add_panel(Arrangement& arrangement) {
    Rect& halved = arrangement.picture.width > 0.0 ? arrangement.picture : arrangement.sheet;
    const bool is_wide = halved.width >= halved.height;
    const Parts halves = is_wide ? split_across(halved, std::round(halved.width / 2.0))
                                 : split_down(halved, std::round(halved.height / 2.0));
    const bool is_small = std::min(halves.first.width, halves.first.height) < least_panel_px;
    if (is_small && arrangement.picture.width > 0.0) {
        arrangement.panel = std::exchange(arrangement.picture, {});
        return;
    }
    arrangement.panel = halves.first;
    halved = halves.second;
}

}  // namespace

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
    // What header, a row of text, an item and the captions need, in capitals of each size.
    constexpr double needed_normal = 3.0;
    constexpr double needed_chosen = 9.1;
    constexpr double needed_across = 10.0;
    const double normal = std::min(
        {normal_cap_px, height_px / (needed_normal + needed_chosen), width_px / needed_across});
    // At these angles the tangent differs from the angle by at most 0.1 %.
    const double wanted = normal * cap_angle_deg(size) / cap_angle_deg(TextSize::normal);
    return {normal, std::min({wanted, (height_px - needed_normal * normal) / needed_chosen,
                              width_px / needed_across})};
}

int caption_rows(int height_px, const TextSizes& sizes) {
    constexpr double share = 0.27;  // of the screen's height, at most
    constexpr int most = 3;
    const double room_px = share * height_px - line_height_px(sizes.normal_px);
    return std::clamp(static_cast<int>(room_px / line_height_px(sizes.cap_px)), 1, most);
}

Arrangement arrange(int width_px, int height_px, const TextSizes& sizes, const Beside& beside) {
    const double row_px = line_height_px(sizes.cap_px);
    const double margin_px = band_margin * sizes.normal_px;
    const double header_px = std::ceil(row_px + margin_px);
    const double captions_px = std::ceil(caption_rows(height_px, sizes) * row_px +
                                         line_height_px(sizes.normal_px) + margin_px);
    const Rect all{0.0, 0.0, static_cast<double>(width_px), static_cast<double>(height_px)};
    const Parts upper = split_down(all, header_px);
    const Parts lower = split_down(upper.second, upper.second.height - captions_px);
    Arrangement arrangement{upper.first, lower.first, lower.second, {}, {}};
    if (beside.has_picture) {
        const Parts parts = picture_and_sheet(arrangement.sheet, sizes);
        arrangement.picture = parts.first;
        arrangement.sheet = parts.second;
    }
    if (beside.has_panel) add_panel(arrangement);
    return arrangement;
}

}  // namespace touchline
