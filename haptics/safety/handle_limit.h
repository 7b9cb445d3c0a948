// Limits the torque of a motor at the handle: its size, its heat and its rise, and it never drives
// on a fast turn. haptics/safety/force_chain.h decides whether the motor may act at all.
// Threads: a plain value.
#pragma once

#include "haptics/safety/motor_heat.h"

#include <algorithm>
#include <cmath>

namespace touchline {

struct HandleLimits {
    double torque_Nm = 0.0;  // 0: there is no motor, and never a torque
    double continuous_torque_Nm = 0.06;
    double warming_s = 60.0;
    double rise_Nm_per_s = 3.0;     // growth of |torque|: that of the force, at 10 mm
    double change_Nm_per_s = 15.0;  // the same of its change
    double fast_rad_per_s = 12.0;   // two turns a second: from here on it only brakes
    double arm_torque_Nm = 1e-3;    // armed: the wanted torque is small below this
};

class HandleLimit {
  public:
    explicit HandleLimit(const HandleLimits& limits)
        : limits_(limits), heat_(limits.continuous_torque_Nm, limits.warming_s) {}

    /// Advances one tick of dt_s > 0 with finite numbers. Lets through `gain` of the wanted torque
    /// and `share` of the limit, both 0 ... 1. Returns the torque to tell the motor.
    [[nodiscard]] double step(double wanted_Nm, double turn_rad_per_s, double gain, double share,
                              double dt_s) {
        const double most_Nm = share * limits_.torque_Nm;
        const double cool_Nm = heat_.allowed() * gain * wanted_Nm;
        const double target_Nm =
            std::clamp(without_drive(cool_Nm, turn_rad_per_s), -most_Nm, most_Nm);
        const double before_Nm = without_drive(told_Nm_, turn_rad_per_s);
        const double change_Nm = limits_.change_Nm_per_s * dt_s;
        const double size_Nm = std::abs(before_Nm) + limits_.rise_Nm_per_s * dt_s;
        const double slewed_Nm =
            std::clamp(target_Nm, before_Nm - change_Nm, before_Nm + change_Nm);
        told_Nm_ = std::clamp(slewed_Nm, -size_Nm, size_Nm);
        heat_.step({told_Nm_, 0.0}, dt_s);
        return told_Nm_;
    }

    /// Sets the torque to zero at once.
    void stop() { told_Nm_ = 0.0; }

    [[nodiscard]] double told_Nm() const { return told_Nm_; }

    /// True for a wanted torque that would push nobody.
    [[nodiscard]] bool is_quiet(double wanted_Nm) const {
        return limits_.torque_Nm == 0.0 || std::abs(wanted_Nm) < limits_.arm_torque_Nm;
    }

  private:
    [[nodiscard]] double without_drive(double torque_Nm, double turn_rad_per_s) const {
        const bool drives =
            std::abs(turn_rad_per_s) > limits_.fast_rad_per_s && torque_Nm * turn_rad_per_s > 0.0;
        return drives ? 0.0 : torque_Nm;
    }

    HandleLimits limits_;
    MotorHeat heat_;
    double told_Nm_ = 0.0;
};

}  // namespace touchline
