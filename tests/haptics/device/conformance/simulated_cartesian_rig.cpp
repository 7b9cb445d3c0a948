// The device in software that tells places and takes forces.
#include "haptics/device/simulated/simulated_cartesian.h"
#include "tests/haptics/device/conformance/rigs.h"
#include "tests/haptics/device/conformance/simulated_rig.h"

namespace touchline {
namespace {

class SimulatedCartesianRig final : public DeviceRig {
  public:
    ForceDevice& device() override { return line_; }

    [[nodiscard]] const DeviceProfile& profile() const override {
        return cartesian_profiles().front();
    }

    bool open() override { return true; }

    [[nodiscard]] double now_s() const override { return now_s_; }

    void pass(double span_s) override { now_s_ += span_s; }

    void move_hand(Position p_D) override { hand_->move_to(picture_from_device(profile(), p_D)); }

    void cut() override { line_.is_cut = true; }

    void join() override { line_.is_cut = false; }

    /// There are no bits to spoil.
    void garble_next(unsigned /*seed*/) override {}

    [[nodiscard]] Position true_p_D() const override {
        return device_from_picture(profile(), device_.tip().position);
    }

    [[nodiscard]] Force true_force_D() const override { return device_.acting().in_plane_D; }

    [[nodiscard]] bool holds_zero() const override {
        return device_.acting().in_plane_D == Force{} && device_.acting().across_N == 0.0;
    }

  private:
    std::shared_ptr<MouseHand> hand_ = std::make_shared<MouseHand>(Position{});
    SimulatedCartesian device_{cartesian_profiles().front(), CartesianOptions{}, hand_};
    CutLine line_{device_};
    double now_s_ = 0.0;
};

}  // namespace

std::unique_ptr<DeviceRig> simulated_cartesian_rig() {
    return std::make_unique<SimulatedCartesianRig>();
}

}  // namespace touchline
