#include "config/types/angle.h"
#include "vision/contour/courses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace touchline {
namespace {

// A smaller turn is a bend, not a corner.
constexpr double corner_turn_rad = radians(35.0);
// The square of the sine; below it, two courses are parallel.
const double least_sine_squared = std::pow(std::sin(radians(8.0)), 2);
// A place on the way of an arm, or a course through a crossing.
constexpr double beside_over_depth = 1.2;
constexpr double blunt_over_depth = 2.0;  // of a place ahead of the skeleton's end in a blunt join
constexpr double course_aside_px = 0.4;   // so far aside a course may lie; more along a sharp tip
constexpr double joint_aside_px = 1.0;
constexpr double tip_slack = 1.25;  // times the length of a mitre
constexpr double tapered = 0.78;  // of the stroke's depth, on average: it is a mitre, not a stroke
constexpr double no_stroke_px = 6.0;  // longer than its width by at most this: too short for one
constexpr double parallel = radians(15.0);

/// Returns the distance of a place from the line along a ray.
double beside(const Ray& ray, const cv::Point2d& at) {
    return std::abs(ray.direction.cross(at - ray.from));
}

class Solver {
  public:
    Solver(const Skeleton& skeleton, const cv::Mat1f& depth,
           const std::vector<double>& usual_depth_px)
        : skeleton_(skeleton), courses_(skeleton, depth, usual_depth_px), nodes_(skeleton.nodes) {
        found_.is_dropped.assign(skeleton.arms.size(), false);
        node_of_.assign(2 * skeleton.arms.size(), at_no_node);
        for (std::size_t node = 0; node < nodes_.size(); ++node)
            for (const EndId end : nodes_[node]) node_of_[end] = node;
    }

    Joints run() {
        for (std::size_t arm = 0; arm < skeleton_.arms.size(); ++arm) cross_over(arm);
        for (std::size_t arm = 0; arm < skeleton_.arms.size(); ++arm) join_over(arm);
        for (const std::vector<EndId>& ends : nodes_)
            if (!ends.empty()) solve(ends);
        return std::move(found_);
    }

  private:
    static constexpr std::size_t at_no_node = std::numeric_limits<std::size_t>::max();

    [[nodiscard]] const std::vector<EdgePoint>& points(EndId end) const {
        return skeleton_.arms[chain_of(end)].points;
    }

    [[nodiscard]] bool is_free(EndId end) const {
        return !skeleton_.arms[chain_of(end)].is_closed && node_of_[end] == at_no_node;
    }

    [[nodiscard]] std::vector<EndId> others_at(EndId end) const {
        std::vector<EndId> others;
        std::ranges::copy_if(nodes_[node_of_[end]], std::back_inserter(others),
                             [&](EndId other) { return other != end; });
        return others;
    }

    /// Handles two strokes that cross at a sharp angle: the arm is the bridge between two forks,
    /// and each prong of the one goes straight on as one of the other.
    void cross_over(std::size_t arm) {
        const EndId front = front_of(arm);
        const EndId back = back_of(arm);
        if (!is_bridge(arm)) return;
        const std::vector<EndId> a = others_at(front);
        const std::vector<EndId> b = others_at(back);
        if (a.size() != 2 || b.size() != 2) return;
        for (const EndId end : {a[0], a[1], b[0], b[1]})
            if (!courses_.at(end)) return;
        for (const bool is_swapped : {false, true}) {
            const std::pair one(a[0], b[is_swapped ? 1 : 0]);
            const std::pair two(a[1], b[is_swapped ? 0 : 1]);
            if (!goes_on(one) || !goes_on(two)) continue;
            std::vector<EndId> ends{one.first, one.second, two.first, two.second};
            const auto at = crossing_of(rays_of(ends), least_sine_squared);
            if (!at) return;
            found_.is_dropped[arm] = true;
            found_.solved.push_back(solved(*at, ends, {one, two}));
            nodes_[node_of_[front]].clear();
            nodes_[node_of_[back]].clear();
            return;
        }
    }

    [[nodiscard]] bool goes_on(const std::pair<EndId, EndId>& pair) const {
        const Ray& a = courses_.at(pair.first)->ray;
        const Ray& b = courses_.at(pair.second)->ray;
        const double aside_px = 0.7 * courses_.depth_px(pair.first) + joint_aside_px;
        return turn(a, b) < parallel && beside(a, b.from) <= aside_px &&
               beside(b, a.from) <= aside_px;
    }

    /// The ends of a node without the arms to tips, and what they do; nothing if their courses do
    /// not tell.
    struct Solution {
        std::vector<EndId> tips;
        SolvedJunction junction;
    };

