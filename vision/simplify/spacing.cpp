#include "vision/simplify/spacing.h"

#include "vision/contour/rings.h"
#include "vision/simplify/surroundings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace touchline {
namespace {

constexpr double apart_along = 4.0;    // gaps: nearer along the line is a bend, not two lines
constexpr double hairpin_along = 2.0;  // gaps: further may be there and back on parallel ways
constexpr double parallel = 0.985;     // cosine of 10 degrees
constexpr double straight_slack_mm =
    0.5;  // the way along two straight sides minus that by the corner

/// Returns whether a segment leads back along another.
bool leads_back(cv::Point2d way, const LineSegment& other) {
    const cv::Point2d along = other.b - other.a;
    return way.dot(along) < -parallel * cv::norm(way) * cv::norm(along);
}

/// Finds places that lie on the two straight sides of one corner, which may be as sharp as it is
/// drawn.
class Corners {
  public:
    /// `around_mm` is a ring's length; 0 for an open line.
    Corners(const std::vector<EdgePoint>& points, const std::vector<double>& at_mm,
            double around_mm)
        : points_(points), at_mm_(at_mm), around_mm_(around_mm) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i].is_fixed) corners_.push_back(i);
        }
    }

    /// Returns whether the way from one point to another is straight except for one corner.
    [[nodiscard]] bool is_round_one(std::size_t from, std::size_t to) const {
        return std::ranges::any_of(corners_, [&](std::size_t corner) {
            const double straight_mm = distance(points_[from].at, points_[corner].at) +
                                       distance(points_[corner].at, points_[to].at);
            return way_mm(from, corner, to) - straight_mm < straight_slack_mm;
        });
    }

  private:
    /// Returns the way along the line from the one point past the corner to the other; infinite if
    /// the corner lies elsewhere.
    [[nodiscard]] double way_mm(std::size_t from, std::size_t corner, std::size_t to) const {
        const auto [low, high] = std::minmax(at_mm_[from], at_mm_[to]);
        const double between_mm = high - low;
        const bool is_between = at_mm_[corner] >= low && at_mm_[corner] <= high;
        if (is_between) return between_mm;
        return around_mm_ > 0.0 ? around_mm_ - between_mm : std::numeric_limits<double>::infinity();
    }

    const std::vector<EdgePoint>& points_;
    const std::vector<double>& at_mm_;
    double around_mm_;
    std::vector<std::size_t> corners_;
};

constexpr double crossing_opening_mm = 2.5;  // on each side of a crossing
constexpr double same_place_mm = 1e-9;
constexpr double short_line_mm = 1e-3;  // a thousand times the grid of a map; no finger feels it

/// Sorts feet in the order in which they lie along their line.
void sort_along(const std::vector<EdgePoint>& line, std::vector<LineFoot>& feet) {
    std::ranges::stable_sort(feet, {}, [&](const LineFoot& foot) {
        return std::pair(foot.index, distance(foot.at, line[foot.index].at));
    });
}

}  // namespace

LineSegment segment_of(const Chain& line, std::size_t i, std::size_t number) {
    return {line.points[i].at, line.points[(i + 1) % line.points.size()].at, number, i};
}

std::size_t segments_of(const Chain& line) {
    return line.points.size() - (line.is_closed ? 0 : 1);
}

OwnStretch clear_of_itself(const std::vector<EdgePoint>& points, std::size_t first,
                           std::size_t last, const SpacingScale& scale) {
    SegmentGrid own(scale.area_mm, 0.5 * scale.gap_mm);
    const std::vector<double> at_mm = arc_lengths(points);
    const Corners corners(points, at_mm, 0.0);
    for (std::size_t i = first + 1; i <= last; ++i) {
        const cv::Point2d p = points[i].at;
        double least_mm = scale.clearance_mm();
        std::optional<OwnStretch::Foot> foot;
        bool is_hairpin = false;
        own.near(p, p, scale.clearance_mm(), [&](const LineSegment& before) {
            const cv::Point2d on = nearest_on(before, p);
            const double apart_mm = distance(on, p);
            const double along_mm = at_mm[i] - at_mm[before.index + 1];
            if (along_mm > apart_along * scale.gap_mm - 2.0 * scale.step_mm &&
                apart_mm < least_mm && !corners.is_round_one(before.index, i)) {
                least_mm = apart_mm;
                foot = {on, before.index};
            }
            is_hairpin =
                is_hairpin || (along_mm > hairpin_along * scale.gap_mm && apart_mm < scale.gap_mm &&
                               leads_back(p - points[i - 1].at, before));
        });
        if (foot || is_hairpin) return {first, i - 1, at_mm[i - 1] - at_mm[first], foot};
        own.add({points[i - 1].at, p, 0, i - 1});
    }
    return {first, last, at_mm[last] - at_mm[first], std::nullopt};
}

