// What a wall that moves may do to the hand: a change of level under the hand does work, and the
// hand must have given it before, or wait for it. Threads: a plain value.
#pragma once

#include <algorithm>

namespace touchline {

/// Never negative, at most 2 mJ, forgotten at a rate of 1/s, so that work done long ago does not
/// pay for a wall that rings now.
class EnergyAccount {
  public:
    /// What the proxy's sliding has dissipated in a tick, and a trickle of 0.1 mW, so that
    /// a hand at rest sees a change through as well, in seconds.
    void earn(double dissipated_J, double dt_s) {
        const double kept_J = balance_J_ * std::max(0.0, 1.0 - leak_per_s * dt_s);
        const double earned_J = std::max(0.0, dissipated_J) + trickle_W * dt_s;
        balance_J_ = std::min(most_J, kept_J + earned_J);
    }

    /// Books the work of a motion; false, and nothing booked, where it is not covered. A wall that
    /// gives way has negative work, which is earned.
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
