// The linear loop of a device, a hand and a sampled wall, exactly: one period of it is a matrix,
// and the wall is stable when no eigenvalue of that matrix is as large as 1.
//   plant  m x'' = -b x' - k_h x + u, or tip - skin - hand - ground
//   wall   u_k = -K x_k - B v_k, v_k the low-passed difference of x, held, acting from kT + t_d on
// Threads: a value; const functions from any thread.
#pragma once

#include "haptics/device/simulated/simulated_pantograph.h"

#include <limits>

#include <Eigen/Core>

namespace touchline::stability {

/// A sampled wall without its stiffness.
struct SampledWall {
    double period_s = 1e-3;                                      // T > 0
    double delay_s = 0.0;                                        // t_d >= 0, from sampling to force
    double damping_Ns_per_m = 0.0;                               // B
    double cutoff_Hz = std::numeric_limits<double>::infinity();  // of the velocity, first order
};

/// Returns the share of a new difference in the low-passed velocity, 0 ... 1; 1 without a filter.
[[nodiscard]] double low_pass_share(double cutoff_Hz, double period_s);

class LinearLoop {
  public:
    /// Leaves out Coulomb friction.
    LinearLoop(const TipParameters& tip, const HandModel& hand, const SampledWall& wall);

    [[nodiscard]] double spectral_radius(double stiffness_N_per_m) const;

    /// Returns the largest K up to which every smaller one is stable too, in steps of 2 % from 1
    /// N/m; 0 if even the softest wall is unstable, infinity if `most_N_per_m` is stable.
    [[nodiscard]] double largest_stiffness(double most_N_per_m = 2e5) const;

  private:
    // The matrix of one period is affine in K.
    Eigen::MatrixXd without_spring_;
    Eigen::MatrixXd per_stiffness_;
};

}  // namespace touchline::stability
