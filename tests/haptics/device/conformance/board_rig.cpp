// The USB board: its driver on the emulated board.
#include "tests/machines/sim/board/board_rig.h"

#include "tests/haptics/device/conformance/rigs.h"

#include <utility>

namespace touchline {
namespace {

class UsbBoardRig final : public DeviceRig {
  public:
    UsbBoardRig() : hand_(hand_at_home()), rig_(BoardTruth{}, {}, {}, hand_) {}

    ForceDevice& device() override { return *rig_.driver; }

    [[nodiscard]] const DeviceProfile& profile() const override {
        return rig_.board.truth().profile;
    }

    /// What homing would find: where the handle is when the board is set up.
    bool open() override {
        if (is_opened_) rig_.connect();
        is_opened_ = true;
        if (!rig_.driver->open()) return false;
        Calibration calibration;
        calibration.offset = rig_.board.true_angles() - profile().home;
        rig_.driver->set_calibration(calibration);
        return true;
    }

    [[nodiscard]] double now_s() const override { return rig_.time.now_s; }

    void pass(double span_s) override {
        rig_.time.now_s += span_s;
        rig_.board.advance_to(rig_.time.now_s);
    }

    void move_hand(Position p_D) override { hand_->move_to(picture_from_device(profile(), p_D)); }

    void cut() override { rig_.board.unplug(); }

    void fall_silent() override { rig_.link->slow(for_ever_s, for_ever_s); }

    void join() override { rig_.board.plug(); }

    void garble_next(unsigned seed) override {
        rig_.link->spoil_next({0, LinkFault::garbled_reply, 0.0, seed});
    }

    void slow_answers(double late_s, int ticks) override {
        rig_.link->slow(late_s, ticks * rig_tick_s);
    }

    [[nodiscard]] Position true_p_D() const override {
        return device_from_picture(profile(), rig_.board.plant().tip().position);
    }

    [[nodiscard]] Force true_force_D() const override {
        const auto pose = forward(profile().geometry, rig_.board.true_angles());
        return tip_force(pose.value().jacobian, rig_.board.plant().torques()).value();
    }

    [[nodiscard]] bool holds_zero() const override {
        return rig_.board.plant().torques() == JointTorques{};
    }

  private:
    static constexpr double for_ever_s = 1e6;

    static std::shared_ptr<MouseHand> hand_at_home() {
        const DeviceProfile& profile = default_profile();
        const Position home = forward(profile.geometry, profile.home).value().p_DH;
        return std::make_shared<MouseHand>(picture_from_device(profile, home));
    }

    std::shared_ptr<MouseHand> hand_;
    BoardRig rig_;
    bool is_opened_ = false;
};

}  // namespace

std::unique_ptr<DeviceRig> board_rig() {
    return std::make_unique<UsbBoardRig>();
}

}  // namespace touchline
