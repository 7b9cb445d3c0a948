// A pantograph and a hand in software, on the clock that the servo passes in: the same calls give
// the same bits. Models five-bar geometry, tip mass, viscous and Coulomb friction, encoder counts,
// motor limits, transport delay, a scale error of one arm and, if the profile has one, a turning
// handle.
#pragma once

#include "haptics/device/force_device.h"
#include "haptics/device/hand.h"
#include "haptics/device/pantograph_plant.h"
#include "haptics/pantograph/profile.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

namespace touchline {

struct SimulationOptions {
    HandModel hand = normal_hand;
    double substep_s = 1.25e-4;      // longest integration step, > 0
    double arm_1_scale_error = 0.0;  // relative error of encoder 1, e.g. 0.015
};

/// Threads: as ForceDevice; another thread may lead the path if the path allows it.
class SimulatedPantograph final : public ForceDevice {
  public:
    /// The tip starts at rest where the path starts, or at the centre of the drawing area if that
    /// is out of reach.
    SimulatedPantograph(const DeviceProfile& profile, const SimulationOptions& options,
                        std::shared_ptr<const IntendedPath> path);

    /// Advances the simulation to now_s (at most 0.1 s per call: a longer gap is a pause), then
    /// reads the encoders.
    [[nodiscard]] std::optional<JointAngles> read_angles(double now_s) override;

    /// Clamps each motor's torque as the firmware does; a torque that is not finite counts as zero.
    /// Takes effect after the profile's delay.
    [[nodiscard]] bool write_torques(JointTorques torques) override;

    [[nodiscard]] std::optional<double> handle_angle_rad() const override;

    void turn_handle(double torque_Nm) override;

    /// The true state of the tip in W, for tests and drawings.
    [[nodiscard]] const MassState& tip() const { return plant_.tip(); }

    /// The torques that act now.
    [[nodiscard]] JointTorques acting_torques() const { return plant_.torques(); }

    [[nodiscard]] double acting_handle_torque_Nm() const { return plant_.handle_torque_Nm(); }

  private:
    struct TimedTorques {
        double from_s = 0.0;
        JointTorques torques;
        double handle_Nm = 0.0;
    };

    void advance_to(double t_s);

    DeviceProfile profile_;
    double arm_1_scale_error_;
    PantographPlant plant_;
    double handle_Nm_ = 0.0;                  // goes with the next torques
    std::array<TimedTorques, 64> pending_{};  // by time; first_pending_ is the oldest
    std::size_t first_pending_ = 0;
    std::size_t pending_count_ = 0;
};

}  // namespace touchline
