#include "app/screen/staff_panel.h"

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

std::array<TextRun, 3> runs_of(const StatusLine& line, const Palette& palette) {
    return {TextRun{line.name, palette.name}, TextRun{"  ", palette.text},
            TextRun{line.value, palette.text, true}};
}

/// The title, lines spread over columns that fill one after the other, and the message.
class StatusColumns {
  public:
    StatusColumns(cairo_t* cr, const Rect& rect, const Status& status, double cap_px,
                  const Palette& palette)
        : cr_(cr),
          rect_(inset(rect, panel_gap_caps * cap_px)),
          status_(status),
          cap_px_(cap_px),
          palette_(palette) {
        const double columns = std::floor(rect_.width / (least_column_caps * cap_px));
        columns_ = static_cast<std::size_t>(std::clamp(columns, 1.0, 4.0));
    }

    [[nodiscard]] double height_px() const {
        return title_height_px() + columns_height_px() +
               text_height_px(cr_, rect_.width, cap_px_, message()) +
               2.0 * panel_gap_caps * cap_px_;
    }

    void paint() const {
        paint_text(cr_, {rect_.x, rect_.y}, rect_.width, title_size * cap_px_, title());
        for (std::size_t column = 0; column < columns_; ++column) paint_column(column);
        if (!status_.message.empty())
            paint_text(cr_, {rect_.x, rect_.y + title_height_px() + columns_height_px()},
                       rect_.width, cap_px_, message());
    }

  private:
    [[nodiscard]] std::array<TextRun, 1> title() const {
        return {TextRun{status_.title, palette_.text, true}};
    }

    [[nodiscard]] std::array<TextRun, 1> message() const {
        return {TextRun{status_.message, palette_.alert, true}};
    }

    [[nodiscard]] double title_height_px() const {
        return text_height_px(cr_, rect_.width, title_size * cap_px_, title()) +
               row_gap_caps * cap_px_;
    }

    [[nodiscard]] double columns_height_px() const {
        double tallest = 0.0;
        for (std::size_t column = 0; column < columns_; ++column)
            tallest = std::max(tallest, column_height_px(column));
        return tallest;
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
            height += text_height_px(cr_, column_width_px(), cap_px_, runs_of(line, palette_)) +
                      row_gap_caps * cap_px_;
        return height;
    }

    void paint_column(std::size_t column) const {
        const double width = column_width_px();
        PixelPoint at{rect_.x + static_cast<double>(column) * (width + panel_gap_caps * cap_px_),
                      rect_.y + title_height_px()};
        for (const StatusLine& line : lines_of(column))
            at.y += paint_text(cr_, at, width, cap_px_, runs_of(line, palette_)) +
                    row_gap_caps * cap_px_;
    }

    cairo_t* cr_;
    Rect rect_;
    const Status& status_;
    double cap_px_;
    const Palette& palette_;
    std::size_t columns_ = 1;
};

std::string range_of(std::size_t bar, const Language& language) {
    if (bar < LatenessBars::ends_us.size())
        return language.text("timing", "under {0} µs",
                             {std::to_string(LatenessBars::ends_us.at(bar))});
    return language.text("timing", "later");
}

double bar_length_px(std::uint64_t ticks, std::uint64_t most, double room_px) {
    constexpr double least_px = 2.0;
    if (ticks == 0) return 0.0;
    return std::max(room_px * static_cast<double>(ticks) / static_cast<double>(most), least_px);
}

/// Returns the height left above it.
double paint_timing_below(cairo_t* cr, const Rect& rect, const LatenessBars& bars, double cap_px,
                          const Palette& palette, const Language& language) {
    constexpr double share = 0.35;  // of the panel's height, at most
    cap_px *= std::min(1.0, share * rect.height / timing_chart_height_px(cap_px));
    const double height_px = timing_chart_height_px(cap_px) + cap_px;
    paint_timing(
        cr,
        {rect.x + cap_px, rect.y + rect.height - height_px, rect.width - 2.0 * cap_px, height_px},
        bars, cap_px, palette, language);
    return rect.height - height_px;
}

}  // namespace

double paint_live(cairo_t* cr, const Rect& rect, const LiveContent& live, double cap_px,
                  const Palette& palette, const Language& language) {
    fill(cr, rect, {palette.background});
    Rect words = rect;
    if (live.timing)
        words.height = paint_timing_below(cr, rect, *live.timing, cap_px, palette, language);
    return paint_panel(cr, words, live.status, cap_px, palette);
}

double paint_panel(cairo_t* cr, const Rect& rect, const Status& status, double cap_px,
                   const Palette& palette) {
    fill(cr, rect, {palette.background});
    cap_px = fitting_cap_px(cap_px, rect.height, [&](double cap) {
        return StatusColumns(cr, rect, status, cap, palette).height_px();
    });
    StatusColumns(cr, rect, status, cap_px, palette).paint();
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
        const double bar_px = bar_length_px(bars.ticks.at(i), most, room_px);
        paint_line(cr, {rect.x, y_px}, style, palette.text, range_of(i, language));
        fill(cr, {rect.x + names_px + cap_px, y_px + 0.4 * cap_px, bar_px, cap_px},
             {palette.outline});
        paint_line(cr, {rect.x + rect.width - line_width_px(cr, style, ticks), y_px}, style,
                   palette.text, ticks);
    }
}

}  // namespace touchline
