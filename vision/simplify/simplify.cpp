#include "vision/simplify/simplify.h"

#include "config/types/map_frame.h"
#include "vision/simplify/breaks.h"
#include "vision/simplify/loops.h"
#include "vision/simplify/parts.h"
#include "vision/simplify/placement.h"
#include "vision/simplify/ranking.h"
#include "vision/simplify/shaping.h"
#include "vision/simplify/spacing.h"
#include "vision/simplify/surroundings.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

constexpr double kSmallBreak_mm = 4.0;
constexpr double kLargeRegion = 0.03;  // of the area
constexpr double kOuterShare = 0.25;   // of a line whose other side looks into the picture
constexpr double kFinestStep_mm = 0.2;
constexpr double kCoarsestStep_mm = 0.5;

/// An outline to be, with what ranked it.
struct Stroke {
    std::size_t line = 0;  // of the ranked ones
    double length_mm = 0.0;
};

/// One detail being filled.
class Selection {
  public:
    Selection(const DetailLimits& limits, cv::Size2d area_mm)
        : limits_(limits),
          area_mm_(area_mm),
          scale_{std::clamp(limits.gap_mm / 16.0, kFinestStep_mm, kCoarsestStep_mm),
                 limits.tolerance_mm, limits.least_feature_mm},
          spaced_(area_mm, limits.gap_mm, scale_.step_mm) {}

    bool is_full() const {
        return static_cast<int>(strokes_.size()) >= limits_.strokes ||
               line_mm_ + limits_.least_stroke_mm > limits_.line_mm;
    }

    /// Adds what of a line may be shown. The first is always kept: where it alone is longer than
    /// all lines may be, it is taken at coarser and coarser scales.
    void add(const RankedLine& ranked, std::size_t number) {
        constexpr double kCoarsest_mm = 50.0;
        ShapingScale scale = scale_;
        while (may_be_shown(ranked) && add_at(scale, ranked.line, number) && strokes_.empty() &&
               scale.tolerance_mm < kCoarsest_mm) {
            scale.tolerance_mm *= 1.5;
            scale.least_feature_mm *= 1.5;
        }
    }

    const std::vector<Stroke>& strokes() const { return strokes_; }

    double line_mm() const { return line_mm_; }

    int crossings_opened() const { return crossings_opened_; }

    std::vector<Chain> lines() const { return spaced_.lines(); }

  private:
    bool may_be_shown(const RankedLine& ranked) const {
        const bool is_outer = ranked.outer_share >= kOuterShare;
        switch (limits_.inner) {
            case InnerLines::none:
                return is_outer;
            case InnerLines::large_regions:
                return is_outer ||
                       held_area(ranked.line) >= kLargeRegion * area_mm_.width * area_mm_.height;
            default:
                return true;
        }
    }

    /// Adds the line at a scale. True: some of it was too long to be added.
    bool add_at(const ShapingScale& scale, const Chain& line, std::size_t number) {
        bool is_too_long = false;
        for (Chain& part : without_self_crossings(shaped(line, scale), limits_.least_stroke_mm)) {
            std::vector<Candidate> open{{std::move(part), false, false}};
            while (!open.empty() && !is_full()) {
                const Candidate candidate = std::move(open.back());
                open.pop_back();
                is_too_long = !add_longest(candidate, number, open) || is_too_long;
            }
        }
        return is_too_long;
    }

    /// Adds the longest stretch of a candidate that fits, what is left to `open`. False: too long.
    bool add_longest(const Candidate& candidate, std::size_t number, std::vector<Candidate>& open) {
        std::optional<Fit> fit = spaced_.fit(candidate);
        const double length_mm = fit ? length_of(fit->line) : 0.0;
        if (length_mm < limits_.least_stroke_mm) {
            return true;
        }
        if (line_mm_ + length_mm > limits_.line_mm) {
            return false;
        }
        std::ranges::move(fit->rest, std::back_inserter(open));
        fit->rest.clear();
        crossings_opened_ += fit->crossings_opened;
        line_mm_ += length_mm;
        strokes_.push_back({number, length_mm});
        spaced_.add(std::move(*fit));
        return true;
    }

    DetailLimits limits_;
    cv::Size2d area_mm_;
    ShapingScale scale_;
    SpacedLines spaced_;
    std::vector<Stroke> strokes_;
    double line_mm_ = 0.0;
    int crossings_opened_ = 0;
};

