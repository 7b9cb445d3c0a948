#include "tests/app/kiosk/stepped_servo.h"

#include <algorithm>

namespace touchline {
namespace {

constexpr double period_s = 0.001;

}  // namespace

SteppedServo::SteppedServo()
    : profile_(default_profile()),
      hand_(std::make_shared<MouseHand>(Position{})),
      device_(profile_, SimulationOptions{}, hand_),
      step_(profile_, period_s) {
    step_.lend(&shape_);
}

void SteppedServo::run_until(double now_s) {
    while (now_s_ + period_s <= now_s) {
        now_s_ += period_s;
        StepInput input;
        input.now_s = now_s_;
        if (!is_broken_) input.angles = device_.read_angles(now_s_);
        input.commands = commands_;
        input.scene = picture_.scene.get();
        if (alive_.empty() || alive_.back() != picture_.scene) alive_.push_back(picture_.scene);
        const JointTorques torques = step_.step(input);
        if (!is_broken_) (void)device_.write_torques(torques);
        while (alive_.size() > 1 && alive_.front().get() != step_.scene()) alive_.pop_front();
        report_ = step_.report();
        most_force_N = std::max(most_force_N, norm(report_.hand.force));
    }
}

}  // namespace touchline
