#include "vision/contour/corners.h"

#include "config/types/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace touchline {
namespace {

constexpr double sample_step_px = 0.5;
constexpr double least_turn = radians(35.0);
// A sharper turn is the end of a stroke.
constexpr double greatest_turn = radians(155.0);
constexpr double least_course_px = 2.5;  // of a course, to fit a line
constexpr double course_span_px = 7.0;
constexpr double course_straight_px = 0.25;  // rms about the fitted line
// An ideal corner between sides at angle a, blurred by sigma, is rounded by 0.5 sigma / sin(a/2).
constexpr double rounding = 0.6;
constexpr double rounding_slack_px = 1.2;  // noise

using Accepts = std::function<bool(const cv::Point2d&, double)>;

/// A line fitted to part of the chain, directed along it.
struct FittedCourse {
    cv::Point2d centre;
    cv::Point2d direction;
    double rms_px = 0.0;
};

struct Corner {
    int from = 0;  // samples replaced by the vertex: from ... to
    int to = 0;
    cv::Point2d vertex;
    double turn = 0.0;
};

/// One run of even samples between two fixed points, or a ring without any.
class EvenRun {
  public:
    EvenRun(const std::vector<EdgePoint>& points, bool is_ring, double blur_px)
        : is_ring_(is_ring), blur_px_(blur_px) {
        const double length = length_of({points, false});
        const int n = std::max(1, static_cast<int>(std::lround(length / sample_step_px)));
        samples_ = evenly_spaced(points, n);
        step_px_ = length > 0.0 ? length / n : sample_step_px;
        if (is_ring) samples_.pop_back();
    }

    /// Returns the samples, with sharp corners.
    std::vector<EdgePoint> sharpened(const Accepts& accepts) const {
        const std::vector<int> apexes = turning_points();
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < apexes.size(); ++i) {
            const std::optional<Corner> corner =
                corner_at(apexes[i], room(apexes, i, -1), room(apexes, i, 1));
            if (corner && accepts(corner->vertex, corner->turn)) corners.push_back(*corner);
        }
        return replaced(corners);
    }

  private:
    int count() const { return static_cast<int>(samples_.size()); }

    /// Returns at most the largest number that a run may have: a very short one has very short
    /// steps.
    int samples_in(double length_px) const {
        constexpr double most_samples = 1e8;
        return static_cast<int>(std::min(length_px / step_px_, most_samples));
    }

    bool has(int i) const { return is_ring_ || (i >= 0 && i < count()); }

    const EdgePoint& sample(int i) const {
        const int n = count();
        return samples_[static_cast<std::size_t>(is_ring_ ? (i % n + n) % n : i)];
    }

    /// Returns the angle by which the chords over `reach` samples before and after i differ; 0 near
    /// an end.
    double turn_at(int i, int reach) const {
        if (!has(i - reach) || !has(i + reach)) return 0.0;
        const cv::Point2d in = sample(i).at - sample(i - reach).at;
        const cv::Point2d out = sample(i + reach).at - sample(i).at;
        return std::abs(std::atan2(in.cross(out), in.dot(out)));
    }

    /// Returns the strongest turns, none within the reach of a stronger one.
    std::vector<int> turning_points() const {
        const int reach = std::max(2, samples_in(2.5 * blur_px_ + 1.0));
        std::vector<double> turns(samples_.size(), 0.0);
        if (count() < 4 * reach) return {};
        for (int i = 0; i < count(); ++i) turns[static_cast<std::size_t>(i)] = turn_at(i, reach);
        std::vector<int> apexes;
        for (int i = 0; i < count(); ++i) {
            const double turn = turns[static_cast<std::size_t>(i)];
            bool is_strongest = turn > least_turn;
            for (int k = -reach; k <= reach && is_strongest; ++k) {
                if (has(i + k) && k != 0) {
                    const int j = (i + k + count()) % count();
                    const double other = turns[static_cast<std::size_t>(j)];
                    is_strongest = other < turn || (other == turn && i < j);
                }
            }
            if (is_strongest) apexes.push_back(i);
        }
        return apexes;
    }

    /// Returns the number of samples between an apex and its neighbour on one side (or the run's
    /// end).
    int room(const std::vector<int>& apexes, std::size_t i, int side) const {
        const std::size_t n = apexes.size();
        const int here = apexes[i];
        if (is_ring_) {
            const int other = apexes[(i + (side > 0 ? 1 : n - 1)) % n];
            const int gap = side > 0 ? other - here : here - other;
            return gap > 0 ? gap : gap + count();
        }
        if (side > 0) return (i + 1 < n ? apexes[i + 1] : count() - 1) - here;
        return here - (i > 0 ? apexes[i - 1] : 0);
    }

