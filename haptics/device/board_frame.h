// Between what the board counts by port and the angles and torques of the joints. The board is set
// up as the maker's programs do it; what is otherwise in a unit is put right here.
// Threads: immutable values and pure functions. No allocation. O(1).
#pragma once

#include "config/types/calibration.h"
#include "config/types/vec2.h"
#include "haptics/device/hapi.h"
#include "haptics/pantograph/profile.h"

#include <optional>

namespace touchline {

/// The profile with the unit's own limit of torque and its own counts.
[[nodiscard]] DeviceProfile calibrated(const DeviceProfile& profile,
                                       const Calibration& calibration);

class BoardFrame {
  public:
    BoardFrame(const DeviceProfile& profile, const Calibration& calibration);

    /// The handle is at home: the board is to say the angles of the profile's home pose.
    [[nodiscard]] BoardSetUp set_up_at_home() const;

    /// Sets the board up again where it was: it says the same again to the count.
    [[nodiscard]] BoardSetUp set_up_at(PortAngles raw, double handle_deg = 0.0) const;

    /// What the board says at home: whole counts, rounded toward zero.
    [[nodiscard]] PortAngles home_reading() const;

    /// By home + offset + scale (raw - home reading), each joint from where its encoder is.
    [[nodiscard]] JointAngles joint_angles(PortAngles raw) const;

    /// Each angle is a whole number of counts, as all are that a board sends.
    [[nodiscard]] bool is_whole_counts(PortAngles raw, double handle_deg = 0.0) const;

    /// For a unit of which it is not known yet: the board counts all that it is told, where others
    /// of its kind count half. Every whole count of theirs is one of these too.
    [[nodiscard]] BoardFrame with_all_counts() const;

    /// Where the motor of joint 1 or 2 is plugged in.
    [[nodiscard]] int motor_port(int joint) const;

    [[nodiscard]] bool has_handle() const { return profile_.handle.has_value(); }

    /// What to write for a torque of the handle: within its limit, zero where it is not finite.
    /// Nothing where the handle does not turn.
    [[nodiscard]] std::optional<double> handle_torque_Nm(double torque_Nm) const;

    /// Turn of one count, degrees.
    [[nodiscard]] PortAngles quantum() const { return quantum_; }

    /// Both scaled together to the unit's limit, so that the direction stays; not finite: zero.
    [[nodiscard]] PortTorques port_torques(JointTorques torques) const;

    [[nodiscard]] const Calibration& calibration() const { return calibration_; }

    /// As it was given, without the calibration.
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
