// What the device gave the hand in the last second, and what is done about too much of it.
// Threads: a plain value.
#pragma once

#include "config/types/vec2.h"

#include <algorithm>

namespace touchline {

/// The plain work of the told force, taking no word of a spring for it: what a wall holds is a few
/// mJ. Forgotten in 1 s; what the hand gave is no credit.
class EnergyGuard {
  public:
    /// One tick of dt_s > 0 in which the handle moved under `force`, and turned under a torque that
    /// did `turning_J` of work.
    void step(Force force, Position moved, double dt_s, double turning_J = 0.0) {
        const double kept_J = given_J_ * std::max(0.0, 1.0 - dt_s / forget_s);
        const double given_J = kept_J + dot(force, moved) + turning_J;
        given_J_ = given_J <= 0.0 ? 0.0 : given_J;  // not a number stays one, and is too much
    }

    [[nodiscard]] double given_J() const { return given_J_; }

    /// To be added, along the handle's motion: none up to 0.05 J, all of it at 0.1 J.
    [[nodiscard]] double damping_Ns_per_m() const {
        return most_damping_Ns_per_m * std::clamp(given_J_ / damped_from_J - 1.0, 0.0, 1.0);
    }

    /// A fault. Not earlier, since a hand that pushed far beyond a wall and yields is given back
    /// what it gave: 2.5 N over the width of the picture are 0.25 J.
    [[nodiscard]] bool is_too_much() const { return !(given_J_ <= too_much_J); }

  private:
    static constexpr double forget_s = 1.0;
    static constexpr double damped_from_J = 0.05;
    static constexpr double too_much_J = 0.3;
    static constexpr double most_damping_Ns_per_m = 2.0;

    double given_J_ = 0.0;
};

}  // namespace touchline
