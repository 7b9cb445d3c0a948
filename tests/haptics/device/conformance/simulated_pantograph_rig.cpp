// The pantograph in software.
#include "haptics/pantograph/kinematics.h"
#include "tests/haptics/device/conformance/rigs.h"
#include "tests/haptics/device/conformance/simulated_rig.h"

namespace touchline {
namespace {

class SimulatedPantographRig final : public DeviceRig {
  public:
    ForceDevice& device() override { return line_; }

    [[nodiscard]] const DeviceProfile& profile() const override { return default_profile(); }

    bool open() override { return true; }

    [[nodiscard]] double now_s() const override { return now_s_; }

    void pass(double span_s) override { now_s_ += span_s; }

    void move_hand(Position p_D) override { hand_->move_to(picture_from_device(profile(), p_D)); }

    void cut() override { line_.is_cut = true; }

    void join() override { line_.is_cut = false; }

    /// There are no bits: an answer that is lost.
    void garble_next(unsigned /*seed*/) override {}

    [[nodiscard]] Position true_p_D() const override {
        return device_from_picture(profile(), device_.tip().position);
    }

    [[nodiscard]] Force true_force_D() const override {
        const auto angles = inverse(profile().geometry, true_p_D());
        const auto pose = forward(profile().geometry, angles.value());
        return tip_force(pose.value().jacobian, device_.acting_torques()).value();
    }

    [[nodiscard]] bool holds_zero() const override {
        return device_.acting_torques() == JointTorques{};
    }

  private:
    std::shared_ptr<MouseHand> hand_ = std::make_shared<MouseHand>(Position{});
    SimulatedPantograph device_{default_profile(), SimulationOptions{}, hand_};
    CutLine line_{device_};
    double now_s_ = 0.0;
};

}  // namespace

std::unique_ptr<DeviceRig> simulated_pantograph_rig() {
    return std::make_unique<SimulatedPantographRig>();
}

}  // namespace touchline