Selection selected(const std::vector<RankedLine>& order, DetailLimits limits, cv::Size2d area_mm) {
    for (int attempts = 0;; ++attempts) {
        Selection selection(limits, area_mm);
        for (std::size_t i = 0; i < order.size() && !selection.is_full(); ++i) {
            selection.add(order[i], i);
        }
        constexpr int kMostAttempts = 9;
        if (!selection.strokes().empty() || order.empty() || attempts == kMostAttempts) {
            return selection;
        }
        if (limits.inner != InnerLines::all) {
            limits.inner = InnerLines::all;  // nothing lies outside
        } else {
            limits.least_stroke_mm *= 0.5;
        }
    }
}

int drop_frames(std::vector<Chain>& lines, const cv::Rect2d& picture_mm) {
    const auto frames =
        std::ranges::count_if(lines, [&](const Chain& line) { return is_frame(line, picture_mm); });
    if (frames == static_cast<std::ptrdiff_t>(lines.size())) {
        return 0;  // a frame around nothing is the picture
    }
    std::erase_if(lines, [&](const Chain& line) { return is_frame(line, picture_mm); });
    return static_cast<int>(frames);
}

Outline outline_of(const Chain& line, const Area& area) {
    Outline outline;
    outline.is_closed = line.is_closed;
    for (const EdgePoint& point : line.points) {
        const Position p = canonical_point(point.at.x, point.at.y, area);
        if (outline.points.empty() || !(outline.points.back() == p)) {
            outline.points.push_back(p);
        }
    }
    if (outline.is_closed && outline.points.front() == outline.points.back()) {
        outline.points.pop_back();
    }
    return outline;
}

/// The lowest detail, from `detail` down, whose number and length of strokes hold these.
int lowest_detail(int strokes, double line_mm, int detail, const Area& area) {
    for (int lower = 1; lower < detail; ++lower) {
        const DetailLimits limits = limits_for(lower, area);
        if (strokes == 1 || (strokes <= limits.strokes && line_mm <= limits.line_mm)) {
            return lower;
        }
    }
    return detail;
}

void fill(TactileMap& map, const Selection& selection, const std::vector<RankedLine>& order,
          int detail) {
    const std::vector<Chain> lines = selection.lines();
    double line_mm = 0.0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Stroke& stroke = selection.strokes()[i];
        Outline outline = outline_of(lines[i], map.area);
        line_mm += stroke.length_mm;
        outline.weight = order[stroke.line].salience;
        outline.detail = lowest_detail(static_cast<int>(i) + 1, line_mm, detail, map.area);
        outline.id = "outline-" + std::to_string(i + 1);
        map.outlines.push_back(std::move(outline));
    }
    label_by_place(map);
}

}  // namespace

Simplified simplified(const PictureLines& found, const Area& area, int detail, const Zoom& zoom) {
    Simplified result;
    TactileMap& map = result.map;
    SimplifyReport& report = result.report;
    map.area = area_of(view_box_of(area));
    const cv::Size2d area_mm(1000.0 * map.area.width_m, 1000.0 * map.area.height_m);
    const Placement placement(found.picture, found.working, map.area);

    std::vector<Chain> lines = in_zoom(found.chains, placement, map.area, zoom);
    const std::size_t in_pieces = lines.size();
    lines = with_breaks_closed(std::move(lines), kSmallBreak_mm);
    report.breaks_closed = static_cast<int>(in_pieces - lines.size());
    report.frames_dropped =
        drop_frames(lines, picture_in_zoom(placement, found.working, map.area, zoom));
    const std::vector<double> outer = outer_shares(lines, area_mm);
    const std::vector<RankedLine> order = ranked(std::move(lines), outer, found.high);

    const Selection selection = selected(order, limits_for(detail, map.area), area_mm);
    fill(map, selection, order, detail);
    report.parts = static_cast<int>(map.outlines.size());
    report.line_mm = selection.line_mm();
    report.crossings_opened = selection.crossings_opened();
    report.complexity = complexity_of(report.parts, report.line_mm, map.area);
    std::vector<bool> is_shown(order.size(), false);
    for (const Stroke& stroke : selection.strokes()) {
        is_shown[stroke.line] = true;
    }
    report.left_out = static_cast<int>(std::ranges::count(is_shown, false));
    report.words = words_for(map, report, detail);
    return result;
}

}  // namespace touchline
