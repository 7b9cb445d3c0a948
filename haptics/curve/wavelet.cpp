#include "haptics/curve/wavelet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace touchline {
namespace {

using Index = std::ptrdiff_t;

/// Counts of one lifting step; `fine` is the number of segments of the finer level.
struct Step {
    Index fine;
    Index coarse;
    Index evens;  // coarse points
    Index odds;   // details
    double stride;
    double length;  // parameter length of the curve
    bool is_closed;

    explicit Step(const CurveShape& shape)
        : fine(static_cast<Index>((shape.finest_segments + shape.stride - 1) / shape.stride)),
          coarse((fine + 1) / 2),
          evens(shape.is_closed ? coarse : coarse + 1),
          odds(fine / 2),
          stride(static_cast<double>(shape.stride)),
          length(static_cast<double>(shape.finest_segments)),
          is_closed(shape.is_closed) {}

    /// Returns the index in the finer level of coarse point i. The last point of an open curve with
    /// an odd number of segments is kept although its index is odd.
    [[nodiscard]] Index fine_index(Index i) const {
        return is_closed ? 2 * i : std::min(2 * i, fine);
    }

    /// Returns the parameter of coarse point i, also beyond the seam of a closed curve.
    [[nodiscard]] double parameter(Index i) const {
        if (!is_closed) return std::min(2.0 * stride * static_cast<double>(i), length);
        const Index turns = i >= 0 ? i / coarse : -((coarse - 1 - i) / coarse);
        return 2.0 * stride * static_cast<double>(i - turns * coarse) +
               static_cast<double>(turns) * length;
    }

    /// True if the last coarse segment, of an odd count, is less than half as long as the others.
    [[nodiscard]] bool ends_short() const {
        return length - 2.0 * stride * static_cast<double>(coarse - 1) < stride;
    }

