// Estimates how warm the motors are from the torques told, and how much force that leaves.
// Threads: a plain value.
#pragma once

#include "config/types/vec2.h"

#include <algorithm>

namespace touchline {

/// A first-order model. A rise of 1 is the rated one, which the continuous torque reaches in the
/// end. Heat goes with the square of the current, and so of the torque.
class MotorHeat {
  public:
    /// Both > 0: the torque that a motor bears forever, and the time constant of its warming.
    MotorHeat(double continuous_torque_Nm, double warming_s)
        : continuous_torque_Nm_(continuous_torque_Nm), warming_s_(warming_s) {}

    /// Advances one tick of dt_s > 0 with finite torques.
    void step(JointTorques torques, double dt_s) {
        const double share = std::min(1.0, dt_s / warming_s_);
        const auto warm = [&](double& rise, double torque_Nm) {
            const double load = torque_Nm / continuous_torque_Nm_;
            rise += share * (load * load - rise);
        };
        warm(rise_1_, torques.x);
        warm(rise_2_, torques.y);
    }

    /// The warmer motor's rise; 1 is rated.
    [[nodiscard]] double rise() const { return std::max(rise_1_, rise_2_); }

    /// The share of the force allowed: 1 up to 70 % of the rated rise, 0 from 90 % on, linear in
    /// between.
    [[nodiscard]] double allowed() const {
        return std::clamp((derated_to_zero - rise()) / (derated_to_zero - derated_from), 0.0, 1.0);
    }

  private:
    static constexpr double derated_from = 0.7;
    static constexpr double derated_to_zero = 0.9;

    double continuous_torque_Nm_;
    double warming_s_;
    double rise_1_ = 0.0;
    double rise_2_ = 0.0;
};

}  // namespace touchline
