// Motions over a curve for tests: short ones of a hand near it, and some right across.
// Threads: pure functions.
#pragma once

#include "config/types/vec2.h"
#include "tests/lab/bench/workload.h"

#include <cmath>
#include <random>
#include <vector>

namespace touchline::bench {

struct TestMotion {
    Position from, to;
};

/// Returns repeatable motions. Nine of ten start within 2 mm of a corner of the curve and are up to
/// 1 mm long; the tenth joins two places up to 60 mm from the centre.
[[nodiscard]] inline std::vector<TestMotion> test_motions(const std::vector<Position>& curve,
                                                          std::size_t count) {
    std::mt19937_64 random(20);  // NOLINT(cert-msc51-cpp): the same motions every day
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::uniform_int_distribution<std::size_t> corner(0, curve.size() - 1);
    const auto within = [&](double reach_m) {
        const double x = reach_m * unit(random);
        return Position{x, reach_m * unit(random)};
    };
    std::vector<TestMotion> motions;
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_long = i % 10 == 9;
        const Position from = is_long ? within(0.06) : curve[corner(random)] + within(0.002);
        motions.push_back({from, is_long ? within(0.06) : from + within(0.001)});
    }
    return motions;
}

}  // namespace touchline::bench
