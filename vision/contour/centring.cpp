#include "vision/contour/gradient.h"
#include "vision/contour/skeleton.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace touchline {
namespace {

constexpr double ray_step_px = 0.25;
constexpr double narrowest = 0.5;  // of the known width: a sound measurement
constexpr double widest = 1.3;
constexpr int smoothing_passes = 3;

/// Interpolates bilinearly; outside the picture it returns the value at the border.
double darkness_at(const cv::Mat1f& darkness, const cv::Point2d& at) {
    const double x = std::clamp(at.x, 0.0, darkness.cols - 1.0);
    const double y = std::clamp(at.y, 0.0, darkness.rows - 1.0);
    const int left = std::min(static_cast<int>(x), std::max(0, darkness.cols - 2));
    const int top = std::min(static_cast<int>(y), std::max(0, darkness.rows - 2));
    const int right = std::min(left + 1, darkness.cols - 1);
    const int bottom = std::min(top + 1, darkness.rows - 1);
    const double u = x - left;
    const double v = y - top;
    const auto value = [&](int row, int column) {
        return static_cast<double>(darkness(row, column));
    };
    return (1.0 - v) * ((1.0 - u) * value(top, left) + u * value(top, right)) +
           v * ((1.0 - u) * value(bottom, left) + u * value(bottom, right));
}

bool is_inside(const cv::Mat1f& darkness, const cv::Point2d& at) {
    return at.x >= -0.5 && at.y >= -0.5 && at.x <= darkness.cols - 0.5 &&
           at.y <= darkness.rows - 0.5;
}

/// Returns how far the ink goes on from a place in it, at most `far_px`.
std::optional<double> ink_ahead(const cv::Mat1f& darkness, const cv::Point2d& from,
                                const cv::Point2d& way, double far_px) {
    double before = darkness_at(darkness, from);
    if (before < 1.0) return std::nullopt;
    for (double d = ray_step_px; d <= far_px; d += ray_step_px) {
        const double here = darkness_at(darkness, from + d * way);
        if (here < 1.0) return d - ray_step_px * (1.0 - here) / (before - here);
        before = here;
    }
    return std::nullopt;
}

class Centring {
  public:
    Centring(const Chain& line, const cv::Mat1f& darkness) : line_(line), darkness_(darkness) {}

    Chain between_ends() {
        move_to_middle();
        smooth();
        return std::move(line_);
    }

    Chain run() {
        line_ = between_ends();
        if (!line_.is_closed) {
            for (const bool at_back : {false, true}) place_end(at_back);
        }
        return std::move(line_);
    }

  private:
    int count() const { return static_cast<int>(line_.points.size()); }

    /// Returns point `i`, counted on round a ring; none beyond an open end.
    const EdgePoint* point(int i) const {
        if (line_.is_closed) i = (i % count() + count()) % count();
        return i >= 0 && i < count() ? &line_.points[static_cast<std::size_t>(i)] : nullptr;
    }

    bool is_near_fixed(int i) const {
        const int reach = static_cast<int>(std::ceil(line_.width_px));
        for (int k = -reach; k <= reach; ++k) {
            const EdgePoint* other = point(i + k);
            if (other != nullptr && other->is_fixed &&
                distance(other->at, point(i)->at) < line_.width_px) {
                return true;
            }
        }
        return false;
    }

    void move_to_middle() {
        std::vector<EdgePoint> moved = line_.points;
        std::vector<double> widths_px;
        const int span = std::max(2, static_cast<int>(0.7 * line_.width_px));
        for (int i = 0; i < count(); ++i) {
            const EdgePoint* before = point(i - span) != nullptr ? point(i - span) : point(0);
            const EdgePoint* after =
                point(i + span) != nullptr ? point(i + span) : point(count() - 1);
            const cv::Point2d along = after->at - before->at;
            if (!(cv::norm(along) > 0.0) || is_near_fixed(i)) continue;
            const cv::Point2d normal = cv::Point2d(-along.y, along.x) / cv::norm(along);
            const double far_px = widest * line_.width_px + 1.0;
            const std::optional<double> one = ink_ahead(darkness_, point(i)->at, normal, far_px);
            const std::optional<double> other = ink_ahead(darkness_, point(i)->at, -normal, far_px);
            if (!one || !other || *one + *other < narrowest * line_.width_px ||
                *one + *other > widest * line_.width_px + 1.0) {
                continue;
            }
            moved[static_cast<std::size_t>(i)].at += 0.5 * (*one - *other) * normal;
            widths_px.push_back(*one + *other);
        }
        line_.points = std::move(moved);
        if (!widths_px.empty()) line_.width_px = median_of(std::move(widths_px));
    }

    void smooth() {
        for (int pass = 0; pass < smoothing_passes; ++pass) {
            const std::vector<EdgePoint> before = line_.points;
            const auto at = [&](int i) {
                const int n = static_cast<int>(before.size());
                return before[static_cast<std::size_t>((i + n) % n)].at;
            };
            for (int i = 0; i < count(); ++i) {
                const bool is_end = !line_.is_closed && (i == 0 || i + 1 == count());
                EdgePoint& here = line_.points[static_cast<std::size_t>(i)];
                if (!is_end && !here.is_fixed) {
                    here.at = 0.25 * (at(i - 1) + 2.0 * at(i) + at(i + 1));
                }
            }
        }
    }

    void place_end(bool at_back) {
        std::vector<EdgePoint>& points = line_.points;
        if (at_back) std::ranges::reverse(points);
        if (!points.front().is_fixed) move_end(points);
        points.front().is_fixed = true;
        if (at_back) std::ranges::reverse(points);
    }

    /// The end is the first point.
    void move_end(std::vector<EdgePoint>& points) const {
        // The corners of the stroke's end bend the last half width.
        const Ray ray = ray_at(points, false, 0.5 * line_.width_px, 1.5 * line_.width_px + 2.0);
        while (points.size() > 2 && distance(points[1].at, ray.from) > 0.0 &&
               points.front().at != ray.from) {
            points.erase(points.begin());
        }
        EdgePoint end = points.front();
        cv::Point2d at = end.at;
        const double far_px = 2.5 * line_.width_px + 2.0;
        double ahead_px = 0.0;
        while (ahead_px < far_px && is_inside(darkness_, at) && darkness_at(darkness_, at) >= 1.0) {
            ahead_px += ray_step_px;
            at = end.at + ahead_px * ray.direction;
        }
        if (!is_inside(darkness_, at)) {
            end.at = {std::clamp(at.x, -0.5, darkness_.cols - 0.5),
                      std::clamp(at.y, -0.5, darkness_.rows - 0.5)};
            points.insert(points.begin(), end);
        } else if (ahead_px > 0.5 * line_.width_px + ray_step_px) {
            end.at += (ahead_px - ray_step_px - 0.5 * line_.width_px) * ray.direction;
            points.insert(points.begin(), end);
        }
    }

    Chain line_;
    const cv::Mat1f& darkness_;
};

}  // namespace

Chain in_the_middle(const Chain& line, const cv::Mat1f& darkness) {
    return Centring(line, darkness).between_ends();
}

Chain centred(const Chain& line, const cv::Mat1f& darkness) {
    return Centring(line, darkness).run();
}

}  // namespace touchline
