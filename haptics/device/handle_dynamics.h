// Simulates a turning handle and the fingers that hold it, as tip_dynamics.h does for the tip:
//   I phi'' = tau + k (phi_d - phi) + c (phi_d' - phi') - b phi' - Coulomb friction
// Threads: a plain value. No allocation.
#pragma once

#include "haptics/device/hand.h"
#include "haptics/pantograph/profile.h"

namespace touchline {

class HandleDynamics {
  public:
    /// Starts at rest at an angle. The fingers hold the handle at 10 mm from its axis.
    HandleDynamics(const TurningHandle& handle, const HandModel& hand, double start_rad)
        : handle_(handle), hand_(hand), angle_rad_(start_rad) {}

    /// Makes one integration step of h_s with the motor's torque and the hand's intention held.
    void step(double torque_Nm, const Intention& intention, double h_s);

    /// Other fingers take the handle where it is, or none do.
    void grip(const HandModel& hand) { hand_ = hand; }

    [[nodiscard]] double angle_rad() const { return angle_rad_; }

    [[nodiscard]] double speed_rad_per_s() const { return speed_rad_per_s_; }

  private:
    TurningHandle handle_;
    HandModel hand_;
    double angle_rad_ = 0.0;
    double speed_rad_per_s_ = 0.0;
};

}  // namespace touchline
