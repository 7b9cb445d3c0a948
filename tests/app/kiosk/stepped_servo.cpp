#include "tests/app/kiosk/stepped_servo.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr double period_s = 0.001;

}  // namespace

SteppedServo::SteppedServo()
    : profile_(default_profile()),
      hand_(std::make_shared<MouseHand>(Position{})),
      device_(profile_, SimulationOptions{}, hand_) {
    set_tier({});
}

void SteppedServo::set_tier(const TierLimits& tier) {
    step_.emplace(profile_, period_s, tier);
    step_->lend(&shape_);
}

Force SteppedServo::force_on_handle_W() const {
    const auto angles =
        inverse(profile_.geometry, device_from_picture(profile_, device_.tip().position));
    const auto pose = angles ? forward(profile_.geometry, *angles) : std::nullopt;
    const auto force_D = pose ? tip_force(pose->jacobian, device_.acting_torques()) : std::nullopt;
    return force_D ? turned(*force_D) : Force{};
}

void SteppedServo::run_until(double now_s) {
    while (now_s_ + period_s <= now_s) {
        now_s_ += period_s;
        StepInput input;
        input.now_s = now_s_;
        if (!is_broken_) input.reading = device_.read(now_s_);
        input.commands = commands_;
        input.delay_s = delay_s;
        input.scene = picture_.scene.get();
        if (alive_.empty() || alive_.back() != picture_.scene) alive_.push_back(picture_.scene);
        const DeviceCommand command = step_->step(input);
        if (!is_broken_) (void)device_.write(command);
        while (alive_.size() > 1 && alive_.front().get() != step_->scene()) alive_.pop_front();
        report_ = step_->report();
        most_force_N = std::max(most_force_N, norm(report_.hand.force));
        if (on_tick) on_tick(report_.hand);
    }
}

}  // namespace touchline
