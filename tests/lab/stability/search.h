// The largest stiffness for which a condition holds, on a geometric grid.
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

/// Bisects for the largest value of the grid that holds, assuming that all below it hold and all
/// above do not. Returns 0 if the first does not hold.
[[nodiscard]] double bisected_stiffness(const StiffnessGrid& grid, const StiffnessTest& holds);

/// Scans from below. Returns the last value before the first that does not hold.
[[nodiscard]] double scanned_stiffness(const StiffnessGrid& grid, const StiffnessTest& holds);

}  // namespace touchline::stability
