// What a loop makes of a stiffness that is set.
// Threads: plain values and pure functions.
#pragma once

#include <algorithm>

namespace touchline {

/// Nothing stiffer can be set.
inline constexpr double most_stiffness_N_per_m = 20'000.0;

struct StiffnessBound {
    double share = 1.0;  // of what is set; below 1 without real-time priority
    double most_N_per_m = most_stiffness_N_per_m;  // what rate and delay of the loop allow

    friend bool operator==(const StiffnessBound&, const StiffnessBound&) = default;
};

/// What acts of it.
[[nodiscard]] constexpr double possible_N_per_m(const StiffnessBound& bound, double set_N_per_m) {
    return std::min(bound.share * set_N_per_m, bound.most_N_per_m);
}

}  // namespace touchline
