#include "vision/contour/courses.h"

#include "config/types/angle.h"
#include "vision/contour/gradient.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace touchline {
namespace {

// Times the stroke's own depth: deeper ink belongs to two strokes.
constexpr double deep_over_depth = 1.12;
constexpr double deep_slack_px = 0.8;     // whole pixels: a slanting stroke is now 2, now 2.8 deep
constexpr double span_over_depth = 12.0;  // of a course, at most: the longer, the surer
constexpr double end_span_px = 24.0;
constexpr double least_end_px = 3.0;
constexpr double straight_end_px = 0.7;  // rms about the fitted line
constexpr double own_part = 0.3;         // of an arm's depths: half the width of its stroke
constexpr double long_over_depth = 6.0;  // shorter arms do not show it

/// Fits by least squares through the points between from_px and from_px + span_px of arc length.
std::pair<Ray, double> fitted(const Chain& arm, EndId end, double from_px, double span_px) {
    std::vector<cv::Point2d> part;
    double passed_px = 0.0;
    const std::size_t n = arm.points.size();
    const auto at = [&](std::size_t i) { return arm.points[is_back(end) ? n - 1 - i : i].at; };
    for (std::size_t i = 1; i < n && passed_px <= from_px + span_px; ++i) {
        passed_px += distance(at(i - 1), at(i));
        if (passed_px >= from_px) part.push_back(at(i));
    }
    if (part.size() < 3) return {{}, std::numeric_limits<double>::infinity()};
    cv::Point2d sum;
    for (const cv::Point2d& p : part) sum += p;
    const cv::Point2d centre = sum / static_cast<double>(part.size());
    double xx = 0.0, yy = 0.0, xy = 0.0;
    for (const cv::Point2d& p : part) {
        const cv::Point2d d = p - centre;
        xx += d.x * d.x;
        yy += d.y * d.y;
        xy += d.x * d.y;
    }
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
    cv::Point2d direction(std::cos(angle), std::sin(angle));
    if (direction.dot(part.front() - part.back()) < 0.0) direction = -direction;
    const double along = direction.x * direction.x * xx + 2.0 * direction.x * direction.y * xy +
                         direction.y * direction.y * yy;
    const double rms_px =
        std::sqrt(std::max(0.0, xx + yy - along) / static_cast<double>(part.size()));
    return {{centre + (part.front() - centre).dot(direction) * direction, direction}, rms_px};
}

constexpr double hairpin_turn = radians(145.0);
constexpr double hairpin_over_depth = 2.0;
constexpr double least_hairpin_px = 6.0;

/// The points of an arm and the ink at them. In a ring the first comes after the last.
class Way {
  public:
    Way(const Chain& arm, const cv::Mat1f& depth)
        : points_(arm.points), is_closed_(arm.is_closed), depths_(depths_of(arm, depth)) {
        const double stroke_px = stroke_depth_px(depths_);
        limit_px_ = flowed_depth_px(stroke_px);
        bent_ = static_cast<int>(std::ceil(stroke_px));
        span_ = static_cast<int>(std::max(least_hairpin_px, hairpin_over_depth * stroke_px));
    }

    /// Returns the middles of deep ink in which the arm turns back, in order.
    [[nodiscard]] std::vector<std::size_t> hairpins() const {
        std::vector<std::size_t> found;
        const int n = count();
        for (int i = is_closed_ ? first_shallow() : 0, last = i + n; i < last; ++i) {
            if (!is_deep(i)) continue;
            int end = i;
            while (end + 1 < last && is_deep(end + 1)) ++end;
            if (turns_back(i, end)) found.push_back(index((i + end) / 2));
            i = end;
        }
        std::ranges::sort(found);
        return found;
    }

  private:
    [[nodiscard]] int count() const { return static_cast<int>(points_.size()); }

    [[nodiscard]] std::size_t index(int i) const { return static_cast<std::size_t>(i % count()); }

    [[nodiscard]] bool is_deep(int i) const {
        return static_cast<double>(depths_[index(i)]) > limit_px_;
    }

    [[nodiscard]] int first_shallow() const {
        int i = 0;
        while (i + 1 < count() && is_deep(i)) ++i;
        return i;
    }

    [[nodiscard]] bool turns_back(int from, int to) const {
        from -= bent_;
        to += bent_;
        const int before = from - span_;
        const int after = to + span_;
        const bool has_both =
            is_closed_ ? after - before < count() : before >= 0 && after < count();
        if (!has_both) return false;
        const auto at = [&](int i) { return points_[index(i + count())].at; };
        return angle_between(at(from) - at(before), at(after) - at(to)) > hairpin_turn;
    }

