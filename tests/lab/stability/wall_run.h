// A device and a hand against a wall, in one dimension, on the production integrator: encoder,
// sampled force law, delay, motors; and the search for the largest stiffness that holds.
// Threads: pure functions.
#pragma once

#include "haptics/device/simulated/simulated_pantograph.h"

#include <functional>
#include <limits>
#include <vector>

namespace touchline::stability {

using StiffnessTest = std::function<bool(double stiffness_N_per_m)>;

/// Geometric.
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

/// Any WallController, or a lambda: takes the quantised position, returns the force, once a period.
using ForceLaw = std::function<double(double x_m)>;

/// What renders the wall, and for whom.
struct WallLoop {
    double period_s = 1e-3;
    double delay_s = 0.0;  // a whole number of substeps
    TipParameters tip;
    HandModel hand = no_hand;
    double encoder_step_m = 0.0;                                // 0: not quantised
    double motors_N = std::numeric_limits<double>::infinity();  // the most that they give
    int substeps = 12;                                          // per period
};

/// How the hand comes to the wall, which is at x = 0.
struct Excitation {
    double start_m = 0.0;
    double speed_m_per_s = 0.1;
    double push_N = 1.0;  // steady, beside the hand's spring and damper to x = 0
    double release_at_s = std::numeric_limits<double>::infinity();  // then push_N becomes ...
    double released_N = 0.0;                                        // ... this
    double acting_N = 0.0;  // the motors' force before the first command arrives
};

struct WallTrace {
    std::vector<double> x_m;      // true position at each sample
    std::vector<double> force_N;  // commanded there
    double work_J = 0.0;          // done by the acting force on the hand
};

/// Returns the encoder's answer: the next step below.
[[nodiscard]] double quantised(double x_m, double encoder_step_m);

/// Ends early, with the trace so far, once the tip is 10 m away.
[[nodiscard]] WallTrace run(const WallLoop& loop, const Excitation& excitation,
                            const ForceLaw& force_law, double span_s);

/// Returns the extent of a trace's positions between two shares of its length; infinity if the tip
/// flew off.
[[nodiscard]] double peak_to_peak_m(const WallTrace& trace, double from_share, double to_share);

/// Returns the largest change of the commanded force from one sample to the next.
[[nodiscard]] double largest_step_N(const WallTrace& trace);

}  // namespace touchline::stability
