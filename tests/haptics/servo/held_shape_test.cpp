// A shape in the hand through the production tick: keys or a handle turn it, lines hold it.
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/servo/step_bench.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

DeviceProfile turning() {
    return find_profile("gen3.1-turning").value();
}

/// A bar in the hand above the line y = 0, with live force.
struct Held {
    std::shared_ptr<const Scene> scene = line_scene(0.0);
    ShapeInHand hand;
    Bench bench;

    explicit Held(HeldShape shape = HeldShape::bar, const DeviceProfile& of = default_profile())
        : bench(of) {
        bench.step->lend(&hand);
        bench.input.scene = scene.get();
        bench.input.commands.shape = shape;
        bench.input.commands.has_frame = false;
        if (of.handle) bench.handle_rad = 0.0;
        bench.place({0.0, 0.02});
        bench.run(1000);
        EXPECT_EQ(bench.force().state, ForceState::live);
        EXPECT_EQ(bench.hand().shape, shape);
    }
};

TEST(HeldShape, WithoutOneNothingIsHeld) {
    Bench bench;
    bench.input.commands.shape = HeldShape::bar;  // which nobody lent
    const auto scene = line_scene(0.0);
    bench.input.scene = scene.get();
    EXPECT_EQ(bench.run(1000).shape, HeldShape::none);
}

TEST(HeldShape, ALineStopsItsEdgeNotTheHandsPlace) {
    Held held;
    held.bench.drag({0.0, 0.02}, {0.0, 0.001});
    const HandState& hand = held.bench.run(300);
    EXPECT_TRUE(hand.is_shape_placed);
    EXPECT_EQ(hand.mode, Mode::wall);
    EXPECT_NE(hand.state, ContactState::free);
    EXPECT_NEAR(hand.p_WP.y, 0.0025, 1e-6);  // half of its 4 mm, plus its rounding of 0.5 mm
    EXPECT_GT(hand.force.y, 0.3);
    EXPECT_NEAR(hand.torque_Nm, 0.0, 2e-3);
    EXPECT_EQ(hand.outline, 0);
}

TEST(HeldShape, KeysTurnItSlowlyAndALineFeelsLikeATwist) {
    Held held;
    held.bench.drag({0.0, 0.02}, {0.0, 0.005});
    held.bench.input.commands.turn_rad = 0.8;
    double before_rad = held.bench.hand().angle_rad;
    for (int i = 0; i < 2000; ++i) {
        const HandState& hand = held.bench.run(1);
        ASSERT_LE(hand.angle_rad - before_rad, 0.002 + 1e-12);
        before_rad = hand.angle_rad;
    }
    const HandState& hand = held.bench.hand();
    // 9 mm of the bar do not fit into the 5 mm between the hand and the line.
    EXPECT_GT(hand.angle_rad, hand.proxy_angle_rad + 0.05);
    EXPECT_LE(hand.angle_rad, hand.proxy_angle_rad + 0.36);
    EXPECT_LT(hand.torque_Nm, -3e-3);
    EXPECT_GT(hand.p_WP.y, 0.005);
    EXPECT_EQ(held.bench.told.handle_Nm, 0.0);  // there is no motor to tell it to
}

TEST(HeldShape, AMotorAtTheHandleTellsItsTorque) {
    Held held(HeldShape::bar, turning());
    held.bench.drag({0.0, 0.02}, {0.0, 0.005});
    for (int i = 0; i < 600; ++i) {
        held.bench.handle_rad = 1e-3 * i;
        (void)held.bench.run(1);
    }
    (void)held.bench.run(200);
    const HandState& hand = held.bench.hand();
    EXPECT_NEAR(hand.angle_rad, 0.599, 1e-12);
    EXPECT_LT(hand.torque_Nm, -1e-3);
    EXPECT_NEAR(held.bench.told.handle_Nm, hand.torque_Nm, 1e-3);
}

