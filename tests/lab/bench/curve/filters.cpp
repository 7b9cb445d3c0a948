#include "tests/lab/bench/curve/filters.h"

#include "haptics/curve/wavelet.h"

#include <cmath>

namespace touchline::bench {
namespace {

using Points = std::vector<Position>;

// The 9/7 of Cohen, Daubechies and Feauveau in Daubechies and Sweldens' lifting steps (ISO
// 15444-1).
constexpr double alpha = -1.586134342059924;
constexpr double beta = -0.052980118572961;
constexpr double gamma = 0.882911075530934;
constexpr double delta = 0.443506852043971;
constexpr double scale = 1.230174104914001;

void split(const Points& points, WaveletLevel& level) {
    const std::size_t half = points.size() / 2;
    level.points.resize(half);
    level.details.resize(half);
    for (std::size_t k = 0; k < half; ++k) {
        level.points[k] = points[2 * k];
        level.details[k] = points[2 * k + 1];
    }
}

Points merged(const Points& evens, const Points& odds) {
    Points points(2 * evens.size());
    for (std::size_t k = 0; k < evens.size(); ++k) {
        points[2 * k] = evens[k];
        points[2 * k + 1] = odds[k];
    }
    return points;
}

/// Gives each odd point `weight` times the sum of its even neighbours.
void lift_odds(const Points& evens, Points& odds, double weight) {
    const std::size_t last = odds.size() - 1;
    for (std::size_t k = 0; k < last; ++k) odds[k] += weight * (evens[k] + evens[k + 1]);
    odds[last] += weight * (evens[last] + evens[0]);
}

void lift_evens(Points& evens, const Points& odds, double weight) {
    const std::size_t last = evens.size() - 1;
    evens[0] += weight * (odds[last] + odds[0]);
    for (std::size_t k = 1; k <= last; ++k) evens[k] += weight * (odds[k - 1] + odds[k]);
}

void multiply(Points& points, double factor) {
    for (Position& p : points) p = factor * p;
}

CurveShape shape_of(std::size_t points) {
    return {points, 1, true};
}

/// Returns per level the standard deviation of a detail of white noise of standard deviation 1.
std::vector<double> noise_gains(Filter filter, std::size_t count, int levels) {
    std::vector<double> squares(static_cast<std::size_t>(levels), 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        Points impulse(count);
        impulse[i].x = 1.0;
        for (double& square : squares) {
            WaveletLevel level = analyze_closed(filter, impulse);
            square += level.details[0].x * level.details[0].x;
            impulse = std::move(level.points);
        }
    }
    for (double& square : squares) square = std::sqrt(square);
    return squares;
}

}  // namespace

std::string_view name_of(Filter filter) {
    switch (filter) {
        case Filter::paper_13_7:
            return "13/7";
        case Filter::haar:
            return "Haar";
        case Filter::cdf_5_3:
            return "5/3";
        case Filter::cdf_9_7:
            return "9/7";
        case Filter::subsample:
            return "subsampling";
    }
    return "";
}

double first_parameter(Filter filter, int level) {
    return filter == Filter::haar ? 0.5 * (std::exp2(level) - 1.0) : 0.0;
}

WaveletLevel analyze_closed(Filter filter, const Points& points) {
    if (filter == Filter::paper_13_7) return analyze(points, shape_of(points.size()));
    WaveletLevel level;
    split(points, level);
    if (filter == Filter::haar) {
        for (std::size_t k = 0; k < level.points.size(); ++k) {
            level.details[k] += -level.points[k];
            level.points[k] += 0.5 * level.details[k];
        }
    } else if (filter == Filter::cdf_5_3) {
        lift_odds(level.points, level.details, -0.5);
        lift_evens(level.points, level.details, 0.25);
    } else if (filter == Filter::cdf_9_7) {
        lift_odds(level.points, level.details, alpha);
        lift_evens(level.points, level.details, beta);
        lift_odds(level.points, level.details, gamma);
        lift_evens(level.points, level.details, delta);
        multiply(level.points, 1.0 / scale);
    }
    return level;
}

Points synthesize_closed(Filter filter, const WaveletLevel& level) {
    if (filter == Filter::paper_13_7) return synthesize(level, shape_of(2 * level.points.size()));
    Points evens = level.points;
    Points odds = level.details;
    if (filter == Filter::haar) {
        for (std::size_t k = 0; k < evens.size(); ++k) {
            evens[k] += -0.5 * odds[k];
            odds[k] += evens[k];
        }
    } else if (filter == Filter::cdf_5_3) {
        lift_evens(evens, odds, -0.25);
        lift_odds(evens, odds, 0.5);
    } else if (filter == Filter::cdf_9_7) {
        multiply(evens, scale);
        lift_evens(evens, odds, -delta);
        lift_odds(evens, odds, -gamma);
        lift_evens(evens, odds, -beta);
        lift_odds(evens, odds, -alpha);
    }
    return merged(evens, odds);
}

Points coarser_open(Filter filter, const Points& points) {
    const std::size_t segments = points.size() - 1;
    if (filter == Filter::paper_13_7) return analyze(points, {segments, 1, false}).points;
    const auto chord = [&](std::size_t i) {
        const double share = static_cast<double>(i) / static_cast<double>(segments);
        return points.front() + share * (points.back() - points.front());
    };
    Points turned(2 * segments);
    for (std::size_t i = 1; i < segments; ++i) {
        turned[i] = points[i] - chord(i);
        turned[2 * segments - i] = -turned[i];
    }
    Points coarse = analyze_closed(filter, turned).points;
    coarse.resize(segments / 2 + 1);
    for (std::size_t i = 0; i < coarse.size(); ++i) coarse[i] += chord(2 * i);
    return coarse;
}

Points denoised(Filter filter, const Points& points, double sigma_m, int levels) {
    if (filter == Filter::paper_13_7) {
        Decomposition curve = decompose(points, shape_of(points.size()), levels);
        touchline::denoise(curve, sigma_m);
        return reconstruct(curve);
    }
    const std::vector<double> gains = noise_gains(filter, points.size(), levels);
    std::vector<WaveletLevel> all;
    Points coarse = points;
    for (const double gain : gains) {
        all.push_back(analyze_closed(filter, coarse));
        coarse = all.back().points;
        denoise_level(all.back().details, sigma_m * gain, points.size());
    }
    for (std::size_t i = all.size(); i-- > 0;) {
        coarse = synthesize_closed(filter, {std::move(coarse), all[i].details});
    }
    return coarse;
}

}  // namespace touchline::bench