std::optional<std::size_t> too_near_itself(const Chain& ring, const SpacingScale& scale) {
    SegmentGrid own(scale.area_mm, 0.5 * scale.gap_mm);
    for (std::size_t i = 0; i < segments_of(ring); ++i) own.add(segment_of(ring, i, 0));
    const std::vector<double> at_mm = arc_lengths(ring.points);
    const double around_mm = length_of(ring);
    const Corners corners(ring.points, at_mm, around_mm);
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const cv::Point2d p = ring.points[i].at;
        bool is_near = false;
        own.near(p, p, scale.clearance_mm(), [&](const LineSegment& other) {
            const double there_mm = std::abs(at_mm[i] - at_mm[other.index]);
            const double along_mm = std::min(there_mm, around_mm - there_mm);
            const double apart_mm = distance(nearest_on(other, p), p);
            const cv::Point2d way = ring.points[(i + 1) % ring.points.size()].at - p;
            is_near = is_near ||
                      (along_mm > apart_along * scale.gap_mm - 2.0 * scale.step_mm &&
                       apart_mm < scale.clearance_mm() && !corners.is_round_one(other.index, i)) ||
                      (along_mm > hairpin_along * scale.gap_mm && apart_mm < scale.gap_mm &&
                       leads_back(way, other));
        });
        if (is_near) return i;
    }
    return std::nullopt;
}

SpacedLines::SpacedLines(cv::Size2d area_mm, double gap_mm, double step_mm)
    : scale_{area_mm, gap_mm, step_mm}, grid_(area_mm, 0.5 * gap_mm) {}

std::optional<SpacedLines::Near> SpacedLines::nearest(cv::Point2d p, double reach_mm) const {
    std::optional<Near> best;
    grid_.near(p, p, reach_mm, [&](const LineSegment& segment) {
        const cv::Point2d foot = nearest_on(segment, p);
        const double apart_mm = distance(foot, p);
        if (apart_mm < reach_mm && (!best || apart_mm < best->distance_mm)) {
            best = {apart_mm, {foot, segment.line, segment.index}};
        }
    });
    return best;
}

std::optional<OwnStretch> SpacedLines::longest(const std::vector<EdgePoint>& points) const {
    std::optional<OwnStretch> best;
    std::size_t first = 0;
    while (first < points.size()) {
        if (nearest(points[first].at, scale_.clearance_mm())) {
            ++first;
            continue;
        }
        std::size_t last = first;
        while (last + 1 < points.size() && !nearest(points[last + 1].at, scale_.clearance_mm())) {
            ++last;
        }
        for (std::size_t from = first; from < last;) {
            const OwnStretch stretch = clear_of_itself(points, from, last, scale_);
            if (!best || stretch.length_mm > best->length_mm) best = stretch;
            from = stretch.last + 1;
        }
        first = last + 1;
    }
    return best && best->length_mm > 0.0 ? best : std::nullopt;
}

/// Returns whether a ring and everything near it are shapes beside one another that a finger can
/// tell apart.
bool SpacedLines::stands_beside(const Chain& ring) const {
    double least_mm = std::numeric_limits<double>::infinity();
    std::set<std::size_t> neighbours;
    for (const EdgePoint& p : ring.points) {
        grid_.near(p.at, p.at, scale_.clearance_mm(), [&](const LineSegment& segment) {
            least_mm = std::min(least_mm, distance(nearest_on(segment, p.at), p.at));
            neighbours.insert(segment.line);
        });
    }
    return least_mm > least_apart_mm + 0.5 * scale_.step_mm &&
           std::ranges::all_of(neighbours, [&](std::size_t number) {
               const Chain& other = lines_[number];
               return other.is_closed && !holds(other, ring.points[0].at) &&
                      !holds(ring, other.points[0].at);
           });
}

/// Returns a ring cut open at its first point that something is in the way of; nothing if it is
/// clear.
std::optional<Candidate> SpacedLines::opened(const Chain& ring) const {
    std::vector<EdgePoint> points = ring.points;
    const auto blocked = std::ranges::find_if(points, [&](const EdgePoint& p) {
        return nearest(p.at, scale_.clearance_mm()).has_value();
    });
    if (blocked != points.end() && !stands_beside(ring)) {
        std::ranges::rotate(points, blocked);
    } else if (const auto own = too_near_itself(ring, scale_)) {
        begin_at(*own, points);
    } else {
        return std::nullopt;
    }
    points.push_back(points.front());
    return Candidate{{std::move(points), false, ring.width_px}, true, true};
}

