#include "vision/simplify/selection.h"

#include "config/types/map_bytes.h"
#include "vision/simplify/surroundings.h"
#include "vision/simplify/zoom.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

// About once round a thing of a hand's size: longer counts little more.
constexpr double salient_length_mm = 150.0;
constexpr double open_factor = 2.0 / 3.0;
constexpr double inside_factor = 0.7;
constexpr double least_strength = 1e-6;  // of `high`: the part of a border in a zoom may have none

double salience_of(const Chain& line, double outer_share, double high) {
    double sum = 0.0;
    for (const EdgePoint& p : line.points) sum += p.strength;
    const double r = std::max(least_strength, sum / static_cast<double>(line.points.size()) / high);
    const double length = 1.0 - std::exp(-length_of(line) / salient_length_mm);
    const double salience = r / (1.0 + r) * length * (line.is_closed ? 1.0 : open_factor) *
                            (inside_factor + (1.0 - inside_factor) * outer_share);
    return std::max(MapLimits::least_weight, salience);
}

constexpr double large_region = 0.03;       // of the area
constexpr double least_outer_share = 0.25;  // of a line whose other side looks into the picture
constexpr double finest_step_mm = 0.2;
constexpr double coarsest_step_mm = 0.5;
// Times all lines: a longer ring is a maze, and splitting it shows no more.
constexpr double lengths = 3.0;
constexpr double bold_over_gap = 1.1;  // gaps: so that smoothing leaves a gap

/// Returns a ring whose too narrow parts are single lines, the longest last.
std::vector<Candidate> narrow_as_lines(const Chain& ring, double gap_mm, Narrow first,
                                       const ShapingScale& scale, cv::Size2d area_mm) {
    std::vector<Candidate> result;
    for (const Chain& part : parted_where_narrow(ring, bold_over_gap * gap_mm, first)) {
        result.push_back({within(shaped(part, scale), area_mm), !part.is_closed, !part.is_closed});
    }
    std::ranges::reverse(result);
    return result;
}

/// A figure is recognized by its limbs.
DetailLimits for_rings(DetailLimits limits) {
    constexpr double ring_tolerance_mm = 0.7;
    constexpr double ring_feature_mm = 6.0;
    limits.gap_mm = std::min(limits.gap_mm, least_apart_mm);
    limits.tolerance_mm = std::min(limits.tolerance_mm, ring_tolerance_mm);
    limits.least_feature_mm = std::min(limits.least_feature_mm, ring_feature_mm);
    return limits;
}

/// Returns what to add as line `number`, with a point where its end meets itself.
Chain with_own_foot(const Fit& fit, std::size_t number) {
    Chain line = fit.line;
    if (fit.back && fit.back->line == number) {
        const auto after = static_cast<std::ptrdiff_t>(fit.back->index) + 1;
        line.points.insert(line.points.begin() + after, {fit.back->at, 0.0, true});
    }
    return line;
}

}  // namespace

std::vector<RankedLine> ranked(std::vector<Chain> lines, const std::vector<double>& outer_shares,
                               double high) {
    std::vector<RankedLine> order;
    order.reserve(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double salience = salience_of(lines[i], outer_shares[i], high);
        order.push_back({std::move(lines[i]), salience, outer_shares[i]});
    }
    std::ranges::stable_sort(order, std::ranges::greater{}, &RankedLine::salience);
    return order;
}

Selection::Selection(const DetailLimits& limits, cv::Size2d area_mm)
    : limits_(limits),
      area_mm_(area_mm),
      scale_{std::clamp(limits.gap_mm / 16.0, finest_step_mm, coarsest_step_mm),
             limits.tolerance_mm, limits.least_feature_mm},
      spaced_(area_mm, limits.gap_mm, scale_.step_mm) {}

void Selection::go_on_with(const DetailLimits& limits) {
    limits_ = limits;
    scale_.tolerance_mm = limits.tolerance_mm;
    scale_.least_feature_mm = limits.least_feature_mm;
    spaced_.set_gap(limits.gap_mm);
}

bool Selection::is_full() const {
    return static_cast<int>(strokes_.size()) >= limits_.strokes ||
           line_mm_ + limits_.least_stroke_mm > limits_.line_mm;
}

void Selection::add(const RankedLine& ranked, std::size_t number) {
    constexpr double coarsest_tolerance_mm = 50.0;
    ShapingScale scale = scale_;
    while (may_be_shown(ranked) && add_at(scale, ranked.line, number) && strokes_.empty() &&
           scale.tolerance_mm < coarsest_tolerance_mm) {
        scale.tolerance_mm *= 1.5;
        scale.least_feature_mm *= 1.5;
    }
}

bool Selection::may_be_shown(const RankedLine& ranked) const {
    const bool is_outer = ranked.outer_share >= least_outer_share || ranked.line.of == LineOf::ring;
    switch (limits_.inner) {
        case InnerLines::none:
            return is_outer;
        case InnerLines::large_regions:
            return is_outer ||
                   held_area(ranked.line) >= large_region * area_mm_.width * area_mm_.height;
        default:
            return true;
    }
}

