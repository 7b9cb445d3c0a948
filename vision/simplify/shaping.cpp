#include "vision/simplify/shaping.h"

#include "config/types/angle.h"
#include "vision/simplify/segment_grid.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace touchline {
namespace {

constexpr double least_turn = radians(40.0);

/// A polyline by its arc length. `is_ring`: the last point is the first again.
class Course {
  public:
    Course(const std::vector<EdgePoint>& points, bool is_ring)
        : points_(points), is_ring_(is_ring), at_mm_(arc_lengths(points)) {}

    double length_mm() const { return at_mm_.back(); }

    /// Returns the turn at a point between the chords over `reach_mm` before and after (less beside
    /// an end).
    double turn_at(std::size_t i, double reach_mm) const {
        const cv::Point2d here = points_[i].at;
        const cv::Point2d in = here - place(at_mm_[i] - reach_mm);
        const cv::Point2d out = place(at_mm_[i] + reach_mm) - here;
        return in == cv::Point2d() || out == cv::Point2d() ? 0.0 : angle_between(in, out);
    }

    double apart_mm(std::size_t i, std::size_t j) const {
        const double along = std::abs(at_mm_[i] - at_mm_[j]);
        return is_ring_ ? std::min(along, length_mm() - along) : along;
    }

  private:
    cv::Point2d place(double s_mm) const {
        if (is_ring_) s_mm -= length_mm() * std::floor(s_mm / length_mm());
        const auto next = std::upper_bound(at_mm_.begin(), at_mm_.end(), s_mm);
        if (next == at_mm_.begin()) return points_.front().at;
        if (next == at_mm_.end()) return points_.back().at;
        const auto i = static_cast<std::size_t>(next - at_mm_.begin());
        const double t = (s_mm - at_mm_[i - 1]) / (at_mm_[i] - at_mm_[i - 1]);
        return points_[i - 1].at + t * (points_[i].at - points_[i - 1].at);
    }

