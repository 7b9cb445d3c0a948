// Damps a sampled spring without ever pulling where the spring pushes (facts 1.3, 1.4).
// Threads: a pure function.
#pragma once

#include "config/types/vec2.h"

#include <algorithm>

namespace touchline {

inline constexpr double damped_in_full_N = 0.2;

/// Takes B v off the spring's force along its own direction, but leaves at least 0: it never holds
/// back a hand that leaves the wall, and damps nothing along the wall. A spring of less than 0.2 N
/// is damped in proportion, so that nothing jumps where it begins or ends. O(1).
[[nodiscard]] inline Force damped(Force spring, Velocity velocity, double damping_Ns_per_m) {
    const double spring_N = norm(spring);
    if (!(spring_N > 0.0)) return spring;
    const double outward_m_per_s = dot(spring, velocity) / spring_N;
    const double damping = damping_Ns_per_m * std::min(1.0, spring_N / damped_in_full_N);
    const double total_N = std::max(0.0, spring_N - damping * outward_m_per_s);
    return total_N / spring_N * spring;
}

}  // namespace touchline
