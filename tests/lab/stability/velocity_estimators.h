// Estimates of velocity from a quantised position, one sample a call.
// Threads: plain values. No allocation.
#pragma once

#include "haptics/servo/handle_motion.h"

#include <concepts>

namespace touchline::stability {

/// Takes a position in metres, and returns the velocity in m/s.
template <class T>
concept VelocityEstimator = requires(T estimator, double x_m) {
    { estimator.step(x_m) } -> std::convertible_to<double>;
};

/// First-order low pass of the difference; without a cut-off the difference itself.
class FilteredDifference {
  public:
    /// start_m: where the first difference starts. share: of each new difference, 0 < share <= 1.
    FilteredDifference(double period_s, double start_m, double share = 1.0)
        : period_s_(period_s), last_m_(start_m), share_(share) {}

    double step(double x_m);

  private:
    double period_s_;
    double last_m_;
    double share_;
    double velocity_m_per_s_ = 0.0;
};

/// FOAW 16, the servo's own, on one axis. Begins at rest at start_m.
class AdaptiveWindow {
  public:
    /// encoder_step_m 0: only the newest difference fits, to rounding.
    AdaptiveWindow(double period_s, double start_m, double encoder_step_m);

    double step(double x_m) { return estimate_.step({x_m, 0.0}, period_s_).x; }

  private:
    double period_s_;
    VelocityEstimate estimate_;
};

/// Kalman filter of a mass pushed by white acceleration.
class KalmanVelocity {
  public:
    KalmanVelocity(double period_s, double start_m, double encoder_step_m,
                   double acceleration_m_per_s2);

    double step(double x_m);

  private:
    double period_s_;
    double noise_m2_;       // variance of a quantised sample
    double acceleration2_;  // variance of the acceleration
    double x_m_;
    double v_m_per_s_ = 0.0;
    // Covariance.
    double xx_ = 1.0;
    double xv_ = 0.0;
    double vv_ = 1.0;
};

}  // namespace touchline::stability