    const std::vector<EdgePoint>& points_;
    bool is_ring_;
    std::vector<double> at_mm_;
};

/// Returns which inner points are corners at this scale, in order.
std::vector<std::size_t> corners_of(const std::vector<EdgePoint>& points, bool is_ring,
                                    double least_feature_mm) {
    const Course course(points, is_ring);
    std::vector<std::pair<double, std::size_t>> found;
    for (std::size_t i = is_ring ? 0 : 1; i + 1 < points.size(); ++i) {
        if (points[i].is_fixed) {
            const double turn = course.turn_at(i, 0.5 * least_feature_mm);
            if (turn > least_turn) found.emplace_back(turn, i);
        }
    }
    std::ranges::stable_sort(found, std::ranges::greater{}, &std::pair<double, std::size_t>::first);
    std::vector<std::size_t> kept;
    for (const auto& [turn, i] : found) {
        if (std::ranges::all_of(kept, [&, here = i](std::size_t j) {
                return course.apart_mm(here, j) >= 0.25 * least_feature_mm;
            })) {
            kept.push_back(i);
        }
    }
    std::ranges::sort(kept);
    return kept;
}

std::vector<double> gaussian(double sigma_steps) {
    const int reach = static_cast<int>(std::ceil(3.0 * sigma_steps));
    std::vector<double> weights;
    double sum = 0.0;
    for (int k = -reach; k <= reach; ++k) {
        weights.push_back(std::exp(-0.5 * k * k / (sigma_steps * sigma_steps)));
        sum += weights.back();
    }
    for (double& w : weights) w /= sum;
    return weights;
}

/// Returns a sample of a run, continued beyond its ends: round and round, or turned about the end
/// points.
cv::Point2d continued(const std::vector<EdgePoint>& run, bool is_ring, int i) {
    const int last = static_cast<int>(run.size()) - 1;
    if (is_ring) {  // the last is the first again
        return run[static_cast<std::size_t>((i % last + last) % last)].at;
    }
    const auto within = [&](int k) {
        return run[static_cast<std::size_t>(std::clamp(k, 0, last))].at;
    };
    if (i < 0) return 2.0 * run.front().at - within(-i);
    return i > last ? 2.0 * run.back().at - within(2 * last - i) : within(i);
}

/// Returns one run between two corners (or a whole ring) with even points, smoothed.
std::vector<EdgePoint> smooth_run(const std::vector<EdgePoint>& run, bool is_ring,
                                  const ShapingScale& scale) {
    const double length_mm = length_of({run, false});
    const int n =
        std::max(is_ring ? 8 : 1, static_cast<int>(std::lround(length_mm / scale.step_mm)));
    std::vector<EdgePoint> even = evenly_spaced(run, n);
    // Near the ends of a short run only the ends themselves are left to average.
    const double sigma_steps = std::min(scale.tolerance_mm * n / length_mm, n / 6.0);
    std::vector<EdgePoint> smooth = even;
    for (EdgePoint& p : smooth) p.is_fixed = false;
    if (sigma_steps >= 0.3) {
        const std::vector<double> weights = gaussian(sigma_steps);
        const int reach = static_cast<int>(weights.size()) / 2;
        for (int i = 0; i <= n; ++i) {
            cv::Point2d sum;
            for (int k = -reach; k <= reach; ++k) {
                sum +=
                    weights[static_cast<std::size_t>(k + reach)] * continued(even, is_ring, i + k);
            }
            smooth[static_cast<std::size_t>(i)].at = sum;
        }
    }
    if (!is_ring) {
        smooth.front() = even.front();
        smooth.back() = even.back();
    }
    return smooth;
}

constexpr double crossing_cell_mm = 2.0;
constexpr int most_cuts = 200;  // a line with more is a scribble, and the rest of it is dropped

struct SelfCrossing {
    std::size_t first = 0;   // segment that is crossed
    std::size_t second = 0;  // later segment that crosses it
    cv::Point2d at;
};

/// Returns where two segments, from `low` on, cross once their points are on the grid; nothing if
/// they only touch.
std::optional<cv::Point2d> crossing_on_grid(const LineSegment& s, const LineSegment& t,
                                            cv::Point2d low) {
    if (!cross_on_map_grid({s.a + low, s.b + low}, {t.a + low, t.b + low})) return std::nullopt;
    const cv::Point2d u = s.b - s.a;
    const cv::Point2d v = t.b - t.a;
    const double area = u.cross(v);
    return area == 0.0 ? nearest_on(s, t.a)
                       : s.a + std::clamp((t.a - s.a).cross(v) / area, 0.0, 1.0) * u;
}

/// Returns where they meet, ends included.
std::optional<cv::Point2d> meeting(const LineSegment& s, const LineSegment& t, cv::Point2d) {
    return crossing_of(s, t);
}

using CrossingOf = std::optional<cv::Point2d> (*)(const LineSegment&, const LineSegment&,
                                                  cv::Point2d);

/// Returns the crossing that closes the shortest loop (in segments).
std::optional<SelfCrossing> self_crossing(const Chain& line, CrossingOf crossing) {
    const std::size_t n = line.points.size();
    const std::size_t count = line.is_closed ? n : n - 1;
    cv::Point2d low = line.points.front().at;
    cv::Point2d high = low;
    for (const EdgePoint& p : line.points) {
        low = {std::min(low.x, p.at.x), std::min(low.y, p.at.y)};
        high = {std::max(high.x, p.at.x), std::max(high.y, p.at.y)};
    }
    SegmentGrid grid({high.x - low.x, high.y - low.y}, crossing_cell_mm);
    std::optional<SelfCrossing> best;
    for (std::size_t i = 0; i < count; ++i) {
        const LineSegment here{line.points[i].at - low, line.points[(i + 1) % n].at - low, 0, i};
        grid.near(here.a, here.b, 0.0, [&](const LineSegment& before) {
            const std::size_t apart = i - before.index;
            const bool is_neighbour = apart <= 1 || (line.is_closed && apart + 1 >= count);
            const std::optional<cv::Point2d> at =
                is_neighbour ? std::nullopt : crossing(before, here, low);
            if (at && (!best || apart < best->second - best->first)) {
                best = {before.index, i, *at + low};
            }
        });
        grid.add(here);
    }
    return best;
}

std::vector<Chain> taken_apart(const Chain& line, double least_mm, CrossingOf crossing) {
    std::vector<Chain> parts;
    std::vector<Chain> open{line};
    int cuts = 0;
    while (!open.empty()) {
        Chain part = std::move(open.back());
        open.pop_back();
        const std::optional<SelfCrossing> found =
            part.points.size() < 4 ? std::nullopt : self_crossing(part, crossing);
        if (!found) {
            parts.push_back(std::move(part));
            continue;
        }
        if (++cuts > most_cuts) continue;
        const auto first = part.points.begin() + static_cast<std::ptrdiff_t>(found->first) + 1;
        const auto second = part.points.begin() + static_cast<std::ptrdiff_t>(found->second) + 1;
        const EdgePoint at{found->at, first->strength, true};
        Chain loop{{at}, true, part.width_px};
        loop.points.insert(loop.points.end(), first, second);
        Chain rest{{part.points.begin(), first}, part.is_closed, part.width_px};
        rest.points.push_back(at);
        rest.points.insert(rest.points.end(), second, part.points.end());
        for (Chain* piece : {&loop, &rest}) {
            if (length_of(*piece) >= least_mm && piece->points.size() > 1) {
                open.push_back(std::move(*piece));
            }
        }
    }
    std::ranges::stable_sort(parts, std::ranges::greater{}, length_of);
    return parts;
}

}  // namespace

Chain shaped(const Chain& line, const ShapingScale& scale) {
    std::vector<EdgePoint> points = line.points;
    if (line.is_closed) points.push_back(points.front());
    std::vector<std::size_t> cuts = corners_of(points, line.is_closed, scale.least_feature_mm);
    Chain result{{}, line.is_closed, line.width_px};
    if (line.is_closed && cuts.empty()) {
        result.points = smooth_run(points, true, scale);
        result.points.pop_back();
        return result;
    }
    if (line.is_closed) {  // begin and end at the first corner
        points.pop_back();
        begin_at(cuts.front(), points);
        points.push_back(points.front());
        const std::size_t first = cuts.front();
        cuts.erase(cuts.begin());
        for (std::size_t& cut : cuts) cut -= first;
    }
    cuts.push_back(points.size() - 1);
    std::size_t from = 0;
    for (const std::size_t to : cuts) {
        std::vector<EdgePoint> smooth = smooth_run(part_of(points, from, to + 1), false, scale);
        smooth.front().is_fixed = true;
        smooth.back().is_fixed = true;
        result.points.insert(result.points.end(), smooth.begin() + (from == 0 ? 0 : 1),
                             smooth.end());
        from = to;
    }
    if (line.is_closed) result.points.pop_back();
    return result;
}

std::vector<Chain> without_self_crossings(const Chain& line, double least_mm) {
    return taken_apart(line, least_mm, meeting);
}

bool crosses_itself_in_map(const Chain& line) {
    return line.points.size() > 3 && self_crossing(line, crossing_on_grid);
}

std::vector<Chain> without_crossings_in_map(const Chain& line) {
    return taken_apart(line, 0.0, crossing_on_grid);
}

}  // namespace touchline
