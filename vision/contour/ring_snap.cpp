#include "vision/contour/ring_snap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace touchline {

float strength_at(const cv::Mat1f& strength, const cv::Point2d& at) {
    const cv::Point p(cvRound(at.x), cvRound(at.y));
    return cv::Rect({}, strength.size()).contains(p) ? strength(p) : 0.0F;
}

bool is_on_frame(const cv::Point2d& at, cv::Size size) {
    return at.x < 1.0 || at.y < 1.0 || at.x > size.width - 2.0 || at.y > size.height - 2.0;
}

void snap(Chain& ring, const cv::Mat1f& strength, double reach_px) {
    const auto n = static_cast<int>(ring.points.size());
    const auto at = [&](int i) {
        return ring.points[static_cast<std::size_t>((i % n + n) % n)].at;
    };
    std::vector<double> offset(ring.points.size(), 0.0);
    std::vector<cv::Point2d> normal(ring.points.size());
    for (int i = 0; i < n; ++i) {
        const cv::Point2d along = at(i + 3) - at(i - 3);
        const double length = std::max(1e-9, cv::norm(along));
        const auto k = static_cast<std::size_t>(i);
        normal[k] = {-along.y / length, along.x / length};
        double best = 0.0;
        for (double d = -reach_px; d <= reach_px && !is_on_frame(at(i), strength.size());
             d += 0.5) {
            const double near = std::exp(-0.5 * d * d / (0.25 * reach_px * reach_px));
            const double value =
                near * static_cast<double>(strength_at(strength, at(i) + d * normal[k]));
            if (value > best) {
                best = value;
                offset[k] = d;
            }
        }
    }
    constexpr int kAgree = 7;  // points, of which the median is taken
    for (int i = 0; i < n; ++i) {
        std::array<double, kAgree> around{};
        for (int k = 0; k < kAgree; ++k) {
            around[static_cast<std::size_t>(k)] =
                offset[static_cast<std::size_t>((i + k - kAgree / 2 + n) % n)];
        }
        std::ranges::nth_element(around, around.begin() + kAgree / 2);
        const auto k = static_cast<std::size_t>(i);
        ring.points[k].at += around[kAgree / 2] * normal[k];
    }
}

}  // namespace touchline
