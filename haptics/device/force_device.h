// The one interface to a force-feedback pantograph, real or simulated.
#pragma once

#include "config/types/vec2.h"

#include <optional>

namespace touchline {

/// Threads: one at a time, the servo's while it runs. No call allocates, locks or logs. All
/// give up rather than wait longer than a servo period.
class ForceDevice {
  public:
    virtual ~ForceDevice() = default;

    /// Joint angles in D, read at now_s (servo time, never going back). At most 4.5 ms
    /// old. Nothing when the device does not answer.
    [[nodiscard]] virtual std::optional<JointAngles> read_angles(double now_s) = 0;

    /// How far the handle is turned, counter-clockwise, since the device was set up: as old as the
    /// joint angles last read. Nothing where it does not turn, or where there were none.
    [[nodiscard]] virtual std::optional<double> handle_angle_rad() const { return std::nullopt; }

    /// On the hand, counter-clockwise: goes with the next torques. Nothing where it does not turn.
    virtual void turn_handle(double /*torque_Nm*/) {}

    /// Torques that act from now on until the next call. Zero: true when the device is known to
    /// hold zero, which with a real one is a call or more later. Other torques: false when the
    /// device did not take them.
    [[nodiscard]] virtual bool write_torques(JointTorques torques) = 0;

  protected:
    ForceDevice() = default;
    ForceDevice(const ForceDevice&) = default;
    ForceDevice(ForceDevice&&) = default;
    ForceDevice& operator=(const ForceDevice&) = default;
    ForceDevice& operator=(ForceDevice&&) = default;
};

}  // namespace touchline