/// Returns whether the line, from a point on and in one direction, crosses another and goes on for
/// more than a small break while it is in its way.
bool SpacedLines::crosses_on(const std::vector<EdgePoint>& points, std::size_t from,
                             int step) const {
    bool is_crossed = false;
    double after_mm = 0.0;
    const auto end = step > 0 ? points.size() - 1 : std::size_t{0};
    for (std::size_t i = from; i != end; i += static_cast<std::size_t>(step)) {
        const LineSegment piece{points[i].at, points[i + static_cast<std::size_t>(step)].at, 0, 0};
        if (is_crossed) after_mm += distance(piece.a, piece.b);
        grid_.near(piece.a, piece.b, 0.0, [&](const LineSegment& other) {
            is_crossed = is_crossed || crossing_of(piece, other).has_value();
        });
        if (!nearest(piece.b, scale_.clearance_mm())) return is_crossed;
    }
    return is_crossed && after_mm > small_break_mm;
}

/// Leads a line straight on from its end, unless that would cross the line itself.
bool SpacedLines::append(cv::Point2d to, std::vector<EdgePoint>& line) const {
    const EdgePoint from = line.back();
    const cv::Point2d way = to - from.at;
    const LineSegment inner{from.at + 1e-3 * way, from.at + 0.999 * way, 0, 0};
    const LineSegment beginning{from.at, inner.a, 0, 0};
    for (std::size_t i = 1; i < line.size(); ++i) {
        const LineSegment piece{line[i - 1].at, line[i].at, 0, 0};
        if (crossing_of(piece, inner)) return false;
        // All segments except the last, from which it goes on, must be clear of its first step as
        // well.
        const auto at = i + 1 < line.size() ? crossing_of(piece, beginning) : std::nullopt;
        if (at && distance(*at, from.at) > same_place_mm) return false;
    }
    const int parts = std::max(1, static_cast<int>(std::ceil(cv::norm(way) / scale_.step_mm)));
    for (int k = 1; k < parts; ++k) {
        line.push_back({from.at + (static_cast<double>(k) / parts) * way, from.strength});
    }
    line.push_back({to, from.strength, true});
    return true;
}

/// Returns a segment of a line that was added, in the pieces that a map has: between the feet on
/// it, including those of `fit`.
std::vector<LineSegment> SpacedLines::pieces(const LineSegment& segment, const Fit& fit) const {
    std::vector<LineFoot> feet = feet_[segment.line];
    for (const std::optional<LineFoot>& foot : {fit.front, fit.back}) {
        if (foot && foot->line == segment.line) feet.push_back(*foot);
    }
    std::erase_if(feet, [&](const LineFoot& foot) { return foot.index != segment.index; });
    sort_along(lines_[segment.line].points, feet);
    std::vector<LineSegment> result;
    cv::Point2d from = segment.a;
    for (const LineFoot& foot : feet) {
        result.push_back({from, foot.at, segment.line, segment.index});
        from = foot.at;
    }
    result.push_back({from, segment.b, segment.line, segment.index});
    return result;
}

/// Returns whether, on the grid of a map, the feet of `fit` lead it across a line, or bend a line
/// across another.
bool SpacedLines::crosses_in_map(const Fit& fit) const {
    const std::vector<EdgePoint>& points = fit.line.points;
    std::vector<LineSegment> changed;
    const auto change = [&](const std::optional<LineFoot>& foot, const LineSegment& end) {
        if (foot && foot->line < lines_.size()) {
            changed.push_back(end);
            std::ranges::move(pieces(segment_of(lines_[foot->line], foot->index, foot->line), fit),
                              std::back_inserter(changed));
        }
    };
    change(fit.front, {points[0].at, points[1].at});
    change(fit.back, {points[points.size() - 2].at, points.back().at});
    return std::ranges::any_of(changed, [&](const LineSegment& piece) {
        bool is_crossed = false;
        grid_.near(piece.a, piece.b, short_line_mm, [&](const LineSegment& other) {
            is_crossed = is_crossed ||
                         std::ranges::any_of(pieces(other, fit), [&](const LineSegment& there) {
                             return cross_on_map_grid(piece, there);
                         });
        });
        return is_crossed;
    });
}

