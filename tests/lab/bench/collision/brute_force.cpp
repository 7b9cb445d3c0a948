#include "tests/lab/bench/collision/brute_force.h"

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

}  // namespace touchline::bench