    [[nodiscard]] std::optional<Solution> solution_of(std::vector<EndId> ends) const {
        Solution solution;
        solution.tips = tips_of(ends);
        for (const EndId tip : solution.tips) std::erase(ends, tip);
        const bool is_known = ends.size() >= 2 && std::ranges::all_of(ends, [&](EndId end) {
                                  return courses_.at(end).has_value();
                              });
        const auto at = is_known ? crossing_of(rays_of(ends), least_sine_squared) : std::nullopt;
        if (!at || !is_near(*at, ends)) return std::nullopt;
        const auto pairs = ends.size() == 2 ? corner(ends) : straight_on(ends);
        if (ends.size() == 2 && pairs.empty()) return std::nullopt;
        solution.junction = solved(*at, ends, pairs);
        return solution;
    }

    void take(Solution solution) {
        for (const EndId tip : solution.tips) found_.is_dropped[chain_of(tip)] = true;
        found_.solved.push_back(std::move(solution.junction));
    }

    /// An arm between two nodes that is all flowed together: makes both one node, if that can be
    /// solved.
    void join_over(std::size_t arm) {
        const EndId front = front_of(arm);
        const EndId back = back_of(arm);
        if (!is_bridge(arm) || courses_.at(front) || courses_.at(back)) return;
        std::vector<EndId> ends = others_at(front);
        std::ranges::copy(others_at(back), std::back_inserter(ends));
        auto solution = solution_of(ends);
        if (!solution) return;
        found_.is_dropped[arm] = true;
        take(std::move(*solution));
        nodes_[node_of_[front]].clear();
        nodes_[node_of_[back]].clear();
    }

    /// True if it lies between two nodes of which neither is solved.
    [[nodiscard]] bool is_bridge(std::size_t arm) const {
        const std::size_t front = node_of_[front_of(arm)];
        const std::size_t back = node_of_[back_of(arm)];
        return front != at_no_node && back != at_no_node && front != back &&
               !nodes_[front].empty() && !nodes_[back].empty();
    }

    void solve(const std::vector<EndId>& ends) {
        if (auto solution = solution_of(ends)) {
            take(std::move(*solution));
            return;
        }
        std::vector<EndId> left = ends;
        for (const EndId tip : tips_of(ends)) {
            found_.is_dropped[chain_of(tip)] = true;
            std::erase(left, tip);
        }
        if (left.size() >= 2) found_.unsolved.push_back(std::move(left));
    }

    [[nodiscard]] std::vector<std::pair<EndId, EndId>> corner(
        const std::vector<EndId>& ends) const {
        if (turn(courses_.at(ends[0])->ray, courses_.at(ends[1])->ray) < corner_turn_rad) return {};
        return {{ends[0], ends[1]}};
    }

    /// Returns whether all courses lead through the place, which must be ahead of them and no
    /// farther than their ink.
    [[nodiscard]] bool is_near(const cv::Point2d& at, const std::vector<EndId>& ends) const {
        return std::ranges::all_of(ends, [&](EndId end) {
            const Course& course = *courses_.at(end);
            const double ahead_px = course.ray.direction.dot(at - course.ray.from);
            return beside(course.ray, at) <=
                       beside_over_depth * courses_.depth_px(end) + joint_aside_px &&
                   ahead_px > -joint_aside_px && ahead_px < reach_px(end, ends);
        });
    }

    /// Returns the distance from the beginning of its course to where a stroke that meets it at
    /// this node can be met.
    [[nodiscard]] double reach_px(EndId end, const std::vector<EndId>& ends) const {
        double sharpest = std::numbers::pi;
        for (const EndId other : ends) {
            if (other != end)
                sharpest = std::min(sharpest, angle_between(courses_.at(end)->ray.direction,
                                                            courses_.at(other)->ray.direction));
        }
        const double half = std::max(0.5 * sharpest, 0.5 * least_sine_squared);
        return courses_.at(end)->from_px +
               tip_slack * 2.0 * courses_.depth_px(end) / std::sin(half) + joint_aside_px;
    }

    /// Best first, each end once.
    [[nodiscard]] std::vector<std::pair<EndId, EndId>> straight_on(
        const std::vector<EndId>& ends) const {
        std::vector<std::pair<double, std::pair<EndId, EndId>>> all;
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t j = i + 1; j < ends.size(); ++j)
                if (const double angle = turn(courses_.at(ends[i])->ray, courses_.at(ends[j])->ray);
                    angle < straight_on_rad)
                    all.push_back({angle, {ends[i], ends[j]}});
        std::ranges::stable_sort(all, {}, &std::pair<double, std::pair<EndId, EndId>>::first);
        std::vector<std::pair<EndId, EndId>> chosen;
        for (const auto& [angle, pair] : all) {
            const bool is_new = std::ranges::none_of(chosen, [&](const auto& other) {
                return other.first == pair.first || other.first == pair.second ||
                       other.second == pair.first || other.second == pair.second;
            });
            if (is_new) chosen.push_back(pair);
        }
        return chosen;
    }

