// Measures the energy that the device gave the hand in the last second, and damps or faults if it
// is too much.
// Threads: a plain value.
#pragma once

#include "config/types/vec2.h"

#include <algorithm>

namespace touchline {

/// Sums the plain work of the told force, whatever a spring claims to have stored: a wall holds
/// only a few mJ. Forgotten in 1 s; energy that the hand gave is no credit.
class EnergyGuard {
  public:
    /// Advances one tick of dt_s > 0 in which the handle moved under `force`, and turned under a
    /// torque that did `turning_J` of work.
    void step(Force force, Position moved, double dt_s, double turning_J = 0.0) {
        const double kept_J = given_J_ * std::max(0.0, 1.0 - dt_s / forget_s);
        const double given_J = kept_J + dot(force, moved) + turning_J;
        given_J_ = given_J <= 0.0 ? 0.0 : given_J;  // not a number stays one, and is too much
    }

    [[nodiscard]] double given_J() const { return given_J_; }

    /// The damping to add along the handle's motion: none up to 0.05 J, all of it at 0.1 J.
    [[nodiscard]] double damping_Ns_per_m() const {
        return most_damping_Ns_per_m * std::clamp(given_J_ / damped_from_J - 1.0, 0.0, 1.0);
    }

    /// Returns whether this is a fault. The limit is not lower because a hand that pushed far
    /// beyond a wall and yields gets back what it gave: 2.5 N over the width of the picture is 0.25
    /// J.
    [[nodiscard]] bool is_too_much() const { return !(given_J_ <= too_much_J); }

  private:
    static constexpr double forget_s = 1.0;
    static constexpr double damped_from_J = 0.05;
    static constexpr double too_much_J = 0.3;
    static constexpr double most_damping_Ns_per_m = 2.0;

    double given_J_ = 0.0;
};

}  // namespace touchline
