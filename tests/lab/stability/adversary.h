// Energy that a wall gives to a hand that is moved, not free: the adversaries of the literature.
// Threads: pure functions.
#pragma once

namespace touchline::stability {

/// Returns the damping (Ns/m) that just takes the energy the sampled, delayed spring gives while a
/// hand presses at constant speed to a depth and back: mean over 64 phases of the sampling, 10 mm,
/// 0.1 m/s.
[[nodiscard]] double damping_of_a_press(double stiffness_N_per_m, double period_s, double delay_s);

/// The worst of the motions tried.
struct Worst {
    double coulomb_N = 0.0;  // least friction that makes all of them lose energy
    int periods = 0;         // of sampling, in one period of the motion
    double amplitude_m = 0.0;
};

/// Tries triangles around an encoder tick, in step with the sampling: periods of 2 to 8 samples,
/// amplitudes from a thousandth of an encoder step to 20. b: the device's damping.
[[nodiscard]] Worst worst_triangle(double stiffness_N_per_m, double period_s, double encoder_step_m,
                                   double b_Ns_per_m);

}  // namespace touchline::stability