/// Adds the line at a scale. Returns true if some of it was too long to be added.
bool Selection::add_at(const ShapingScale& scale, const Chain& line, std::size_t number) {
    bool is_too_long = false;
    // Smoothing may lead a line along the rim a little beyond it.
    const Chain smooth = within(shaped(line, scale), area_mm_);
    for (const Chain& part : without_self_crossings(smooth, limits_.least_stroke_mm)) {
        const bool needs_parting = part.is_closed && length_of(part) < lengths * limits_.line_mm &&
                                   too_near_itself(part, spaced_.scale());
        const bool was_too_long =
            needs_parting ? add_ring(scale, part, number) : add_all({{part, false, false}}, number);
        is_too_long = is_too_long || was_too_long;
    }
    return is_too_long;
}

/// Cuts a ring that comes too near to itself there, or splits it where it is narrow, in one of two
/// ways: whichever shows most of it.
bool Selection::add_ring(const ShapingScale& scale, const Chain& ring, std::size_t number) {
    Selection best = *this;
    const bool is_too_long = best.add_all({{ring, false, false}}, number);
    for (const Narrow first : {Narrow::parts, Narrow::bays}) {
        Selection parted = *this;
        parted.add_all(narrow_as_lines(ring, limits_.gap_mm, first, scale, area_mm_), number);
        if (worth(parted, ring) > worth(best, ring)) best = std::move(parted);
    }
    *this = std::move(best);
    return is_too_long;
}

/// Adds candidates, the last first. Returns true if some of it was too long.
bool Selection::add_all(std::vector<Candidate> open, std::size_t number) {
    bool is_too_long = false;
    while (!open.empty() && !is_full()) {
        const Candidate candidate = std::move(open.back());
        open.pop_back();
        is_too_long = !add_longest(candidate, number, open) || is_too_long;
    }
    return is_too_long;
}

/// Returns how much of a line a way of adding it shows: the share of its points within a gap of
/// which a finger meets something, less for each further piece to be found.
double Selection::worth(const Selection& after, const Chain& line) const {
    constexpr double pieces_cost = 0.1;  // all that there may be
    const auto shown = std::ranges::count_if(line.points, [&](const EdgePoint& p) {
        return after.spaced_.has_near(p.at, limits_.gap_mm);
    });
    const auto pieces = static_cast<double>(after.strokes_.size() - strokes_.size());
    return static_cast<double>(shown) / static_cast<double>(line.points.size()) -
           pieces_cost * pieces / limits_.strokes;
}

/// Lines that lead back along themselves, and middle lines that come back over themselves beyond a
/// junction, may cross themselves only once they are shown; those go in parts to `open`. A
/// candidate that only its bridges lead across itself is not shown.
void Selection::add_parts(const Candidate& candidate, std::vector<Candidate>& open) {
    if (!crosses_itself_in_map(candidate.line)) return;
    std::vector<Chain> parts = without_crossings_in_map(candidate.line);
    std::ranges::reverse(parts);  // the longest last, which is next
    for (Chain& part : parts) {
        open.push_back({std::move(part), candidate.front_goes_on, candidate.back_goes_on});
    }
}

/// Adds the longest stretch of a candidate that fits, and puts the rest into `open`. Returns false
/// if it is too long.
bool Selection::add_longest(const Candidate& candidate, std::size_t number,
                            std::vector<Candidate>& open) {
    std::optional<Fit> fit = spaced_.fit(candidate);
    const double length_mm = fit ? length_of(fit->line) : 0.0;
    if (length_mm < limits_.least_stroke_mm) return true;
    if (line_mm_ + length_mm > limits_.line_mm) return false;
    if (crosses_itself_in_map(with_own_foot(*fit, strokes_.size()))) {
        add_parts(candidate, open);
        return true;
    }
    std::ranges::move(fit->rest, std::back_inserter(open));
    fit->rest.clear();
    crossings_opened_ += fit->crossings_opened;
    line_mm_ += length_mm;
    strokes_.push_back({number, length_mm});
    spaced_.add(std::move(*fit));
    return true;
}

Selection selected(const std::vector<RankedLine>& order, DetailLimits limits, cv::Size2d area_mm) {
    for (int attempts = 0;; ++attempts) {
        Selection selection(for_rings(limits), area_mm);
        std::size_t i = 0;
        for (; i < order.size() && order[i].line.of == LineOf::ring; ++i) {
            selection.add(order[i], i);
        }
        selection.go_on_with(limits);
        for (; i < order.size() && !selection.is_full(); ++i) selection.add(order[i], i);
        constexpr int most_attempts = 9;
        if (!selection.strokes().empty() || order.empty() || attempts == most_attempts) {
            return selection;
        }
        if (limits.inner != InnerLines::all) {
            limits.inner = InnerLines::all;  // nothing lies outside
        } else {
            limits.least_stroke_mm *= 0.5;
        }
    }
}

}  // namespace touchline
