#include "app/screen/panel.h"

#include "app/screen/paint.h"
#include "app/screen/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace touchline {
namespace {

constexpr double title_size = 1.25;       // times the cap height
constexpr double least_column_caps = 20;  // a column this wide holds the longest line
constexpr double panel_gap_caps = 0.9;    // between columns and around everything
constexpr double row_gap_caps = 0.25;     // below each line
constexpr double least_cap_px = 6.0;

Rect inset(const Rect& rect, double by) {
    return {rect.x + by, rect.y + by, std::max(rect.width - 2.0 * by, 1.0),
            std::max(rect.height - 2.0 * by, 1.0)};
}

/// The largest cap height up to `cap_px` at which `height_at` fits; shrinks in steps of 6 %.
template <class HeightAt>
double fitting_cap_px(double cap_px, double room_px, const HeightAt& height_at) {
    constexpr double step = 0.94;
    while (cap_px > least_cap_px && height_at(cap_px) > room_px) cap_px *= step;
    return cap_px;
}

std::array<TextRun, 3> runs_of(const StatusLine& line) {
    return {TextRun{line.name, white_on_black.name}, TextRun{"  "},
            TextRun{line.value, white_on_black.text, true}};
}

/// Lines spread over columns, filled one after the other.
class StatusColumns {
  public:
    StatusColumns(cairo_t* cr, const Rect& rect, const Status& status, double cap_px)
        : cr_(cr), rect_(inset(rect, panel_gap_caps * cap_px)), status_(status), cap_px_(cap_px) {
        const double columns = std::floor(rect_.width / (least_column_caps * cap_px));
        columns_ = static_cast<std::size_t>(std::clamp(columns, 1.0, 4.0));
    }

    [[nodiscard]] double height_px() const {
        double tallest = 0.0;
        for (std::size_t column = 0; column < columns_; ++column)
            tallest = std::max(tallest, column_height_px(column));
        return title_height_px() + tallest + 2.0 * panel_gap_caps * cap_px_;
    }

    void paint() const {
        paint_text(cr_, {rect_.x, rect_.y}, rect_.width, title_size * cap_px_, title());
        for (std::size_t column = 0; column < columns_; ++column) paint_column(column);
    }

  private:
    [[nodiscard]] std::array<TextRun, 1> title() const {
        return {TextRun{status_.title, white_on_black.text, true}};
    }

    [[nodiscard]] double title_height_px() const {
        return text_height_px(cr_, rect_.width, title_size * cap_px_, title()) +
               row_gap_caps * cap_px_;
    }

    [[nodiscard]] double column_width_px() const {
        const double gaps = panel_gap_caps * cap_px_ * static_cast<double>(columns_ - 1);
        return (rect_.width - gaps) / static_cast<double>(columns_);
    }

    [[nodiscard]] std::span<const StatusLine> lines_of(std::size_t column) const {
        const std::size_t each = (status_.lines.size() + columns_ - 1) / columns_;
        const std::size_t first = std::min(column * each, status_.lines.size());
        return std::span(status_.lines)
            .subspan(first, std::min(each, status_.lines.size() - first));
    }

    [[nodiscard]] double column_height_px(std::size_t column) const {
        double height = 0.0;
        for (const StatusLine& line : lines_of(column))
            height += text_height_px(cr_, column_width_px(), cap_px_, runs_of(line)) +
                      row_gap_caps * cap_px_;
        return height;
    }

    void paint_column(std::size_t column) const {
        const double width = column_width_px();
        PixelPoint at{rect_.x + static_cast<double>(column) * (width + panel_gap_caps * cap_px_),
                      rect_.y + title_height_px()};
        for (const StatusLine& line : lines_of(column))
            at.y += paint_text(cr_, at, width, cap_px_, runs_of(line)) + row_gap_caps * cap_px_;
    }

    cairo_t* cr_;
    Rect rect_;
    const Status& status_;
    double cap_px_;
    std::size_t columns_ = 1;
};

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

double paint_panel(cairo_t* cr, const Rect& rect, const Status& status, double cap_px) {
    fill(cr, rect, {white_on_black.background});
    cap_px = fitting_cap_px(cap_px, rect.height, [&](double cap) {
        return StatusColumns(cr, rect, status, cap).height_px();
    });
    StatusColumns(cr, rect, status, cap_px).paint();
    return cap_px;
}

double paint_message(cairo_t* cr, const Rect& rect, const std::string& message, double cap_px) {
    const std::array<TextRun, 1> runs{TextRun{message, white_on_black.alert, true}};
    const auto height_at = [&](double cap) {
        return text_height_px(cr, inset(rect, panel_gap_caps * cap).width, cap, runs) +
               2.0 * row_gap_caps * cap;
    };
    cap_px = fitting_cap_px(cap_px, rect.height / 2.0, height_at);
    const double height = height_at(cap_px);
    const Rect band{rect.x, rect.y + rect.height - height, rect.width, height};
    fill(cr, band, {white_on_black.background, 0.92});
    paint_text(cr, {band.x + panel_gap_caps * cap_px, band.y + row_gap_caps * cap_px},
               inset(rect, panel_gap_caps * cap_px).width, cap_px, runs);
    return cap_px;
}

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
