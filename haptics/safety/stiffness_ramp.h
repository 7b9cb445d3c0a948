// Changes of stiffness under the hand, ramped and booked.
// Threads: one, the servo's. A plain value.
#pragma once

namespace touchline {

/// A stiffer wall under a hand that presses does work on it, so stiffness rises by at most 5 % of
/// itself a second. It falls as fast as takes 15 N a second off the hand: at once where nothing
/// presses.
class StiffnessRamp {
  public:
    explicit StiffnessRamp(double stiffness_N_per_m) : stiffness_N_per_m_(stiffness_N_per_m) {}

    /// One tick towards `wanted_N_per_m` with the spring stretched by depth_m; values that are not
    /// finite or not positive change nothing. Returns the stiffness to use.
    double step(double wanted_N_per_m, double depth_m, double dt_s);

    [[nodiscard]] double stiffness_N_per_m() const { return stiffness_N_per_m_; }

    /// Energy that the changes have put into the spring so far: the sum of 1/2 dK depth^2.
    [[nodiscard]] double booked_J() const { return booked_J_; }

  private:
    double stiffness_N_per_m_;
    double booked_J_ = 0.0;
};

}  // namespace touchline
