// The largest stiffness for which something holds, on a geometric grid.
// Threads: pure functions.
#pragma once

#include <functional>

namespace touchline::stability {

using StiffnessTest = std::function<bool(double stiffness_N_per_m)>;

struct StiffnessGrid {
    double from_N_per_m = 20.0;
    double step = 1.01;  // ratio of neighbours, > 1
    int count = 765;     // of values
};

[[nodiscard]] double stiffness_at(const StiffnessGrid& grid, int index);

/// Bisection: the largest value of the grid that holds, where all below it are taken to hold and
/// all above not to; 0 where the first does not hold.
[[nodiscard]] double bisected_stiffness(const StiffnessGrid& grid, const StiffnessTest& holds);

/// Scan from below: the last value before the first that does not hold.
[[nodiscard]] double scanned_stiffness(const StiffnessGrid& grid, const StiffnessTest& holds);

}  // namespace touchline::stability
