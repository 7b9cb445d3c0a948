#include "haptics/curve/shrink.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

// Gain of white noise through the prediction, sqrt(1 + (9^2 + 9^2 + 1 + 1) / 16^2), and through the
// 13-tap low-pass, the root of the sum of its squared taps.
constexpr double detail_gain = 1.2808688457449497;
constexpr double low_pass_gain = 0.80926;

CurveShape at_level(const CurveShape& shape, std::size_t level) {
    CurveShape finer = shape;
    finer.stride = shape.stride << level;
    return finer;
}

/// Energy weight of a detail: it stands for twice as much of the curve on each coarser level.
double scaled_size(Position detail, std::size_t level) {
    return norm(detail) * std::exp2(0.5 * static_cast<double>(level));
}

}  // namespace

Decomposition decompose(std::vector<Position> points, const CurveShape& shape, int levels) {
    Decomposition curve;
    curve.shape = shape;
    for (std::size_t level = 0; level < static_cast<std::size_t>(levels); ++level) {
        WaveletLevel coarser = analyze(points, at_level(shape, level));
        curve.details.push_back(std::move(coarser.details));
        points = std::move(coarser.points);
    }
    curve.coarsest = std::move(points);
    return curve;
}

std::vector<Position> reconstruct(const Decomposition& curve) {
    std::vector<Position> points = curve.coarsest;
    for (std::size_t level = curve.details.size(); level-- > 0;) {
        points =
            synthesize({std::move(points), curve.details[level]}, at_level(curve.shape, level));
    }
    return points;
}

void denoise(Decomposition& curve, double sigma_m) {
    const double count = std::max(2.0, static_cast<double>(curve.shape.finest_segments));
    double threshold = sigma_m * detail_gain * std::sqrt(2.0 * std::log(count));
    for (auto& level : curve.details) {
        for (Position& detail : level) {
            const double size = norm(detail);
            detail = size > threshold ? (1.0 - threshold / size) * detail : Position{};
        }
        threshold *= low_pass_gain;
    }
}

double detail_threshold(std::span<const Decomposition> curves, double keep) {
    std::vector<double> sizes;
    for (const Decomposition& curve : curves) {
        for (std::size_t level = 0; level < curve.details.size(); ++level) {
            for (const Position d : curve.details[level]) sizes.push_back(scaled_size(d, level));
        }
    }
    const auto kept = static_cast<std::size_t>(std::ceil(keep * static_cast<double>(sizes.size())));
    if (kept >= sizes.size()) return 0.0;
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() - kept);
    if (kept == 0) return *std::max_element(sizes.begin(), sizes.end()) * 2.0 + 1.0;
    std::nth_element(sizes.begin(), at, sizes.end());
    return *at;
}

void drop_details(Decomposition& curve, double threshold_m) {
    for (std::size_t level = 0; level < curve.details.size(); ++level) {
        for (Position& detail : curve.details[level]) {
            if (scaled_size(detail, level) < threshold_m) detail = {};
        }
    }
}

}  // namespace touchline
