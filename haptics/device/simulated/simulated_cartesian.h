// A device with three axes in software, which tells places and takes forces, and a hand that holds
// it: on the clock that the servo passes in, the same calls give the same bits. It knows no links:
// the handle is a mass with friction that reaches everywhere, held to the drawing plane by the
// spring of haptics/device/plane_spring.h.
#pragma once

#include "config/types/vec2.h"
#include "haptics/device/force_device.h"
#include "haptics/device/plane_spring.h"
#include "haptics/device/simulated/delayed.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/pantograph/profile.h"

#include <memory>
#include <optional>

namespace touchline {

struct CartesianOptions {
    HandModel hand = normal_hand;
    double substep_s = 1.25e-4;  // longest integration step, > 0
};

/// Threads: as ForceDevice; another thread may lead the paths if they allow it.
class SimulatedCartesian final : public ForceDevice {
  public:
    /// `profile` is a Cartesian one. The handle starts at rest where the paths start. `across`: how
    /// far the hand means to be from the plane, as x; null: on it.
    SimulatedCartesian(const DeviceProfile& profile, const CartesianOptions& options,
                       std::shared_ptr<const IntendedPath> path,
                       std::shared_ptr<const IntendedPath> across = nullptr);

    /// Advances the simulation to now_s (at most 0.1 s per call: a longer gap is a pause). Tells
    /// the place in whole steps, and the velocity.
    [[nodiscard]] std::optional<DeviceReading> read(double now_s) override;

    /// Takes effect after the profile's delay; what is not finite is zero. Scales a force above the
    /// profile's limit down.
    [[nodiscard]] bool write(const DeviceCommand& command) override;

    /// The true state of the handle in W, for tests and drawings.
    [[nodiscard]] const MassState& tip() const { return plane_.tip(); }

    /// How far it is from the plane, m.
    [[nodiscard]] double off_m() const { return across_.tip().position.x; }

    /// What acts now.
    [[nodiscard]] const PlaneForce& acting() const { return acting_; }

  private:
    void advance_to(double t_s);
    void advance(double span_s);

    DeviceProfile profile_;
    CartesianOptions options_;
    std::shared_ptr<const IntendedPath> path_;
    std::shared_ptr<const IntendedPath> across_path_;
    TipDynamics plane_;
    TipDynamics across_;  // along x: the distance from the plane
    DeviceCommand told_;  // acts now
    Delayed<DeviceCommand> pending_;
    PlaneForce acting_;
    double time_s_ = 0.0;
};

}  // namespace touchline
