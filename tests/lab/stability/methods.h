// The methods that the laboratory compares, by name: a controller made for a loop at a stiffness.
// Threads: immutable.
#pragma once

#include "tests/lab/stability/wall_run.h"

#include <functional>
#include <span>
#include <string_view>

namespace touchline::stability {

struct Method {
    std::string_view name;
    double damping_Ns_per_m = 0.0;
    /// Periods of the force loop per period of the geometry: it divides the loop's period.
    int local_rate = 1;
    std::function<ForceLaw(double stiffness_N_per_m, double damping_Ns_per_m, const WallLoop&,
                           double start_m)>
        make;
};

/// Returns spring; spring + difference, + 100 Hz low pass, + FOAW 16 (damping 2); + 100 Hz low pass
/// (damping 5); local model; observer; observer with a cap of 30 Ns/m; slope bound.
[[nodiscard]] std::span<const Method> methods();

/// Returns the method of this name, which must be one of methods().
[[nodiscard]] const Method& method(std::string_view name);

/// Returns the damping that a loop may count on: the tip's and the worse of the skin's and the
/// hand's.
[[nodiscard]] double damping_counted(const WallLoop& loop);

/// Returns the loop that the force runs in: a method with a local model has a shorter period, and
/// so a shorter delay.
[[nodiscard]] WallLoop force_loop(const Method& method, const WallLoop& loop);

/// Renders the wall at this stiffness and the method's own damping, under an excitation.
[[nodiscard]] WallTrace render(const Method& method, double stiffness_N_per_m, const WallLoop& loop,
                               const Excitation& excitation, double span_s);

}  // namespace touchline::stability
