// Motors with controllers of their own: the driver on each emulated pair.
#include "tests/haptics/device/conformance/rigs.h"
#include "tests/machines/sim/drives/drive_rig.h"

namespace touchline {
namespace {

template <class Machine>
class MotorsRig final : public DeviceRig {
  public:
    ForceDevice& device() override { return *rig_.driver; }

    [[nodiscard]] const DeviceProfile& profile() const override { return truth().profile; }

    bool open() override {
        if (is_opened_) rig_.connect(truth().drives);
        is_opened_ = true;
        return rig_.driver->open().has_value();
    }

    [[nodiscard]] double now_s() const override { return rig_.time.now_s; }

    void pass(double span_s) override { rig_.pass(span_s); }

    void move_hand(Position p_D) override { hand_->move_to(picture_from_device(profile(), p_D)); }

    void cut() override { rig_.line->spoil(LineFault::unplugged); }

    void fall_silent() override { rig_.line->spoil(LineFault::lost_reply, for_ever_s); }

    /// The next open() makes a line anew.
    void join() override {}

    void garble_next(unsigned seed) override {
        rig_.line->spoil(LineFault::garbled_reply, 0.0, seed);
    }

    void slow_answers(double late_s, int ticks) override {
        rig_.line->slow(late_s, ticks * drive_tick_s);
    }

    [[nodiscard]] Position true_p_D() const override {
        return forward(profile().geometry, rig_.plant().angles()).value().p_DH;
    }

    [[nodiscard]] Force true_force_D() const override {
        const auto pose = forward(profile().geometry, rig_.plant().angles());
        const DriveFrame frame(profile(), truth().drives);
        const auto torques = frame.joint_torques(rig_.plant().changes().back().torques);
        return tip_force(pose.value().jacobian, torques).value();
    }

    [[nodiscard]] bool holds_zero() const override {
        return rig_.plant().changes().back().torques == ShaftTorques{};
    }

  private:
    static constexpr double for_ever_s = 1e6;

    [[nodiscard]] const DriveTruth& truth() const { return rig_.plant().truth(); }

    std::shared_ptr<MouseHand> hand_ = std::make_shared<MouseHand>(Position{});
    DriveRig<Machine> rig_{DriveTruth{}, Machine::units(), hand_};
    bool is_opened_ = false;
};

}  // namespace

std::unique_ptr<DeviceRig> moteus_rig() {
    return std::make_unique<MotorsRig<MoteusMachine>>();
}

std::unique_ptr<DeviceRig> odrive_rig() {
    return std::make_unique<MotorsRig<OdriveMachine>>();
}

}  // namespace touchline
