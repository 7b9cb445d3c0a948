#include "haptics/safety/stiffness_ramp.h"

#include <algorithm>
#include <cmath>

namespace touchline {

namespace {

constexpr double rise_per_s = 0.05;    // of the stiffness itself
constexpr double fall_N_per_s = 15.0;  // of the force: below what is felt as a jolt
constexpr double least_depth_m = 1e-6;

}  // namespace

double StiffnessRamp::step(double wanted_N_per_m, double depth_m, double dt_s) {
    const bool is_sound = std::isfinite(wanted_N_per_m) && wanted_N_per_m > 0.0 &&
                          std::isfinite(depth_m) && std::isfinite(dt_s) && dt_s > 0.0;
    if (!is_sound) return stiffness_N_per_m_;
    const double before = stiffness_N_per_m_;
    const double lowest = before - fall_N_per_s * dt_s / std::max(std::abs(depth_m), least_depth_m);
    const double wanted = std::max(wanted_N_per_m, lowest);
    stiffness_N_per_m_ = std::min(wanted, before * (1.0 + rise_per_s * dt_s));
    booked_J_ += 0.5 * (stiffness_N_per_m_ - before) * depth_m * depth_m;
    return stiffness_N_per_m_;
}

}  // namespace touchline
