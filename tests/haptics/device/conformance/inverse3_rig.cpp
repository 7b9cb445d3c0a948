// The Inverse3: its driver on the emulated service.
#include "tests/haptics/device/conformance/rigs.h"
#include "tests/machines/sim/inverse3/arm_rig.h"

#include <array>
#include <cmath>
#include <memory>

namespace touchline {
namespace {

class Inverse3Rig final : public DeviceRig {
  public:
    ForceDevice& device() override { return *rig_.device; }

    [[nodiscard]] const DeviceProfile& profile() const override { return rig_.profile; }

    bool open() override {
        if (is_opened_) rig_.connect();
        is_opened_ = true;
        if (!rig_.open()) return false;
        (void)rig_.tick_for(0.1);  // the first commands, after the quiet
        return true;
    }

    [[nodiscard]] double now_s() const override { return rig_.now_s; }

    void pass(double span_s) override { rig_.link->rest(span_s); }

    void move_hand(Position p_D) override {
        rig_.hand->move_to(picture_from_device(profile(), p_D));
    }

    /// The service ends.
    void cut() override { rig_.link->close(); }

    /// The service takes frames and answers none.
    void fall_silent() override { rig_.link->spoil(AnswerFault::lost, 1'000'000); }

    void join() override {}

    void garble_next(unsigned seed) override {
        constexpr std::array faults{AnswerFault::cut, AnswerFault::garbled, AnswerFault::doubled,
                                    AnswerFault::other_arm};
        rig_.link->spoil(faults[seed % faults.size()]);
    }

    void slow_answers(double late_s, int ticks) override {
        rig_.link->spoil(AnswerFault::late, ticks, late_s);
    }

    [[nodiscard]] Position true_p_D() const override {
        const Space place_m = rig_.service.place_m();
        return {-place_m.x, -place_m.y};
    }

    [[nodiscard]] Force true_force_D() const override {
        return {-rig_.service.applied_N().x, -rig_.service.applied_N().y};
    }

    [[nodiscard]] bool holds_zero() const override { return rig_.service.applied_N() == Space{}; }

  private:
    ArmRig rig_;
    bool is_opened_ = false;
};

}  // namespace

std::unique_ptr<DeviceRig> inverse3_rig() {
    return std::make_unique<Inverse3Rig>();
}

}  // namespace touchline
