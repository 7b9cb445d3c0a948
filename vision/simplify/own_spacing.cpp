#include "vision/simplify/own_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

constexpr double kApartAlong = 4.0;    // gaps: nearer along the line is a bend, not two lines
constexpr double kHairpinAlong = 2.0;  // gaps: further may be there and back on parallel ways
constexpr double kParallel = 0.985;    // cosine of 10 degrees
constexpr double kStraight_mm = 0.5;   // the way along two straight sides minus that by the corner

/// Returns whether a segment leads back along another.
bool is_back(cv::Point2d way, const LineSegment& other) {
    const cv::Point2d along = other.b - other.a;
    return way.dot(along) < -kParallel * cv::norm(way) * cv::norm(along);
}

/// Returns the arc length up to each point.
std::vector<double> arc_lengths(const std::vector<EdgePoint>& points) {
    std::vector<double> at_mm{0.0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        at_mm.push_back(at_mm.back() + distance(points[i - 1].at, points[i].at));
    }
    return at_mm;
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
            if (points[i].is_fixed) {
                corners_.push_back(i);
            }
        }
    }

    /// Returns whether the way from one point to another is straight except for one corner.
    [[nodiscard]] bool is_round_one(std::size_t from, std::size_t to) const {
        return std::ranges::any_of(corners_, [&](std::size_t corner) {
            const double straight_mm = distance(points_[from].at, points_[corner].at) +
                                       distance(points_[corner].at, points_[to].at);
            return way_mm(from, corner, to) - straight_mm < kStraight_mm;
        });
    }

  private:
    /// Returns the way along the line from the one point past the corner to the other; infinite if
    /// the corner lies elsewhere.
    [[nodiscard]] double way_mm(std::size_t from, std::size_t corner, std::size_t to) const {
        const auto [low, high] = std::minmax(at_mm_[from], at_mm_[to]);
        const double between_mm = high - low;
        const bool is_between = at_mm_[corner] >= low && at_mm_[corner] <= high;
        if (is_between) {
            return between_mm;
        }
        return around_mm_ > 0.0 ? around_mm_ - between_mm : std::numeric_limits<double>::infinity();
    }

    const std::vector<EdgePoint>& points_;
    const std::vector<double>& at_mm_;
    double around_mm_;
    std::vector<std::size_t> corners_;
};

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
            if (along_mm > kApartAlong * scale.gap_mm - 2.0 * scale.step_mm &&
                apart_mm < least_mm && !corners.is_round_one(before.index, i)) {
                least_mm = apart_mm;
                foot = {on, before.index};
            }
            is_hairpin =
                is_hairpin || (along_mm > kHairpinAlong * scale.gap_mm && apart_mm < scale.gap_mm &&
                               is_back(p - points[i - 1].at, before));
        });
        if (foot || is_hairpin) {
            return {first, i - 1, at_mm[i - 1] - at_mm[first], foot};
        }
        own.add({points[i - 1].at, p, 0, i - 1});
    }
    return {first, last, at_mm[last] - at_mm[first], std::nullopt};
}

std::optional<std::size_t> too_near_itself(const Chain& ring, const SpacingScale& scale) {
    SegmentGrid own(scale.area_mm, 0.5 * scale.gap_mm);
    for (std::size_t i = 0; i < segments_of(ring); ++i) {
        own.add(segment_of(ring, i, 0));
    }
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
                      (along_mm > kApartAlong * scale.gap_mm - 2.0 * scale.step_mm &&
                       apart_mm < scale.clearance_mm() && !corners.is_round_one(other.index, i)) ||
                      (along_mm > kHairpinAlong * scale.gap_mm && apart_mm < scale.gap_mm &&
                       is_back(way, other));
        });
        if (is_near) {
            return i;
        }
    }
    return std::nullopt;
}

}  // namespace touchline
