// Converts between what the board counts by port and the joints' angles and torques. The board is
// set up as the maker's programs do it; how a unit differs from that is corrected here.
// Threads: immutable values and pure functions. No allocation. O(1).
#pragma once

#include "config/types/calibration.h"
#include "config/types/vec2.h"
#include "haptics/device/board/hapi.h"
#include "haptics/pantograph/profile.h"

#include <optional>

namespace touchline {

/// The profile with the unit's own torque limit and encoder counts.
[[nodiscard]] DeviceProfile calibrated(const DeviceProfile& profile,
                                       const Calibration& calibration);

class BoardFrame {
  public:
    BoardFrame(const DeviceProfile& profile, const Calibration& calibration);

    /// Returns the set-up for a handle at home: the board then reports the angles of the profile's
    /// home pose.
    [[nodiscard]] BoardSetUp set_up_at_home() const;

    /// Returns the set-up that continues at a reading: the board then reports the same again, to
    /// the count.
    [[nodiscard]] BoardSetUp set_up_at(PortAngles raw, double handle_deg = 0.0) const;

    /// What the board reports at home: whole counts, rounded toward zero.
    [[nodiscard]] PortAngles home_reading() const;

    /// home + offset + scale (raw - home reading), each joint from the port of its encoder.
    [[nodiscard]] JointAngles joint_angles(PortAngles raw) const;

    /// What the board reports at these angles, but for the rounding to whole counts.
    [[nodiscard]] PortAngles reading_at(JointAngles angles) const;

    /// Returns whether each angle is a whole number of counts, as all are that a board sends.
    [[nodiscard]] bool is_whole_counts(PortAngles raw, double handle_deg = 0.0) const;

    /// For a unit not known yet: the board counts every count that it is told, while others of its
    /// kind count half. Every whole count of theirs is one of these too.
    [[nodiscard]] BoardFrame with_all_counts() const;

    /// The port of the motor of joint 1 or 2.
    [[nodiscard]] int motor_port(int joint) const;

    [[nodiscard]] bool has_handle() const { return profile_.handle.has_value(); }

    /// The torque to write for the handle: within its limit, zero if it is not finite. Nothing if
    /// the handle does not turn.
    [[nodiscard]] std::optional<double> handle_torque_Nm(double torque_Nm) const;

    /// The turn of one count, degrees.
    [[nodiscard]] PortAngles quantum() const { return quantum_; }

    /// Scales both torques together to the unit's limit, which keeps the direction. Zero if one is
    /// not finite.
    [[nodiscard]] PortTorques port_torques(JointTorques torques) const;

    [[nodiscard]] const Calibration& calibration() const { return calibration_; }

    /// The profile as given, without the calibration.
    [[nodiscard]] const DeviceProfile& profile() const { return profile_; }

    [[nodiscard]] const DeviceProfile& calibrated_profile() const { return unit_; }

  private:
    DeviceProfile profile_;
    Calibration calibration_;
    DeviceProfile unit_;
    bool is_joint_1_on_port_2_;
    PortAngles quantum_;
};

}  // namespace touchline
