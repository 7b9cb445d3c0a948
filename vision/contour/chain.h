// Lines in working pixels: the form that passes from one way of finding lines to the next, and on
// to the hand. Their ends, their stretches, even points on them, and how to find what is near them.
// Threads: values and pure functions.
#pragma once

#include "config/types/angle.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// The shortest line worth a finger's time, in millimetres at the handle. Source of this and the
/// next: guidance for raised-line pictures.
inline constexpr double shortest_line_mm = 4.0;

/// Two lines closer than this feel like one.
inline constexpr double least_apart_mm = 3.2;

/// One point of an edge line. Pixel (column, row) has its centre at (column, row).
struct EdgePoint {
    cv::Point2d at;
    double strength = 0.0;  // grey levels per pixel
    bool is_fixed = false;  // a junction, a corner or an end: every later step keeps it exactly
    /// Unit vector across the line towards the lighter side (if the lightness is the same, the
    /// redder and yellower one); (0, 0) if that is not known.
    cv::Vec2f to_light{0.0F, 0.0F};
};

/// What a line shows: an edge or a stroke; the outline of many short lines; letters in a row; a
/// picture on a page of text; dashes or dots in a row; the main thing of a photograph, and what
/// lies behind it.
enum class LineOf { edge, texture, text, figure, dashed, dotted, ring, background };

/// If closed, the last point joins the first, which is not repeated.
struct Chain {
    std::vector<EdgePoint> points;
    bool is_closed = false;
    double width_px = 0;  // if the line stands for a drawn stroke; else 0
    LineOf of = LineOf::edge;
};

[[nodiscard]] inline double distance(const cv::Point2d& a, const cv::Point2d& b) {
    return cv::norm(a - b);
}

/// Returns the pixel nearest to a place.
[[nodiscard]] inline cv::Point pixel_at(const cv::Point2d& at, cv::Size picture) {
    return {std::clamp(cvRound(at.x), 0, picture.width - 1),
            std::clamp(cvRound(at.y), 0, picture.height - 1)};
}

/// Returns the arc length in pixels; a closed chain's closing segment counts.
[[nodiscard]] inline double length_of(const Chain& chain) {
    double sum = 0.0;
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
        sum += distance(chain.points[i - 1].at, chain.points[i].at);
    }
    return chain.is_closed && !chain.points.empty()
               ? sum + distance(chain.points.back().at, chain.points.front().at)
               : sum;
}

/// Returns the arc length in pixels up to each point; 0 for the first. O(points).
[[nodiscard]] std::vector<double> arc_lengths(const std::vector<EdgePoint>& points);

/// Returns the points from ... to - 1.
[[nodiscard]] inline std::vector<EdgePoint> part_of(const std::vector<EdgePoint>& points,
                                                    std::size_t from, std::size_t to) {
    const auto at = [&](std::size_t i) { return points.begin() + static_cast<std::ptrdiff_t>(i); };
    return {at(from), at(to)};
}

/// Makes a ring begin at another of its points.
inline void begin_at(std::size_t first, std::vector<EdgePoint>& ring) {
    std::ranges::rotate(ring, ring.begin() + static_cast<std::ptrdiff_t>(first));
}

/// One end of an open chain: 2 x chain index, + 1 for its back.
using EndId = std::size_t;

[[nodiscard]] constexpr EndId front_of(std::size_t chain) {
    return 2 * chain;
}

[[nodiscard]] constexpr EndId back_of(std::size_t chain) {
    return 2 * chain + 1;
}

[[nodiscard]] constexpr std::size_t chain_of(EndId end) {
    return end / 2;
}

[[nodiscard]] constexpr bool is_back(EndId end) {
    return end % 2 == 1;
}

/// In the place of an end: there is none.
inline constexpr EndId no_end = std::numeric_limits<EndId>::max();

[[nodiscard]] inline const EdgePoint& point_at(const std::vector<Chain>& lines, EndId end) {
    const std::vector<EdgePoint>& points = lines[chain_of(end)].points;
    return is_back(end) ? points.back() : points.front();
}

/// A point as a key: the arms of a junction share theirs, bit for bit.
using PointKey = std::pair<double, double>;

[[nodiscard]] inline PointKey key_of(const cv::Point2d& p) {
    return {p.x, p.y};
}

/// The straight continuation of a line beyond an end.
struct Ray {
    cv::Point2d from;
    cv::Point2d direction;  // unit vector, outward
};

/// Returns the direction of the line near an end, from its points between `skip_px` and `skip_px +
/// span_px` of arc length from the end (fewer on a short line); `from` is the first of them.
[[nodiscard]] Ray ray_at(const std::vector<EdgePoint>& line, bool at_back, double skip_px,
                         double span_px);

/// Returns the angle between two directions, 0 to pi.
[[nodiscard]] double angle_between(const cv::Point2d& a, const cv::Point2d& b);

