// The one interface to a force-feedback pantograph, real or simulated.
#pragma once

#include "config/types/pinned.h"
#include "config/types/vec2.h"

#include <optional>

namespace touchline {

/// Threads: one at a time, the servo's while it runs. No call allocates, locks or logs. Every call
/// gives up rather than wait longer than a servo period.
class ForceDevice : public Interface {
  public:
    /// Returns the joint angles in D, read at now_s (servo time, never going back), at most 4.5 ms
    /// old. Returns nothing if the device does not answer.
    [[nodiscard]] virtual std::optional<JointAngles> read_angles(double now_s) = 0;

    /// How far the handle has turned, counter-clockwise, since the device was set up; as old as the
    /// joint angles last read. Nothing if the handle does not turn or those angles were missing.
    [[nodiscard]] virtual std::optional<double> handle_angle_rad() const { return std::nullopt; }

    /// Sets the torque on the hand, counter-clockwise, which goes with the next torques. Does
    /// nothing if the handle does not turn.
    virtual void turn_handle(double /*torque_Nm*/) {}

    /// Sets torques that act until the next call. For zero, returns true once the device is known
    /// to hold zero, which with a real one is a call or more later. For other torques, returns
    /// false if the device did not take them.
    [[nodiscard]] virtual bool write_torques(JointTorques torques) = 0;
};

}  // namespace touchline
