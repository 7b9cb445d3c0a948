// The device in software that tells places and takes forces.
#include "haptics/device/simulated/simulated_cartesian.h"
#include "tests/haptics/device/conformance/rigs.h"
#include "tests/haptics/device/conformance/simulated_rig.h"

namespace touchline {
namespace {

class SimulatedCartesianRig final : public SimulatedRig<SimulatedCartesian, CartesianOptions> {
  public:
    using SimulatedRig::SimulatedRig;

    [[nodiscard]] Force true_force_D() const override { return simulated().acting().in_plane_D; }

    [[nodiscard]] bool holds_zero() const override {
        return simulated().acting().in_plane_D == Force{} && simulated().acting().across_N == 0.0;
    }
};

}  // namespace

std::unique_ptr<DeviceRig> simulated_cartesian_rig() {
    return std::make_unique<SimulatedCartesianRig>(cartesian_profiles().front());
}

}  // namespace touchline
