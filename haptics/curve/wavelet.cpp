#include "haptics/curve/wavelet.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

using Index = std::ptrdiff_t;

/// Counts of one lifting step; `fine` are segments of the finer level.
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

    /// Index in the finer level of coarse point i. The last point of an open curve with an odd
    /// number of segments is kept although its index is odd.
    [[nodiscard]] Index fine_index(Index i) const {
        return is_closed ? 2 * i : std::min(2 * i, fine);
    }

    /// Parameter of coarse point i, also beyond the seam of a closed curve.
    [[nodiscard]] double parameter(Index i) const {
        if (!is_closed) return std::min(2.0 * stride * static_cast<double>(i), length);
        const Index turns = i >= 0 ? i / coarse : -((coarse - 1 - i) / coarse);
        return 2.0 * stride * static_cast<double>(i - turns * coarse) +
               static_cast<double>(turns) * length;
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

Stencil prediction(const Step& step, Index k) {
    Stencil stencil;
    const bool is_regular =
        k >= 1 && (step.is_closed ? k + 2 < step.coarse
                                  : step.stride * static_cast<double>(2 * (k + 2)) <= step.length);
    if (is_regular) {
        stencil = {{k - 1, k, k + 1, k + 2}, {-1.0 / 16, 9.0 / 16, 9.0 / 16, -1.0 / 16}, 4};
        return stencil;
    }
    // Near an end, a seam or an unpaired segment: the cubic (or what the points allow) through the
    // nearest points, which equals the rule above wherever the spacing is regular.
    const int count = static_cast<int>(std::min<Index>(4, step.evens));
    Index first = k - 1;
    if (!step.is_closed) first = std::clamp<Index>(first, 0, step.evens - count);
    lagrange(step, step.stride * static_cast<double>(2 * k + 1), first, count, stencil);
    return stencil;
}

Position predicted(const Stencil& stencil, const std::vector<Position>& evens) {
    Position sum;
    for (int a = 0; a < stencil.count; ++a) {
        const auto slot = static_cast<std::size_t>(a);
        sum += stencil.weight[slot] * evens[static_cast<std::size_t>(stencil.point[slot])];
    }
    return sum;
}

/// The detail at an odd index of the finer level, extended: odd about the ends of an open curve (so
/// that their update is exactly 0), periodic on a closed one. Where parity breaks (unpaired): 0.
Position detail_at(const Step& step, const std::vector<Position>& details, Index index) {
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

/// What the lifting step adds to coarse point i.
Position update(const Step& step, const std::vector<Position>& details, Index i) {
    const Index at = step.fine_index(i);
    if (!step.is_closed && (at == 0 || at == step.fine)) return {};
    return (9.0 / 32) * (detail_at(step, details, at - 1) + detail_at(step, details, at + 1)) -
           (1.0 / 32) * (detail_at(step, details, at - 3) + detail_at(step, details, at + 3));
}

}  // namespace

WaveletLevel analyze(const std::vector<Position>& points, const CurveShape& shape) {
    const Step step(shape);
    WaveletLevel coarse;
    coarse.points.resize(static_cast<std::size_t>(step.evens));
    coarse.details.resize(static_cast<std::size_t>(step.odds));
    for (Index i = 0; i < step.evens; ++i) {
        coarse.points[static_cast<std::size_t>(i)] =
            points[static_cast<std::size_t>(step.fine_index(i))];
    }
    for (Index k = 0; k < step.odds; ++k) {
        coarse.details[static_cast<std::size_t>(k)] = points[static_cast<std::size_t>(2 * k + 1)] -
                                                      predicted(prediction(step, k), coarse.points);
    }
    for (Index i = 0; i < step.evens; ++i) {
        coarse.points[static_cast<std::size_t>(i)] += update(step, coarse.details, i);
    }
    return coarse;
}

std::vector<Position> synthesize(const WaveletLevel& level, const CurveShape& shape) {
    const Step step(shape);
    std::vector<Position> evens = level.points;
    for (Index i = 0; i < step.evens; ++i) {
        evens[static_cast<std::size_t>(i)] += -update(step, level.details, i);
    }
    const auto count = static_cast<std::size_t>(step.is_closed ? step.fine : step.fine + 1);
    std::vector<Position> fine(count);
    for (Index i = 0; i < step.evens; ++i) {
        fine[static_cast<std::size_t>(step.fine_index(i))] = evens[static_cast<std::size_t>(i)];
    }
    for (Index k = 0; k < step.odds; ++k) {
        fine[static_cast<std::size_t>(2 * k + 1)] =
            level.details[static_cast<std::size_t>(k)] + predicted(prediction(step, k), evens);
    }
    return fine;
}

}  // namespace touchline
