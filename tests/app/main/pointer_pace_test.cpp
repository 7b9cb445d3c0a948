#include "app/main/kiosk_window.h"
#include "haptics/device/simulated_pantograph.h"
#include "haptics/servo/servo_step.h"

#include <memory>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(PointerPace, GetsThereAndNoFaster) {
    EXPECT_EQ(paced({0.01, 0.0}, {0.015, 0.0}, 1.0 / 60), (Position{0.015, 0.0}));
    EXPECT_NEAR(paced({0.0, 0.0}, {0.05, 0.0}, 1.0 / 60).x, 0.01, 1e-12);
}

/// The pointer leaps from corner to corner of the picture, twice a second.
TEST(PointerPace, APointerThatLeapsLeavesTheForceOn) {
    const auto hand = std::make_shared<MouseHand>(Position{});
    SimulatedPantograph device(default_profile(), {}, hand);
    ServoStep step(default_profile(), 1e-3);
    Position led;
    for (int k = 0; k < 20'000; ++k) {
        const Position pointer = k / 500 % 2 == 0 ? Position{0.055, 0.04} : Position{-0.055, -0.04};
        if (k % 17 == 0) {
            led = paced(led, pointer, 1.0 / 60);
            hand->move_to(led);
        }
        StepInput input;
        input.now_s = 1e-3 * k;
        input.angles = device.read_angles(input.now_s);
        (void)device.write_torques(step.step(input));
        ASSERT_NE(step.report().force.state, ForceState::fault) << k;
    }
    EXPECT_EQ(step.report().force.state, ForceState::live);
}

}  // namespace
}  // namespace touchline
