// Bounds a stiffness that is set to what the loop can render.
// Threads: plain values and pure functions.
#pragma once

#include <algorithm>

namespace touchline {

/// The largest stiffness that can be set.
inline constexpr double most_stiffness_N_per_m = 20'000.0;

struct StiffnessBound {
    double share = 1.0;  // of the stiffness set; below 1 without real-time priority
    double most_N_per_m = most_stiffness_N_per_m;  // what the loop's rate and delay allow

    friend bool operator==(const StiffnessBound&, const StiffnessBound&) = default;
};

/// Returns the stiffness that acts for the one that is set.
[[nodiscard]] constexpr double possible_N_per_m(const StiffnessBound& bound, double set_N_per_m) {
    return std::min(bound.share * set_N_per_m, bound.most_N_per_m);
}

}  // namespace touchline