TEST(HeldShape, AnAngleThatIsNoNumberIsAFaultWithoutForce) {
    Held held(HeldShape::bar, turning());
    held.bench.drag({0.0, 0.02}, {0.0, 0.001});
    held.bench.handle_rad = std::numeric_limits<double>::quiet_NaN();
    (void)held.bench.run(1);
    EXPECT_EQ(held.bench.told.torques, JointTorques{});
    EXPECT_EQ(held.bench.told.handle_Nm, 0.0);
    EXPECT_EQ(held.bench.force().fault, Fault::not_finite);
    EXPECT_TRUE(std::isfinite(held.bench.hand().angle_rad));
}

TEST(HeldShape, AnotherShapeGoesThroughZeroForce) {
    Held held;
    held.bench.drag({0.0, 0.02}, {0.0, 0.001});
    (void)held.bench.run(300);
    held.bench.input.commands.shape = HeldShape::disc;
    double least_N = 10.0;
    for (int i = 0; i < 100 && held.bench.hand().shape != HeldShape::disc; ++i) {
        (void)held.bench.run(1);
        least_N = std::min(least_N, norm(held.bench.hand().force));
    }
    EXPECT_EQ(held.bench.hand().shape, HeldShape::disc);
    EXPECT_LT(least_N, 0.01);
    // The line runs through the disc, so the hand does not hold it until it has left the line.
    EXPECT_FALSE(held.bench.run(500).is_shape_placed);
    EXPECT_EQ(held.bench.hand().force, Force{});
    held.bench.drag({0.0, 0.001}, {0.0, 0.01});
    EXPECT_TRUE(held.bench.run(1).is_shape_placed);
}

TEST(HeldShape, AHandThatIsLedHoldsAPoint) {
    Held held;
    held.bench.input.commands.guidance.kind = GuidanceKind::to_place;
    held.bench.input.commands.guidance.place = {0.02, 0.02};
    ++held.bench.input.commands.guidance.serial;
    bool was_led = false;
    for (int i = 0; i < 1000; ++i) {
        const HandState& hand = held.bench.run(1);
        if (hand.guidance.phase != GuidancePhase::running) continue;
        was_led = true;
        EXPECT_EQ(hand.shape, HeldShape::none);
    }
    EXPECT_TRUE(was_led);
}

TEST(HeldShape, OnASimulatedTurningHandleAJamIsAsStillAsAHand) {
    const DeviceProfile profile = turning();
    // Pressed on the line and twisted against it, then held.
    const auto path = std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{
        {1.0, {0.0, 0.015}, 0.0}, {1.5, {0.0, 0.003}, 0.0}, {2.0, {0.0, 0.003}, 0.6}});
    SimulatedPantograph device(profile, {}, path);
    ServoExchange exchange;
    Recorder recorder;
    ServoLoop loop(device, profile, 1e-3, exchange, recorder);
    ServoCommands commands;
    commands.shape = HeldShape::bar;
    exchange.set(commands);
    exchange.feel(line_scene(0.0));
    double most_Nm = 0.0, low_rad = 10.0, high_rad = -10.0;
    for (int k = 0; k < 4000; ++k) {
        loop.tick(1e-3 * k, 0);
        most_Nm = std::max(most_Nm, std::abs(device.acting_handle_torque_Nm()));
        if (k < 3500) continue;
        low_rad = std::min(low_rad, exchange.report().hand.angle_rad);
        high_rad = std::max(high_rad, exchange.report().hand.angle_rad);
    }
    EXPECT_GT(most_Nm, 2e-3);
    EXPECT_LT(most_Nm, 0.0901);
    EXPECT_LE(high_rad - low_rad, 2.1 * encoder_quantum_rad(*profile.handle));
    EXPECT_EQ(exchange.report().force.fault, Fault::none);
    EXPECT_EQ(exchange.report().hand.spring_gain, 1.0);
}

}  // namespace
}  // namespace touchline
