// The guards of the force, each a plain value that one tick advances: the energy given to the hand,
// its speed, positions that cannot be, the heat of the motors, and the torque of a motor at the
// handle. haptics/safety/force_chain.h decides what acts. Threads: pure functions and plain values.
#pragma once

#include "config/types/vec2.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace touchline {

/// Measures the energy that the device gave the hand in the last second, and damps or faults if it
/// is too much. Sums the plain work of the told force, whatever a spring claims to have stored: a
/// wall holds only a few mJ. Forgotten in 1 s; energy that the hand gave is no credit.
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

// Force never drives on a hand that is already fast, and a hand faster than hands can be is a
// fault.
inline constexpr double braked_m_per_s = 1.0;      // from here on force only brakes
inline constexpr double too_fast_m_per_s = 1.5;    // a fault ...
inline constexpr double slow_again_m_per_s = 0.2;  // ... until it was slower than this ...
inline constexpr double slow_again_s = 1.0;        // ... for so long

/// True if force must not drive a hand of this speed on. NaN counts as fast.
[[nodiscard]] inline bool is_braked(double speed_m_per_s) {
    return !(speed_m_per_s <= braked_m_per_s);
}

/// Takes away the part of the force that drives the motion on; parts across the motion and against
/// it stay.
[[nodiscard]] inline Force without_drive(Force force, Velocity velocity) {
    constexpr double nothing_N = 1e-9;  // squares of much less are lost
    constexpr double rest_m_per_s = 1e-9;
    if (!(norm(force) > nothing_N)) return {};
    if (norm(velocity) <= rest_m_per_s) return force;  // fast along a third axis alone
    // Brakes by a trace more than nothing, so that no rounding or scaling makes it drive.
    const double trace = 1e-12 * norm(force) * norm(velocity);
    const double drive = dot(force, velocity) + trace;
    if (!(drive > 0.0)) return force;
    return force - along<Force>(velocity, drive / dot(velocity, velocity));
}

class SpeedWatch {
  public:
    /// Advances one tick of dt_s > 0. Returns true while the hand is, or lately was, too fast.
    bool step(double speed_m_per_s, double dt_s) {
        slow_s_ = speed_m_per_s < slow_again_m_per_s ? slow_s_ + dt_s : 0.0;
        if (!(speed_m_per_s <= too_fast_m_per_s)) is_too_fast_ = true;
        if (slow_s_ >= slow_again_s) is_too_fast_ = false;
        return is_too_fast_;
    }

  private:
    bool is_too_fast_ = false;
    double slow_s_ = 0.0;
};

/// good: use it. held: use the last good one. jumped: the position stays where it jumped to; use
/// it, but without force.
enum class Sample : std::uint8_t { good, held, jumped };

/// A handle cannot jump, so a position too far from the last one is the encoder's error, not the
/// hand's motion.
class PositionGuard {
  public:
    /// `count_m` > 0: the tip's motion for one encoder count.
    explicit PositionGuard(double count_m) : count_m_(count_m) {}

    /// Judges a position measured dt_s > 0 after the tick before. The first one is good.
    Sample step(Position measured, double dt_s) {
        since_good_s_ += dt_s;
        const double possible_m = fastest_m_per_s * since_good_s_ + 2.0 * count_m_;
        if (!has_good_ || norm(measured - good_) <= possible_m) return take(measured, Sample::good);
        if (++held_ <= most_held) return Sample::held;
        return take(measured, Sample::jumped);
    }

    /// Advances a tick without a position.
    void miss(double dt_s) { since_good_s_ += dt_s; }

  private:
    static constexpr double fastest_m_per_s = 1.5;
    static constexpr int most_held = 3;  // ticks

    Sample take(Position measured, Sample sample) {
        good_ = measured;
        has_good_ = true;
        since_good_s_ = 0.0;
        held_ = 0;
        return sample;
    }

    double count_m_;
    Position good_;
    bool has_good_ = false;
    double since_good_s_ = 0.0;
    int held_ = 0;  // ticks in a row
};

/// Estimates how warm the motors are from the torques told, or the force where nobody knows the
/// torques, and how much force that leaves. A first-order model. A rise of 1 is the rated one,
/// which the continuous load reaches in the end. Heat goes with the square of the current, and so
/// of the load.
class MotorHeat {
  public:
    /// Both > 0: the torque that a motor bears forever (or the force that all bear together), and
    /// the time constant of its warming.
    MotorHeat(double continuous, double warming_s)
        : continuous_(continuous), warming_s_(warming_s) {}

    /// Advances one tick of dt_s > 0 with finite torques.
    void step(JointTorques torques, double dt_s) {
        load(rise_1_, torques.x, dt_s);
        load(rise_2_, torques.y, dt_s);
    }

    /// Advances one tick of dt_s > 0 with a finite force, of which any motor may bear all.
    void bear(Force force, double dt_s) {
        load(rise_1_, norm(force), dt_s);
        rise_2_ = rise_1_;
    }

    /// Both motors are at least as warm as this: rise >= 0.
    void warm(double rise) {
        rise_1_ = std::max(rise_1_, rise);
        rise_2_ = std::max(rise_2_, rise);
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

    void load(double& rise, double told, double dt_s) const {
        const double load = told / continuous_;
        rise += std::min(1.0, dt_s / warming_s_) * (load * load - rise);
    }

    double continuous_;
    double warming_s_;
    double rise_1_ = 0.0;
    double rise_2_ = 0.0;
};

struct HandleLimits {
    double torque_Nm = 0.0;  // 0: there is no motor, and never a torque
    double continuous_torque_Nm = 0.06;
    double warming_s = 60.0;
    double rise_Nm_per_s = 3.0;     // growth of |torque|: that of the force, at 10 mm
    double change_Nm_per_s = 15.0;  // the same of its change
    double fast_rad_per_s = 12.0;   // two turns a second: from here on it only brakes
    double arm_torque_Nm = 1e-3;    // armed: the wanted torque is small below this
};

/// Limits the torque of a motor at the handle: its size, its heat and its rise, and it never drives
/// on a fast turn. haptics/safety/force_chain.h decides whether the motor may act at all.
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
