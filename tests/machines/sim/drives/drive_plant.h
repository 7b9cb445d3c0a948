// A pantograph with a motor controller at each joint: the mechanics and a hand behind any emulated
// pair of controllers, on the time that the caller passes in. Threads: one at a time.
#pragma once

#include "haptics/device/drives/joint_drives.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/pantograph/profile.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace touchline {

/// The true state, whatever the host believes.
struct DriveTruth {
    DeviceProfile profile = open_five_bar();
    JointDrives drives;
    HandModel hand = normal_hand;
    bool have_motors_power = true;  // the bridges': the controllers live on
};

/// What a motor's bridge does. off: the shaft turns freely. driven: it has the torque that it was
/// told. damped: it resists turning.
enum class Bridge : std::uint8_t { off, driven, damped };

/// What both motors do, from a moment on; the torque is that of the shaft.
struct BridgeChange {
    double at_s = 0.0;
    ShaftTorques torques;
    std::array<Bridge, 2> bridges{};
};

class DrivePlant {
  public:
    DrivePlant(const DriveTruth& truth, std::shared_ptr<const IntendedPath> path);

    /// Sets what a motor does from now on. `motor`: 0 or 1.
    void drive(std::size_t motor, Bridge bridge, double torque_Nm);

    /// Runs through span_s > 0.
    void advance(double span_s);

    [[nodiscard]] double now_s() const { return plant_.time_s(); }

    /// What an encoder of 14 bits at a shaft shows, in whole turns since it was at its own zero.
    [[nodiscard]] double shaft_turns(std::size_t motor) const;

    [[nodiscard]] JointAngles angles() const { return plant_.angles().value_or(angles_); }

    /// Another hand takes the handle where it is; with no_hand, nobody holds it.
    void grip(const HandModel& hand) { plant_.grip(hand); }

    void switch_motors(bool have_power) { truth_.have_motors_power = have_power; }

    /// Makes an encoder leap.
    void leap(std::size_t motor, double turns) { leaps_[motor] += turns; }

    [[nodiscard]] const std::vector<BridgeChange>& changes() const { return changes_; }

    [[nodiscard]] const DriveTruth& truth() const { return truth_; }

  private:
    void note();

    DriveTruth truth_;
    DriveFrame frame_;
    PantographPlant plant_;
    JointAngles angles_;
    JointAngles speeds_per_s_;
    std::array<Bridge, 2> bridges_{};
    std::array<double, 2> torques_Nm_{};
    std::array<double, 2> leaps_{};
    std::vector<BridgeChange> changes_;
};

}  // namespace touchline