    /// Fits a line through the samples `skip` ... `skip + span` away from the apex, clear of its
    /// neighbour too.
    std::optional<FittedCourse> course(int apex, int side, int room, double skip_px) const {
        const int skip = std::min(samples_in(skip_px), (2 * room) / 5);
        const int last = std::min(skip + samples_in(course_span_px + blur_px_), room - skip);
        if (last - skip < samples_in(least_course_px)) return std::nullopt;
        const int first = apex + (side > 0 ? skip : -last);
        const int n = last - skip + 1;
        cv::Point2d sum;
        for (int i = 0; i < n; ++i) sum += sample(first + i).at;
        FittedCourse fit{sum / static_cast<double>(n), {}, 0.0};
        double xx = 0.0;
        double yy = 0.0;
        double xy = 0.0;
        for (int i = 0; i < n; ++i) {
            const cv::Point2d d = sample(first + i).at - fit.centre;
            xx += d.x * d.x;
            yy += d.y * d.y;
            xy += d.x * d.y;
        }
        const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
        fit.direction = {std::cos(angle), std::sin(angle)};
        if (fit.direction.dot(sample(first + n - 1).at - sample(first).at) < 0.0) {
            fit.direction = -fit.direction;
        }
        const double across = xx + yy - fit.direction.x * fit.direction.x * xx -
                              2.0 * fit.direction.x * fit.direction.y * xy -
                              fit.direction.y * fit.direction.y * yy;
        fit.rms_px = std::sqrt(std::max(0.0, across) / n);
        return fit;
    }

    /// Returns how far from a vertex the blur bends the sides, by the angle between them.
    double bent_px(double turn) const {
        return blur_px_ * std::clamp(1.5 / std::cos(0.5 * turn), 2.0, 6.0);
    }

    std::optional<Corner> corner_at(int apex, int room_before, int room_after) const {
        double skip_px =
            bent_px(turn_at(apex, std::min({room_before, room_after, samples_in(8.0)})));
        std::optional<FittedCourse> in;
        std::optional<FittedCourse> out;
        double turn = 0.0;
        for (int pass = 0; pass < 2; ++pass) {  // the second pass knows the angle
            in = course(apex, -1, room_before, skip_px);
            out = course(apex, 1, room_after, skip_px);
            if (!in || !out ||
                std::max(in->rms_px, out->rms_px) > course_straight_px + 0.1 * blur_px_) {
                return std::nullopt;
            }
            turn = angle_between(in->direction, out->direction);
            skip_px = bent_px(turn);
        }
        const std::optional<cv::Point2d> vertex = crossing(*in, *out);
        if (turn < least_turn || turn > greatest_turn || !vertex) return std::nullopt;
        const Corner corner{apex - std::min(samples_in(skip_px), (2 * room_before) / 5),
                            apex + std::min(samples_in(skip_px), (2 * room_after) / 5), *vertex,
                            turn};
        double rounding_px = std::numeric_limits<double>::infinity();
        for (int i = corner.from; i <= corner.to; ++i) {
            rounding_px = std::min(rounding_px, distance(*vertex, sample(i).at));
        }
        const double explained_px = rounding * blur_px_ / std::cos(0.5 * turn) + rounding_slack_px;
        return rounding_px <= explained_px ? std::optional(corner) : std::nullopt;
    }

    /// Returns where the courses cross, after the first and before the second.
    static std::optional<cv::Point2d> crossing(const FittedCourse& in, const FittedCourse& out) {
        const cv::Point2d between = out.centre - in.centre;
        const double sine = in.direction.cross(out.direction);
        const double ahead_px = between.cross(out.direction) / sine;
        const double behind_px = between.cross(in.direction) / sine;
        if (!(ahead_px > 0.0) || !(behind_px < 0.0)) return std::nullopt;
        return in.centre + ahead_px * in.direction;
    }

    std::vector<EdgePoint> replaced(const std::vector<Corner>& corners) const {
        std::vector<EdgePoint> kept;
        std::vector<char> is_cut(samples_.size(), 0);
        std::vector<const Corner*> vertex(samples_.size(), nullptr);
        for (const Corner& corner : corners) {
            for (int i = corner.from; i <= corner.to; ++i) is_cut[index(i)] = 1;
            vertex[index((corner.from + corner.to) / 2)] = &corner;
        }
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            if (vertex[i] != nullptr) {
                kept.push_back({vertex[i]->vertex, samples_[i].strength, true});
            } else if (is_cut[i] == 0) {
                kept.push_back(samples_[i]);
            }
        }
        return kept;
    }

    /// The index of a sample, counted on round a ring.
    std::size_t index(int i) const {
        return static_cast<std::size_t>((i % count() + count()) % count());
    }

    bool is_ring_;
    double blur_px_;
    double step_px_ = sample_step_px;
    std::vector<EdgePoint> samples_;
};

}  // namespace

Chain with_sharp_corners(const Chain& chain, double blur_px, const Accepts& accepts) {
    if (is_free_ring(chain)) {
        std::vector<EdgePoint> points = chain.points;
        points.push_back(points.front());
        return {EvenRun(points, true, blur_px).sharpened(accepts), true};
    }
    return with_runs_changed(chain, [&](const std::vector<EdgePoint>& run) {
        return EvenRun(run, false, blur_px).sharpened(accepts);
    });
}

}  // namespace touchline
