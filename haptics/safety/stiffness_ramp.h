// Changes the stiffness under the hand in ramps, and books their energy.
// Threads: one, the servo's. A plain value.
#pragma once

namespace touchline {

/// A wall that gets stiffer does work on a hand that presses it, so stiffness rises by at most 5 %
/// of itself a second. It falls so fast that the hand loses 15 N a second: at once if nothing
/// presses.
class StiffnessRamp {
  public:
    explicit StiffnessRamp(double stiffness_N_per_m) : stiffness_N_per_m_(stiffness_N_per_m) {}

    /// Advances one tick towards `wanted_N_per_m` with the spring stretched by depth_m. Values that
    /// are not finite or not positive change nothing. Returns the stiffness to use.
    double step(double wanted_N_per_m, double depth_m, double dt_s);

    [[nodiscard]] double stiffness_N_per_m() const { return stiffness_N_per_m_; }

    /// The energy that the changes have put into the spring so far: the sum of 1/2 dK depth^2.
    [[nodiscard]] double booked_J() const { return booked_J_; }

  private:
    double stiffness_N_per_m_;
    double booked_J_ = 0.0;
};

}  // namespace touchline
