// The pantograph in software.
#include "haptics/pantograph/kinematics.h"
#include "tests/haptics/device/conformance/rigs.h"
#include "tests/haptics/device/conformance/simulated_rig.h"

namespace touchline {
namespace {

class SimulatedPantographRig final : public SimulatedRig<SimulatedPantograph, SimulationOptions> {
  public:
    using SimulatedRig::SimulatedRig;

    [[nodiscard]] Force true_force_D() const override {
        const auto angles = inverse(profile().geometry, true_p_D());
        const auto pose = forward(profile().geometry, angles.value());
        return tip_force(pose.value().jacobian, simulated().acting_torques()).value();
    }

    [[nodiscard]] bool holds_zero() const override {
        return simulated().acting_torques() == JointTorques{};
    }
};

}  // namespace

std::unique_ptr<DeviceRig> simulated_pantograph_rig() {
    return std::make_unique<SimulatedPantographRig>(default_profile());
}

}  // namespace touchline
