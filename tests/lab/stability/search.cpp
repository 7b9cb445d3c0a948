#include "tests/lab/stability/search.h"

#include <cmath>

namespace touchline::stability {

double stiffness_at(const StiffnessGrid& grid, int index) {
    return index < 0 ? 0.0 : grid.from_N_per_m * std::pow(grid.step, index);
}

double bisected_stiffness(const StiffnessGrid& grid, const StiffnessTest& holds) {
    int good = -1;
    int bad = grid.count;
    while (bad - good > 1) {
        const int middle = (good + bad) / 2;
        (holds(stiffness_at(grid, middle)) ? good : bad) = middle;
    }
    return stiffness_at(grid, good);
}

double scanned_stiffness(const StiffnessGrid& grid, const StiffnessTest& holds) {
    int good = -1;
    while (good + 1 < grid.count && holds(stiffness_at(grid, good + 1))) ++good;
    return stiffness_at(grid, good);
}

}  // namespace touchline::stability
