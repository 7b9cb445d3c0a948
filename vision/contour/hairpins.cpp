#include "vision/contour/hairpins.h"

#include "vision/contour/courses.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace touchline {
namespace {

constexpr double kTurn = 145.0 * std::numbers::pi / 180.0;
constexpr double kSpanOverDepth = 2.0;
constexpr double kLeastArm_px = 6.0;

/// The points of an arm and the ink at them. In a ring the first comes after the last.
class Way {
  public:
    Way(const Chain& arm, const cv::Mat1f& depth)
        : points_(arm.points), is_closed_(arm.is_closed), depths_(depths_of(arm, depth)) {
        const double stroke_px = stroke_depth_px(depths_);
        limit_px_ = flowed_depth_px(stroke_px);
        bent_ = static_cast<int>(std::ceil(stroke_px));
        span_ = static_cast<int>(std::max(kLeastArm_px, kSpanOverDepth * stroke_px));
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
        return angle_between(at(from) - at(before), at(after) - at(to)) > kTurn;
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
        std::ranges::rotate(arm.points, arm.points.begin() + static_cast<std::ptrdiff_t>(first));
        arm.points.push_back(arm.points.front());
        arm.is_closed = false;
        for (std::size_t& place : places) place -= first;
    } else {
        places.insert(places.begin(), 0);
    }
    places.push_back(arm.points.size() - 1);
    std::vector<Chain> parts;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const auto from = arm.points.begin() + static_cast<std::ptrdiff_t>(places[i - 1]);
        const auto to = arm.points.begin() + static_cast<std::ptrdiff_t>(places[i]);
        parts.push_back(arm);
        parts.back().points.assign(from, to + 1);
    }
    return parts;
}

}  // namespace

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