/// Returns the angle by which a line coming along the one ray turns to leave along the other, 0 to
/// pi.
[[nodiscard]] double turn(const Ray& in, const Ray& out);

/// A line that turns by less than this, in radians, goes straight on.
inline constexpr double straight_on_rad = radians(30.0);

/// Returns the least-squares crossing of the lines along some rays; nothing if the determinant is
/// below `least`. For two rays it is the square of the sine between them.
[[nodiscard]] std::optional<cv::Point2d> crossing_of(const std::vector<Ray>& rays, double least);

/// The place of a point in a list of chains.
struct PointRef {
    std::size_t chain = 0;
    std::size_t index = 0;
};

/// All points of some chains in square cells, for range queries. Holds no reference to the chains.
class PointGrid {
  public:
    /// cell_px > 0 should be about the radius of the queries.
    PointGrid(const std::vector<Chain>& chains, cv::Size picture, double cell_px);

    /// Visits the points in the cells that the disc touches: a superset of those within the radius.
    template <class Visit>
    void near(const cv::Point2d& centre, double radius_px, Visit&& visit) const {
        const int left = column(centre.x - radius_px);
        const int right = column(centre.x + radius_px);
        for (int r = row(centre.y - radius_px); r <= row(centre.y + radius_px); ++r) {
            const auto first = static_cast<std::size_t>(r * columns_ + left);
            const auto last = static_cast<std::size_t>(r * columns_ + right);
            for (std::size_t i = start_[first]; i < start_[last + 1]; ++i) visit(refs_[i]);
        }
    }

  private:
    [[nodiscard]] int column(double x) const;
    [[nodiscard]] int row(double y) const;
    [[nodiscard]] std::size_t cell_of(const cv::Point2d& p) const;

    double cell_px_;
    int columns_;
    int rows_;
    std::vector<std::size_t> start_;  // of each cell in refs_, one more at the end
    std::vector<PointRef> refs_;
};

/// Calls `add(Chain, place)` for every longest stretch of a line whose points have one place by
/// `place_of(point)`. Stretches are open, except for a closed line with a single place. A closed
/// line must have points. O(points).
template <class PlaceOf, class Add>
void cut_by_place(const Chain& line, PlaceOf place_of, Add add) {
    std::vector<EdgePoint> points = line.points;
    const auto is_first = [&](std::size_t i) {
        return place_of(points[i]) != place_of(points[(i + points.size() - 1) % points.size()]);
    };
    if (line.is_closed) {
        std::size_t start = 0;
        while (start < points.size() && !is_first(start)) ++start;
        if (start == points.size()) return add(line, place_of(points.front()));
        begin_at(start, points);
    }
    for (std::size_t first = 0; first < points.size();) {
        std::size_t last = first;
        while (last + 1 < points.size() && place_of(points[last + 1]) == place_of(points[first])) {
            ++last;
        }
        add(Chain{part_of(points, first, last + 1), false, line.width_px, line.of},
            place_of(points[first]));
        first = last + 1;
    }
}

/// Whether a closed chain has points and none that is fixed.
[[nodiscard]] inline bool is_free_ring(const Chain& chain) {
    return chain.is_closed && !chain.points.empty() &&
           std::ranges::none_of(chain.points, &EdgePoint::is_fixed);
}

/// Returns the chain with other points from each fixed one (or end) to the next: what `changed`
/// makes of that run, ends included. A ring is no free one and begins at a fixed point.
template <class Changed>
[[nodiscard]] Chain with_runs_changed(const Chain& chain, Changed changed) {
    if (chain.points.empty()) return chain;
    std::vector<EdgePoint> points = chain.points;
    if (chain.is_closed) {
        std::ranges::rotate(points, std::ranges::find_if(points, &EdgePoint::is_fixed));
        points.push_back(points.front());
    }
    Chain made{{points.front()}, chain.is_closed};
    std::vector<EdgePoint> run{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        run.push_back(points[i]);
        if (!points[i].is_fixed && i + 1 < points.size()) continue;
        const std::vector<EdgePoint> part = changed(run);
        made.points.insert(made.points.end(), part.begin() + 1, part.end());
        run = {points[i]};
    }
    if (chain.is_closed) made.points.pop_back();
    return made;
}

/// Returns the chain with points about `spacing_px` apart (equal arc lengths between two fixed
/// points), smoothed along the line by about one spacing; fixed points and ends are kept exactly. A
/// chain without points stays without; a ring gets at least four, all in one place if it had only
/// one. O(points).
[[nodiscard]] Chain resampled(const Chain& chain, double spacing_px);

/// Returns n + 1 points that cut the polyline into n parts of equal arc length; the first and last
/// are its own. Strengths are interpolated. If the polyline has no length, all points lie in its
/// place; n >= 1. Returns none if it has no points. O(points).
[[nodiscard]] std::vector<EdgePoint> evenly_spaced(const std::vector<EdgePoint>& line, int n);

}  // namespace touchline
