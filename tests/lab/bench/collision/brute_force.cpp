#include "tests/lab/bench/collision/brute_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline::bench {

std::optional<Crossing> BruteForce::first_crossing(Position from, Position to) const {
    std::optional<Crossing> first;
    for (std::uint32_t edge = 0; edge < curve_.size(); ++edge) {
        keep_first(first, from, to - from, edge_of(curve_, edge), edge);
    }
    return first;
}

Nearest BruteForce::nearest(Position p) const {
    SquaredFoot best{p, std::numeric_limits<double>::infinity()};
    for (std::size_t edge = 0; edge < curve_.size(); ++edge) {
        const SquaredFoot found = squared_foot(p, edge_of(curve_, edge));
        if (found.squared_m2 < best.squared_m2) best = found;
    }
    return {best.point, std::sqrt(best.squared_m2)};
}

Inside::Inside(ClosedCurve curve) : curve_(curve) {
    const auto [lowest, highest] = std::minmax_element(
        curve.begin(), curve.end(), [](Position a, Position b) { return a.y < b.y; });
    low_ = lowest->y;
    high_ = highest->y;
    bands_.resize(std::clamp<std::size_t>(curve.size() / 4, 64, 8192));
    for (std::uint32_t i = 0; i < curve.size(); ++i) {
        const Segment edge = edge_of(curve, i);
        const std::size_t last = band_of(std::max(edge.a.y, edge.b.y));
        for (std::size_t k = band_of(std::min(edge.a.y, edge.b.y)); k <= last; ++k) {
            bands_[k].push_back(i);
        }
    }
}

std::size_t Inside::band_of(double y) const {
    const auto count = static_cast<double>(bands_.size());
    return static_cast<std::size_t>(
        std::clamp((y - low_) / (high_ - low_) * count, 0.0, count - 1.0));
}

bool Inside::operator()(Position p) const {
    if (!(p.y >= low_ && p.y <= high_)) return false;
    bool is_inside = false;
    for (const std::uint32_t i : bands_[band_of(p.y)]) {
        const auto [a, b] = edge_of(curve_, i);
        const bool is_beside = (a.y > p.y) != (b.y > p.y);
        if (is_beside && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            is_inside = !is_inside;
        }
    }
    return is_inside;
}

}  // namespace touchline::bench