    const std::vector<EdgePoint>& points_;
    bool is_closed_;
    std::vector<float> depths_;
    double limit_px_ = 0.0;
    int bent_ = 0;  // points beside the deep ink that the tip still bends
    int span_ = 0;  // points after these that show where the stroke comes from or goes to
};

/// Cuts an arm into parts, from place to place; in a ring the last part ends where the first
/// begins.
std::vector<Chain> parted(Chain arm, std::vector<std::size_t> places) {
    if (arm.is_closed) {
        const std::size_t first = places.front();
        begin_at(first, arm.points);
        arm.points.push_back(arm.points.front());
        arm.is_closed = false;
        for (std::size_t& place : places) place -= first;
    } else {
        places.insert(places.begin(), 0);
    }
    places.push_back(arm.points.size() - 1);
    std::vector<Chain> parts;
    for (std::size_t i = 1; i < places.size(); ++i) {
        parts.push_back({part_of(arm.points, places[i - 1], places[i] + 1), arm.is_closed,
                         arm.width_px, arm.of});
    }
    return parts;
}

}  // namespace

std::vector<float> depths_of(const Chain& arm, const cv::Mat1f& depth) {
    std::vector<float> depths;
    for (const EdgePoint& p : arm.points) depths.push_back(depth(pixel_at(p.at, depth.size())));
    return depths;
}

double stroke_depth_px(const std::vector<float>& depths) {
    return depths.empty() ? 1.0 : std::max(1.0, static_cast<double>(quantile(depths, own_part)));
}

double flowed_depth_px(double stroke_depth_px) {
    return deep_over_depth * stroke_depth_px + deep_slack_px;
}

Courses::Courses(const Skeleton& skeleton, const cv::Mat1f& depth,
                 std::vector<double> usual_depth_px)
    : skeleton_(skeleton), own_depth_px_(std::move(usual_depth_px)) {
    for (std::size_t arm = 0; arm < skeleton.arms.size(); ++arm) {
        depths_.push_back(depths_of(skeleton.arms[arm], depth));
        const double own_px = stroke_depth_px(depths_[arm]);
        if (length_of(skeleton.arms[arm]) > long_over_depth * own_px) own_depth_px_[arm] = own_px;
    }
    for (EndId end = 0; end < 2 * skeleton.arms.size(); ++end) courses_.push_back(course_at(end));
}

/// Returns where the ink is that of one stroke; at most half of the arm, because the other end has
/// its own.
double Courses::flowed_px(EndId end) const {
    const std::vector<EdgePoint>& points = skeleton_.arms[chain_of(end)].points;
    const std::vector<float>& depths = depths_[chain_of(end)];
    const double limit = flowed_depth_px(depth_px(end));
    const double needed_px = std::max(2.0, depth_px(end));
    const std::size_t n = points.size();
    const auto index = [&](std::size_t i) { return is_back(end) ? n - 1 - i : i; };
    double passed_px = 0.0;
    double flowed_px = 0.0;
    for (std::size_t i = 1; i < n; ++i) {
        passed_px += distance(points[index(i - 1)].at, points[index(i)].at);
        if (static_cast<double>(depths[index(i)]) > limit) flowed_px = passed_px;
        if (passed_px - flowed_px > needed_px) break;
    }
    return flowed_px + depth_px(end);
}

std::optional<Course> Courses::course_at(EndId end) const {
    const Chain& arm = skeleton_.arms[chain_of(end)];
    const double length_px = length_of(arm);
    const double from_px = flowed_px(end);
    const double room_px = length_px - from_px - flowed_px(end ^ 1U);
    double span_px = std::min(room_px, span_over_depth * depth_px(end) + end_span_px);
    while (span_px >= least_end_px) {
        const auto [ray, rms_px] = fitted(arm, end, from_px, span_px);
        if (rms_px <= straight_end_px) return Course{ray, from_px};
        span_px *= 0.6;
    }
    return std::nullopt;
}

Skeleton with_hairpins_parted(const Skeleton& skeleton, const cv::Mat1f& depth) {
    Skeleton made;
    std::vector<EndId> place;  // for each end, among the new ones
    for (const Chain& arm : skeleton.arms) {
        const std::size_t first = made.arms.size();
        const std::vector<std::size_t> places = Way(arm, depth).hairpins();
        if (places.empty()) {
            made.arms.push_back(arm);
        } else {
            std::ranges::move(parted(arm, places), std::back_inserter(made.arms));
        }
        const std::size_t last = made.arms.size() - 1;
        for (std::size_t part = first; part < last; ++part) {
            made.nodes.push_back({back_of(part), front_of(part + 1)});
        }
        if (arm.is_closed && !places.empty())
            made.nodes.push_back({back_of(last), front_of(first)});
        place.push_back(front_of(first));
        place.push_back(back_of(last));
    }
    for (std::vector<EndId> node : skeleton.nodes) {
        for (EndId& end : node) end = place[end];
        made.nodes.push_back(std::move(node));
    }
    return made;
}

}  // namespace touchline
