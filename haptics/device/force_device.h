// The one interface to a force-feedback device, real or simulated, whatever its arms are: where the
// handle is comes in, a force goes out. A device with motors at the two joints of a five-bar is a
// JointDevice (haptics/device/joint_device.h). One that knows its own arms tells places and takes
// forces.
#pragma once

#include "config/types/pinned.h"
#include "config/types/vec2.h"
#include "haptics/pantograph/kinematics.h"

#include <optional>

namespace touchline {

/// The handle of a device with a third axis, along the normal of the drawing plane.
struct OffPlane {
    double off_m = 0.0;     // from the plane
    double m_per_s = 0.0;   // along the normal
    double on_plane = 1.0;  // 0 ... 1, of the force in the plane that the device makes there
    double across_N = 0.0;  // what it makes along the normal
};

/// How new a place is.
struct Freshness {
    bool is_new = true;   // false: this place was told before
    double late_s = 0.0;  // later than one that comes at once, at most: it may be older by so much
};

/// What a device tells of its handle, in D. A number that is not finite is a fault of the device.
struct DeviceReading {
    std::optional<Position> p_D;         // nothing: the links cannot be as the joints say
    std::optional<Jacobian> jacobian;    // of a joint device at p_D; nothing: it takes forces
    std::optional<Velocity> velocity_D;  // where the device measures it itself
    std::optional<OffPlane> off_plane;   // of a device with a third axis
    std::optional<double> handle_rad;    // counter-clockwise, since set-up; if the handle turns
    JointAngles joints;                  // of a joint device: for the servo that takes over
    Freshness freshness;
};

/// What a device is told. Of force and torques one is the device's own, by its kind; the other is
/// zero.
struct DeviceCommand {
    Force force_D;           // on the hand
    JointTorques torques;    // of the motors at the joints
    double handle_Nm = 0.0;  // on the hand, counter-clockwise; for a handle that turns
    // 0 ... 1, of the force that may hold the handle of a device with a third axis to the plane
    // (haptics/device/plane_spring.h).
    double plane_share = 0.0;

    friend bool operator==(const DeviceCommand&, const DeviceCommand&) = default;
};

/// Threads: one at a time, the servo's while it runs. No call allocates, locks or logs. Every call
/// gives up rather than wait longer than a servo period.
class ForceDevice : public Interface {
  public:
    /// Returns what the device tells at now_s (servo time, never going back), at most 4.5 ms old.
    /// Returns nothing if the device does not answer.
    [[nodiscard]] virtual std::optional<DeviceReading> read(double now_s) = 0;

    /// Sets a command that acts until the next call. For zero, returns true once the device is
    /// known to hold zero, which with a real one is a call or more later. For others, returns false
    /// if the device did not take it. What is not finite counts as zero.
    [[nodiscard]] virtual bool write(const DeviceCommand& command) = 0;
};

}  // namespace touchline
