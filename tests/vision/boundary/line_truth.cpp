#include "tests/vision/boundary/line_truth.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace touchline::testing {
namespace {

constexpr double sample_step_px = 0.5;
constexpr double missing_beyond_px = 2.0;
constexpr double spurious_beyond_px = 3.0;

using Line = std::vector<cv::Point2d>;

double distance_to(const cv::Point2d& p, const Line& line) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const cv::Point2d along = line[i] - line[i - 1];
        const double squared = along.dot(along);
        const double t =
            squared > 0.0 ? std::clamp((p - line[i - 1]).dot(along) / squared, 0.0, 1.0) : 0.0;
        const cv::Point2d off = p - line[i - 1] - t * along;
        best = std::min(best, off.dot(off));
    }
    return std::sqrt(best);
}

/// Returns the distances from samples of `from` to the nearest of `to`.
std::vector<double> distances(const std::vector<Line>& from, const std::vector<Line>& to) {
    std::vector<double> all;
    for (const Line& line : from) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const cv::Point2d along = line[i] - line[i - 1];
            const int steps =
                std::max(1, static_cast<int>(std::ceil(cv::norm(along) / sample_step_px)));
            for (int k = 0; k < steps; ++k) {
                const cv::Point2d p = line[i - 1] + (static_cast<double>(k) / steps) * along;
                double best = std::numeric_limits<double>::infinity();
                for (const Line& other : to) {
                    best = std::min(best, distance_to(p, other));
                }
                all.push_back(best);
            }
        }
    }
    return all;
}

double part_over(const std::vector<double>& values, double limit) {
    const auto over = std::ranges::count_if(values, [limit](double v) { return v > limit; });
    return static_cast<double>(over) / static_cast<double>(std::max<std::size_t>(1, values.size()));
}

}  // namespace

LineAccuracy accuracy_of(const std::vector<Chain>& lines, const std::vector<Polyline>& truth) {
    std::vector<Line> found;
    for (const Chain& chain : lines) {
        Line& line = found.emplace_back();
        std::ranges::transform(chain.points, std::back_inserter(line), &EdgePoint::at);
        if (chain.is_closed) {
            line.push_back(line.front());
        }
    }
    std::vector<Line> wanted;
    for (const Polyline& ring : truth) {
        wanted.push_back(ring.points);
        wanted.back().push_back(ring.points.front());
    }
    const std::vector<double> to_lines = distances(wanted, found);
    std::vector<double> both = distances(found, wanted);
    if (both.empty()) {
        return {0.0, spurious_beyond_px, spurious_beyond_px, 1.0, 0.0};
    }
    LineAccuracy accuracy;
    accuracy.missing = part_over(to_lines, missing_beyond_px);
    accuracy.spurious = part_over(both, spurious_beyond_px);
    double sum = 0.0;
    int count = 0;
    for (const double d : to_lines) {
        if (d <= missing_beyond_px) {
            sum += d * d;
            ++count;
        }
    }
    accuracy.rms_px = std::sqrt(sum / std::max(1, count));
    both.insert(both.end(), to_lines.begin(), to_lines.end());
    accuracy.greatest_px = *std::ranges::max_element(both);
    const auto rank = static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(both.size() - 1));
    std::ranges::nth_element(both, both.begin() + rank);
    accuracy.p99_px = both[static_cast<std::size_t>(rank)];
    return accuracy;
}

}  // namespace touchline::testing