/// Makes the end of `fit.line` that was led to a foot, coming `from` there, meet the line.
void SpacedLines::meet(const LineFoot& foot, cv::Point2d from, int step, Fit& fit) const {
    std::optional<LineFoot>& met = step > 0 ? fit.back : fit.front;
    met = foot;
    if (crosses_in_map(fit)) {
        met.reset();
        EdgePoint& end = step > 0 ? fit.line.points.back() : fit.line.points.front();
        end.at += (from - foot.at) * (short_line_mm / distance(from, foot.at));
    }
}

/// Leads the end of `fit.line` that came from points[at] to the line in its way.
void SpacedLines::bridge(const std::vector<EdgePoint>& points, std::size_t at, int step,
                         bool goes_on, Fit& fit) const {
    const bool is_line_end = at == (step > 0 ? points.size() - 1 : 0);
    const EdgePoint from = points[at];
    const std::optional<Near> near = nearest(from.at, scale_.clearance_mm() + 2.0 * scale_.step_mm);
    if (is_line_end || !near) return;
    const bool is_opened = crosses_on(points, at, step);
    std::size_t beyond = at + static_cast<std::size_t>(step);
    while (beyond != (step > 0 ? points.size() - 1 : 0) &&
           nearest(points[beyond].at, scale_.clearance_mm())) {
        beyond += static_cast<std::size_t>(step);
    }
    const std::optional<Near> end = nearest(points[beyond].at, scale_.clearance_mm());
    if (!is_opened && !goes_on && end && end->distance_mm > small_break_mm) {
        return;  // it ends by itself, well before the other
    }
    const cv::Point2d to = is_opened ? near->foot.at + (from.at - near->foot.at) *
                                                           (crossing_opening_mm / near->distance_mm)
                                     : near->foot.at;
    std::vector<EdgePoint>& line = fit.line.points;
    if (step < 0) std::ranges::reverse(line);
    const bool is_led = append(to, line);
    if (step < 0) std::ranges::reverse(line);
    if (!is_led) return;
    if (is_opened) {
        ++fit.crossings_opened;
    } else {
        meet(near->foot, from.at, step, fit);
    }
}

std::optional<Fit> SpacedLines::fit(const Candidate& candidate) const {
    const Chain& chain = candidate.line;
    if (chain.is_closed) {
        const std::optional<Candidate> open = opened(chain);
        return open ? fit(*open) : Fit{chain, {}, {}, 0, {}};
    }
    const std::vector<EdgePoint>& points = chain.points;
    const std::optional<OwnStretch> best = longest(points);
    if (!best) return std::nullopt;
    const auto at = [&](std::size_t i) { return points.begin() + static_cast<std::ptrdiff_t>(i); };
    Fit fit{{{at(best->first), at(best->last) + 1}, false, chain.width_px}, {}, {}, 0, {}};
    if (best->foot && append(best->foot->at, fit.line.points)) {
        fit.back = LineFoot{best->foot->at, lines_.size(), best->foot->index - best->first};
    } else if (!best->foot) {
        bridge(points, best->last, 1, candidate.back_goes_on, fit);
    }
    const std::size_t before = fit.line.points.size();
    bridge(points, best->first, -1, candidate.front_goes_on, fit);
    if (fit.back && fit.back->line == lines_.size()) {
        fit.back->index += fit.line.points.size() - before;
    }
    fit.rest.push_back(
        {{{at(0), at(best->first) + 1}, false, chain.width_px}, candidate.front_goes_on, true});
    fit.rest.push_back(
        {{{at(best->last), points.end()}, false, chain.width_px}, true, candidate.back_goes_on});
    return fit;
}

void SpacedLines::add(Fit fit) {
    const std::size_t number = lines_.size();
    for (std::size_t i = 0; i < segments_of(fit.line); ++i) {
        grid_.add(segment_of(fit.line, i, number));
    }
    lines_.push_back(std::move(fit.line));
    feet_.emplace_back();
    for (const std::optional<LineFoot>& foot : {fit.front, fit.back}) {
        if (foot) feet_[foot->line].push_back(*foot);
    }
}

std::vector<Chain> SpacedLines::lines() const {
    std::vector<Chain> result = lines_;
    for (std::size_t i = 0; i < result.size(); ++i) {
        std::vector<LineFoot> feet = feet_[i];
        std::vector<EdgePoint>& points = result[i].points;
        const std::vector<EdgePoint> old = points;
        sort_along(old, feet);
        points.clear();
        auto foot = feet.begin();
        for (std::size_t k = 0; k < old.size(); ++k) {
            points.push_back(old[k]);
            for (; foot != feet.end() && foot->index == k; ++foot) {
                points.push_back({foot->at, old[k].strength, true});
            }
        }
    }
    return result;
}

}  // namespace touchline