    /// Details from 1 up to but not including this one have two regular coarse points on either
    /// side.
    [[nodiscard]] Index regular_end() const {
        return is_closed ? coarse - 2 : static_cast<Index>(length / (2.0 * stride)) - 1;
    }
};

/// The stencil that predicts detail k (odd point 2k + 1): coarse points and their weights.
struct Stencil {
    std::array<Index, 4> point{};
    std::array<double, 4> weight{};
    int count = 0;
};

/// Lagrange weights at parameter u for the stencil's points.
void lagrange(const Step& step, double u, Index first, int count, Stencil& stencil) {
    stencil.count = count;
    for (int a = 0; a < count; ++a) {
        double weight = 1.0;
        const double ua = step.parameter(first + a);
        for (int b = 0; b < count; ++b) {
            const double ub = step.parameter(first + b);
            if (b != a) weight *= (u - ub) / (ua - ub);
        }
        const auto slot = static_cast<std::size_t>(a);
        stencil.weight[slot] = weight;
        stencil.point[slot] = step.is_closed ? (first + a + step.coarse) % step.coarse : first + a;
    }
}

/// Predicts near an end, a seam or an unpaired segment, by the cubic (or what the points allow)
/// through the nearest points, which equals regular_prediction() wherever the spacing is regular.
/// It never reaches over a segment shorter than half the others: the slope over so short a stretch,
/// continued over a long one, throws coarse levels metres away.
Stencil prediction(const Step& step, Index k) {
    Stencil stencil;
    const bool has_seam = step.is_closed && !step.ends_short();
    const Index usable = step.evens - (!step.is_closed && step.ends_short() ? 1 : 0);
    const int count = static_cast<int>(std::min<Index>(4, std::max<Index>(usable, 2)));
    Index first = k - 1;
    if (!has_seam) first = std::clamp<Index>(first, 0, std::max<Index>(usable, 2) - count);
    lagrange(step, step.stride * static_cast<double>(2 * k + 1), first, count, stencil);
    return stencil;
}

Position predicted(const Stencil& stencil, std::span<const Position> evens) {
    Position sum;
    for (int a = 0; a < stencil.count; ++a) {
        const auto slot = static_cast<std::size_t>(a);
        sum += stencil.weight[slot] * evens[static_cast<std::size_t>(stencil.point[slot])];
    }
    return sum;
}

Position regular_prediction(const Position* even) {
    return (-1.0 / 16) * even[-1] + (9.0 / 16) * even[0] + (9.0 / 16) * even[1] +
           (-1.0 / 16) * even[2];
}

/// Calls take(k, the prediction of odd point 2k + 1 from the evens) for every k.
template <class Take>
void for_each_prediction(const Step& step, std::span<const Position> evens, Take take) {
    const Index regular_end = std::max<Index>(1, step.regular_end());
    const auto near_an_end = [&](Index k) { take(k, predicted(prediction(step, k), evens)); };
    for (Index k = 0; k < std::min<Index>(1, step.odds); ++k) near_an_end(k);
    for (Index k = 1; k < regular_end; ++k) take(k, regular_prediction(evens.data() + k));
    for (Index k = regular_end; k < step.odds; ++k) near_an_end(k);
}

/// Returns the detail at an odd index of the finer level, extended: odd about the ends of an open
/// curve (so that their update is exactly 0), periodic on a closed one. If the parity breaks
/// (unpaired): 0.
Position detail_at(const Step& step, std::span<const Position> details, Index index) {
    double sign = 1.0;
    if (step.is_closed) {
        index = (index + step.fine) % step.fine;
    } else {
        if (index < 0) {
            index = -index;
            sign = -1.0;
        }
        if (index > step.fine) {
            index = 2 * step.fine - index;
            sign = -sign;
        }
    }
    if (index < 0 || index % 2 == 0 || index / 2 >= step.odds) return {};
    return sign * details[static_cast<std::size_t>(index / 2)];
}

/// Returns what the lifting step adds to coarse point i.
Position update(const Step& step, std::span<const Position> details, Index i) {
    const Index at = step.fine_index(i);
    if (!step.is_closed && (at == 0 || at == step.fine)) return {};
    return (9.0 / 32) * (detail_at(step, details, at - 1) + detail_at(step, details, at + 1)) -
           (1.0 / 32) * (detail_at(step, details, at - 3) + detail_at(step, details, at + 3));
}

Position regular_update(const Position* detail) {
    return (9.0 / 32) * (detail[-1] + detail[0]) - (1.0 / 32) * (detail[-2] + detail[1]);
}

/// Calls take(i, update of coarse point i) for every i.
template <class Take>
void for_each_update(const Step& step, std::span<const Position> details, Take take) {
    const Index regular_begin = std::min<Index>(2, step.evens);
    const Index regular_end = std::max(regular_begin, step.odds - 1);
    for (Index i = 0; i < regular_begin; ++i) take(i, update(step, details, i));
    for (Index i = regular_begin; i < regular_end; ++i) take(i, regular_update(details.data() + i));
    for (Index i = regular_end; i < step.evens; ++i) take(i, update(step, details, i));
}

// What prediction and update above amount to as two filters, by distance from their middle tap
// (wavelet.h). noise_gains() alone uses them.
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

void analyze(std::span<const Position> points, const CurveShape& shape, std::span<Position> coarser,
             std::span<Position> details) {
    const Step step(shape);
    const Position* const fine = points.data();
    Position* const coarse = coarser.data();
    Position* const detail = details.data();
    for (Index i = 0; i < step.evens; ++i) coarse[i] = fine[step.fine_index(i)];
    for_each_prediction(step, coarser,
                        [=](Index k, Position p) { detail[k] = fine[2 * k + 1] - p; });
    for_each_update(step, details, [=](Index i, Position u) { coarse[i] += u; });
}

WaveletLevel analyze(const std::vector<Position>& points, const CurveShape& shape) {
    const Step step(shape);
    WaveletLevel coarse;
    coarse.points.resize(static_cast<std::size_t>(step.evens));
    coarse.details.resize(static_cast<std::size_t>(step.odds));
    analyze(points, shape, coarse.points, coarse.details);
    return coarse;
}

std::vector<Position> synthesize(const WaveletLevel& level, const CurveShape& shape) {
    const Step step(shape);
    std::vector<Position> evens = level.points;
    Position* const even = evens.data();
    for_each_update(step, level.details, [=](Index i, Position u) { even[i] += -u; });
    std::vector<Position> points(
        static_cast<std::size_t>(step.is_closed ? step.fine : step.fine + 1));
    Position* const fine = points.data();
    const Position* const detail = level.details.data();
    for (Index i = 0; i < step.evens; ++i) fine[step.fine_index(i)] = even[i];
    for_each_prediction(step, evens, [=](Index k, Position p) { fine[2 * k + 1] = detail[k] + p; });
    return points;
}

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
    if (kept == 0) return std::ranges::max(sizes) * 2.0 + 1.0;
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
