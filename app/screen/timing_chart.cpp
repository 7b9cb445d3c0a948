#include "app/screen/timing_chart.h"

#include "app/screen/paint.h"
#include "app/screen/text_lines.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace touchline {

namespace {

std::string range_of(std::size_t bar, const Language& language) {
    if (bar < LatenessBars::ends_us.size())
        return language.text("timing", "under {0} µs",
                             {std::to_string(LatenessBars::ends_us.at(bar))});
    return language.text("timing", "later");
}

double share_of(std::uint64_t ticks, std::uint64_t most) {
    if (ticks == 0) return 0.0;
    return std::log1p(static_cast<double>(ticks)) / std::log1p(static_cast<double>(most));
}

}  // namespace

double timing_chart_height_px(double cap_px) {
    return static_cast<double>(LatenessBars::count + 1) * line_height_px(cap_px);
}

void paint_timing(cairo_t* cr, const Rect& rect, const LatenessBars& bars, double cap_px,
                  const Palette& palette, const Language& language) {
    const LineStyle style{cap_px};
    const double row_px = line_height_px(cap_px);
    const std::uint64_t most = *std::max_element(bars.ticks.begin(), bars.ticks.end());
    double names_px = 0.0;
    double counts_px = 0.0;
    for (std::size_t i = 0; i < LatenessBars::count; ++i) {
        names_px = std::max(names_px, line_width_px(cr, style, range_of(i, language)));
        counts_px = std::max(counts_px, line_width_px(cr, style, std::to_string(bars.ticks.at(i))));
    }
    const double room_px = std::max(rect.width - names_px - counts_px - 2.0 * cap_px, 0.0);
    paint_line(cr, {rect.x, rect.y}, {cap_px, true}, palette.name,
               language.text("timing", "Ticks by lateness"));
    for (std::size_t i = 0; i < LatenessBars::count; ++i) {
        const double y_px = rect.y + static_cast<double>(i + 1) * row_px;
        const std::string ticks = std::to_string(bars.ticks.at(i));
        const double bar_px = room_px * share_of(bars.ticks.at(i), most);
        paint_line(cr, {rect.x, y_px}, style, palette.text, range_of(i, language));
        fill(cr, {rect.x + names_px + cap_px, y_px + 0.4 * cap_px, bar_px, cap_px},
             {palette.outline});
        paint_line(cr, {rect.x + rect.width - line_width_px(cr, style, ticks), y_px}, style,
                   palette.text, ticks);
    }
}

}  // namespace touchline
