// How a picture feels before anybody chose. Threads: constants and pure functions.
#pragma once

#include "app/session/visit_orders.h"

#include <cstddef>

namespace touchline {

/// The firmest step of at most this stiffness, at least the softest. The operator's own, 500 N/m,
/// lets a groove of the ordinary capture width, 3 mm, hold by 0.5 N at most: more would lead the
/// hand rather than tell it of the line.
[[nodiscard]] constexpr std::size_t firmness_for(double stiffness_N_per_m) {
    std::size_t step = 0;
    while (step + 1 < firmness_steps.size() &&
           firmness_steps[step + 1].stiffness_N_per_m <= stiffness_N_per_m) {
        ++step;
    }
    return step;
}

/// Radius of the proxy: 1.4 F / K at 0.7 N and 700 N/m, so that the force stays continuous around
/// corners at every step of stiffness in ordinary exploration.
inline constexpr double proxy_radius_m = 0.0014;

}  // namespace touchline
