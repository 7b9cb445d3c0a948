// A device with motors and encoders at the two joints of a five-bar: angles in, torques out. Does
// the kinematics for the servo, so that a driver knows of ports, counts and bytes alone.
#pragma once

#include "config/types/vec2.h"
#include "haptics/device/force_device.h"
#include "haptics/pantograph/kinematics.h"

#include <optional>

namespace touchline {

/// Returns what a five-bar tells whose joints are at `angles`: no place if its links cannot be so.
[[nodiscard]] DeviceReading reading_of(const Geometry& geometry, JointAngles angles);

/// Threads: as ForceDevice.
class JointDevice : public ForceDevice {
  public:
    [[nodiscard]] std::optional<DeviceReading> read(double now_s) final;

    /// Takes the torques and leaves the force.
    [[nodiscard]] bool write(const DeviceCommand& command) final;

    /// Returns the joint angles in D, as read() does.
    [[nodiscard]] virtual std::optional<JointAngles> read_angles(double now_s) = 0;

    /// How new the joint angles last read are.
    [[nodiscard]] virtual Freshness freshness() const { return {}; }

    /// How far the handle has turned, counter-clockwise, since the device was set up; as old as the
    /// joint angles last read. Nothing if the handle does not turn or those angles were missing.
    [[nodiscard]] virtual std::optional<double> handle_angle_rad() const { return std::nullopt; }

    /// Sets the torque on the hand, counter-clockwise, which goes with the next torques. Does
    /// nothing if the handle does not turn.
    virtual void turn_handle(double /*torque_Nm*/) {}

    /// Sets torques that act until the next call. Returns as write() does.
    [[nodiscard]] virtual bool write_torques(JointTorques torques) = 0;

  protected:
    explicit JointDevice(const Geometry& geometry) : geometry_(geometry) {}

  private:
    Geometry geometry_;
};

}  // namespace touchline
