// Limits the work that a moving wall does on the hand. A change of level under the hand does work,
// so the hand must have given that energy before, or the change waits. Threads: a plain value.
#pragma once

#include <algorithm>

namespace touchline {

/// The balance is never negative and at most 2 mJ. It leaks at a rate of 1/s, so that work done
/// long ago does not pay for a wall that rings now.
class EnergyAccount {
  public:
    /// Adds what the proxy's sliding has dissipated in a tick, and a trickle of 0.1 mW, so that a
    /// change also completes under a hand at rest, within seconds.
    void earn(double dissipated_J, double dt_s) {
        const double kept_J = balance_J_ * std::max(0.0, 1.0 - leak_per_s * dt_s);
        const double earned_J = std::max(0.0, dissipated_J) + trickle_W * dt_s;
        balance_J_ = std::min(most_J, kept_J + earned_J);
    }

    /// Books the work of a motion. Returns false, and books nothing, if the balance does not cover
    /// it. A wall that gives way has negative work, which is added.
    [[nodiscard]] bool spend(double work_J) {
        if (!(work_J <= balance_J_)) return false;
        balance_J_ = std::min(most_J, balance_J_ - work_J);
        return true;
    }

    [[nodiscard]] double balance_J() const { return balance_J_; }

  private:
    static constexpr double most_J = 2e-3;
    static constexpr double leak_per_s = 1.0;
    static constexpr double trickle_W = 1e-4;

    double balance_J_ = 0.0;
};

}  // namespace touchline
