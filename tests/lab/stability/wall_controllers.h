// Ways to render a wall in one dimension, as in the literature: each sees the quantised position
// once a period and answers with a force. Inside is x > 0; a wall pushes, so its force is negative
// there. Before them the estimates of velocity that they use; after them all by name.
// Threads: plain values, one thread each; the methods are immutable. No allocation in the
// estimates.
#pragma once

#include "haptics/servo/handle_motion.h"
#include "tests/lab/stability/wall_run.h"

#include <algorithm>
#include <concepts>
#include <functional>
#include <span>
#include <string_view>
#include <utility>

namespace touchline::stability {

/// Estimates velocity from a quantised position, one sample a call. Takes a position in metres, and
/// returns the velocity in m/s.
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

/// Takes a position in metres every period, and returns the force on the hand in newtons.
template <class T>
concept WallController = requires(T controller, double x_m) {
    { controller.step(x_m) } -> std::convertible_to<double>;
};

/// C0: F = -K x inside.
class SpringWall {
  public:
    explicit SpringWall(double stiffness_N_per_m) : stiffness_N_per_m_(stiffness_N_per_m) {}

    [[nodiscard]] double step(double x_m) const {
        return x_m > 0.0 ? -stiffness_N_per_m_ * x_m : 0.0;
    }

  private:
    double stiffness_N_per_m_;
};

/// C1: spring and damper that together only push, because a wall that pulled would stick to the
/// hand.
template <VelocityEstimator Estimator>
class DampedWall {
  public:
    DampedWall(double stiffness_N_per_m, double damping_Ns_per_m, Estimator estimator)
        : stiffness_N_per_m_(stiffness_N_per_m),
          damping_Ns_per_m_(damping_Ns_per_m),
          estimator_(std::move(estimator)) {}

    double step(double x_m) {
        const double damper_N = damping_Ns_per_m_ * estimator_.step(x_m);
        if (!(x_m > 0.0)) return 0.0;
        return std::min(-stiffness_N_per_m_ * x_m - damper_N, 0.0);
    }

  private:
    double stiffness_N_per_m_;
    double damping_Ns_per_m_;
    Estimator estimator_;
};

/// C2: geometry gives a local model, here the place of the wall, once in several periods of a
/// spring that runs on its own.
class LocalModelWall {
  public:
    /// geometry_every: at least 1 period of the spring.
    LocalModelWall(double stiffness_N_per_m, int geometry_every)
        : spring_(stiffness_N_per_m), geometry_every_(geometry_every) {}

    /// wall_m: where the wall is now; noticed only when geometry is due.
    double step(double x_m, double wall_m = 0.0);

  private:
    SpringWall spring_;
    int geometry_every_;
    int since_geometry_ = 0;
    double known_wall_m_ = 0.0;
};

/// C3: time-domain passivity (Hannaford and Ryu). An observer adds up the energy that the wall has
/// taken. If that is negative, it adds a damper of just the size to make up for it.
class EnergyObserverWall {
  public:
    /// most_damping: cap of the damper (Ns/m), without which it explodes at low speed. credit_J:
    /// saved before.
    EnergyObserverWall(double stiffness_N_per_m, double period_s, double start_m,
                       double most_damping_Ns_per_m, double credit_J = 0.0)
        : spring_(stiffness_N_per_m),
          period_s_(period_s),
          most_damping_Ns_per_m_(most_damping_Ns_per_m),
          taken_J_(credit_J),
          last_m_(start_m) {}

    double step(double x_m);

  private:
    SpringWall spring_;
    double period_s_;
    double most_damping_Ns_per_m_;
    double taken_J_;
    double last_m_;
    double last_N_ = 0.0;
};

/// C4: energy bounding (after Kim and Ryu, simplified): the force changes at most by the motion
/// times a slope that the device's damping can pay for.
class SlopeBoundWall {
  public:
    SlopeBoundWall(double stiffness_N_per_m, double start_m, double slope_N_per_m)
        : spring_(stiffness_N_per_m), slope_N_per_m_(slope_N_per_m), last_m_(start_m) {}

    double step(double x_m);

  private:
    SpringWall spring_;
    double slope_N_per_m_;
    double last_m_;
    double last_N_ = 0.0;
};

static_assert(WallController<SpringWall> && WallController<DampedWall<FilteredDifference>> &&
              WallController<LocalModelWall> && WallController<EnergyObserverWall> &&
              WallController<SlopeBoundWall>);

/// A method that the laboratory compares: a controller made for a loop at a stiffness.
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
