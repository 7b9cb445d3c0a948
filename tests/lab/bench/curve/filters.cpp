#include "tests/lab/bench/curve/filters.h"

#include "haptics/curve/segment.h"
#include "haptics/curve/wavelet.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>
#include <utility>

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

/// A stretch between two kept points, and its point farthest from the chord.
struct Chord {
    double deviation_m = -1.0;
    std::size_t first = 0;
    std::size_t farthest = 0;
    std::size_t last = 0;

    friend bool operator<(const Chord& a, const Chord& b) { return a.deviation_m < b.deviation_m; }
};

Chord chord(const std::vector<Position>& points, std::size_t first, std::size_t last) {
    Chord made{-1.0, first, first, last};
    for (std::size_t i = first + 1; i < last; ++i) {
        const double deviation = foot(points[i], {points[first], points[last]}).distance_m;
        if (deviation > made.deviation_m) {
            made.deviation_m = deviation;
            made.farthest = i;
        }
    }
    return made;
}

/// The remaining points, as a list, and those of least area first.
class Triangles {
  public:
    explicit Triangles(const std::vector<Position>& points) : points_(points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            before_.push_back(i - 1);
            after_.push_back(i + 1);
            area_.push_back(0.0);
        }
        for (std::size_t i = 1; i + 1 < points.size(); ++i) insert(i);
    }

    void remove_least() {
        const auto [area, gone] = *by_area_.begin();
        by_area_.erase(by_area_.begin());
        const std::size_t a = before_[gone];
        const std::size_t b = after_[gone];
        after_[a] = b;
        before_[b] = a;
        for (const std::size_t near : {a, b}) {
            if (near == 0 || near + 1 == points_.size()) continue;
            by_area_.erase({area_[near], near});
            insert(near, area);
        }
    }

    [[nodiscard]] std::vector<std::size_t> left() const {
        std::vector<std::size_t> kept;
        for (std::size_t i = 0; i < points_.size(); i = after_[i]) kept.push_back(i);
        return kept;
    }

  private:
    /// No area counts for less than that of a point removed before.
    void insert(std::size_t i, double least = 0.0) {
        const Position a = points_[before_[i]] - points_[i];
        const Position b = points_[after_[i]] - points_[i];
        area_[i] = std::max(least, 0.5 * std::abs(cross(a, b)));
        by_area_.insert({area_[i], i});
    }

    const std::vector<Position>& points_;
    std::vector<std::size_t> before_, after_;
    std::vector<double> area_;
    std::set<std::pair<double, std::size_t>> by_area_;
};

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

std::vector<std::size_t> douglas_peucker(const std::vector<Position>& points, std::size_t count) {
    const std::size_t end = points.size() - 1;
    std::vector<std::size_t> kept{0, end};
    std::priority_queue<Chord> chords;
    chords.push(chord(points, 0, end));
    while (kept.size() < count) {
        const Chord worst = chords.top();
        chords.pop();
        kept.push_back(worst.farthest);
        chords.push(chord(points, worst.first, worst.farthest));
        chords.push(chord(points, worst.farthest, worst.last));
    }
    std::sort(kept.begin(), kept.end());
    return kept;
}

std::vector<std::size_t> visvalingam(const std::vector<Position>& points, std::size_t count) {
    Triangles triangles(points);
    for (std::size_t left = points.size(); left > count; --left) triangles.remove_least();
    return triangles.left();
}

}  // namespace touchline::bench
