#include "haptics/curve/shrink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace touchline {
namespace {

// The analysis filters, by distance from their middle tap (wavelet.h).
constexpr std::array low_pass{348.0 / 512, 144.0 / 512, -63.0 / 512, -16.0 / 512,
                              18.0 / 512,  0.0,         -1.0 / 512};
constexpr std::array high_pass{1.0, -9.0 / 16, 0.0, 1.0 / 16};
constexpr int most_correlated = 12;  // twice the reach of the low-pass

/// Reads a symmetric sequence given from its middle on; it is 0 beyond.
double at(std::span<const double> half, int i) {
    const auto distance = static_cast<std::size_t>(std::abs(i));
    return distance < half.size() ? half[distance] : 0.0;
}

/// Returns the covariance, at `lag`, of noise after a filter.
double filtered(std::span<const double> covariance, std::span<const double> taps, int lag) {
    const int reach = static_cast<int>(taps.size()) - 1;
    double sum = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            sum += at(taps, i) * at(taps, j) * at(covariance, lag + i - j);
        }
    }
    return sum;
}

CurveShape at_level(const CurveShape& shape, std::size_t level) {
    CurveShape finer = shape;
    finer.stride = shape.stride << level;
    return finer;
}

/// The energy weight of a detail: it stands for twice as much of the curve on each coarser level.
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

std::vector<double> noise_gains(std::size_t levels) {
    std::vector<double> gains;
    std::vector<double> covariance{1.0};
    while (gains.size() < levels) {
        gains.push_back(std::sqrt(filtered(covariance, high_pass, 0)));
        std::vector<double> coarser;
        for (int lag = 0; lag <= most_correlated; ++lag) {
            coarser.push_back(filtered(covariance, low_pass, 2 * lag));
        }
        covariance = std::move(coarser);
    }
    return gains;
}

void denoise_level(std::span<Position> details, double noise_m, std::size_t count) {
    double energy = 0.0;
    for (const Position d : details) energy += dot(d, d);
    const double noise_energy = 2.0 * noise_m * noise_m * static_cast<double>(details.size());
    if (energy > 2.0 * noise_energy) return;  // more signal than noise
    const double square = 2.0 * std::log(static_cast<double>(count)) * noise_m * noise_m;
    for (Position& d : details) {
        d = dot(d, d) > square ? (1.0 - square / dot(d, d)) * d : Position{};
    }
}

void denoise(Decomposition& curve, double sigma_m) {
    const std::vector<double> gains = noise_gains(curve.details.size());
    const std::size_t count = std::max<std::size_t>(2, curve.shape.finest_segments);
    for (std::size_t level = 0; level < gains.size(); ++level) {
        denoise_level(curve.details[level], sigma_m * gains[level], count);
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