    /// Returns the ends whose arms lead to the tip of a corner.
    [[nodiscard]] std::vector<EndId> tips_of(std::vector<EndId> ends) const {
        std::vector<EndId> tips;
        for (const EndId tip : std::vector<EndId>(ends)) {
            if (!is_free(tip ^ 1U) || ends.size() < 3) continue;
            std::vector<EndId> others;
            std::ranges::copy_if(ends, std::back_inserter(others), [&](EndId end) {
                return end != tip && courses_.at(end).has_value();
            });
            if (others.size() + 1 != ends.size() || !is_tip(tip, others)) continue;
            tips.push_back(tip);
            std::erase(ends, tip);
        }
        return tips;
    }

    [[nodiscard]] bool is_tip(EndId tip, const std::vector<EndId>& others) const {
        const auto at = crossing_of(rays_of(others), least_sine_squared);
        if (!at) return false;
        double sharpest = std::numbers::pi;
        double depth_px = 0.0;
        for (std::size_t i = 0; i < others.size(); ++i) {
            depth_px = std::max(depth_px, courses_.depth_px(others[i]));
            for (std::size_t j = i + 1; j < others.size(); ++j)
                sharpest = std::min(sharpest, angle_between(courses_.at(others[i])->ray.direction,
                                                            courses_.at(others[j])->ray.direction));
        }
        const double sine = std::sin(0.5 * std::max(sharpest, least_sine_squared));
        const double mitre_px = depth_px / sine;
        const Beyond beyond = beyond_of(tip, *at);
        const double most_aside_px = beyond.is_ahead
                                         ? blunt_over_depth * depth_px + course_aside_px / sine
                                         : beside_over_depth * depth_px + joint_aside_px;
        if (beyond.aside_px > most_aside_px) return false;
        if (beyond.length_px > tip_slack * mitre_px + 2.0) return false;
        return beyond.length_px <= 2.0 * depth_px + no_stroke_px ||
               beyond.mean_depth_px <= tapered * depth_px + 0.3;
    }

    /// The part of an arm beyond the place on it that is nearest to `at`.
    struct Beyond {
        double aside_px = 0.0;
        double length_px = 0.0;
        double mean_depth_px = 0.0;
        bool is_ahead = false;  // the place is nearest to the arm's end
    };

    [[nodiscard]] Beyond beyond_of(EndId tip, const cv::Point2d& at) const {
        const std::vector<EdgePoint>& line = points(tip);
        const std::vector<float>& depths = courses_.depths(chain_of(tip));
        const std::size_t n = line.size();
        const auto index = [&](std::size_t i) { return is_back(tip) ? n - 1 - i : i; };
        Beyond beyond{std::numeric_limits<double>::infinity(), 0.0, 0.0, false};
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double aside_px = distance(line[index(i)].at, at);
            if (aside_px < beyond.aside_px) {
                beyond.aside_px = aside_px;
                nearest = i;
            }
        }
        double sum = 0.0;
        for (std::size_t i = nearest; i < n; ++i) {
            sum += static_cast<double>(depths[index(i)]);
            if (i > nearest) beyond.length_px += distance(line[index(i - 1)].at, line[index(i)].at);
        }
        beyond.mean_depth_px = sum / static_cast<double>(n - nearest);
        beyond.is_ahead = nearest + 1 == n;
        return beyond;
    }

    [[nodiscard]] std::vector<Ray> rays_of(const std::vector<EndId>& ends) const {
        std::vector<Ray> rays;
        for (const EndId end : ends) rays.push_back(courses_.at(end)->ray);
        return rays;
    }

    [[nodiscard]] SolvedJunction solved(const cv::Point2d& at, const std::vector<EndId>& ends,
                                        std::vector<std::pair<EndId, EndId>> through) const {
        SolvedJunction made{at, {}, std::move(through)};
        for (const EndId end : ends) made.arms.push_back({end, courses_.at(end)->from_px});
        return made;
    }

    const Skeleton& skeleton_;
    Courses courses_;
    std::vector<std::vector<EndId>> nodes_;
    std::vector<std::size_t> node_of_;  // of each end
    Joints found_;
};

}  // namespace

Joints joints_of(const Skeleton& skeleton, const cv::Mat1f& depth,
                 const std::vector<double>& usual_depth_px) {
    return Solver(skeleton, depth, usual_depth_px).run();
}

}  // namespace touchline
