// What stops the force of a servo step, what goes on without it, and how it comes back.

#include "tests/haptics/servo/step_bench.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Presses on the line by 1 mm: 0.5 N.
Bench pressing_bench(const std::shared_ptr<const Scene>& scene) {
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.001});
    bench.run(20);
    EXPECT_NEAR(norm(bench.hand().force), 0.5, 0.01);
    return bench;
}

/// Goes back above the line until force has come on; false if it does not.
bool comes_back(Bench& bench) {
    bench.drag(bench.hand().p_WH, {0.0, 0.01});
    bench.run(900);
    return bench.force().state == ForceState::live;
}

TEST(ServoFault, AGlitchOfTheEncodersIsPassedOverWithTheForceThatWas) {
    const auto scene = line_scene(0.0);
    Bench bench = pressing_bench(scene);
    const HandState before = bench.hand();
    bench.place({0.02, 0.0});
    bench.run(3);
    EXPECT_EQ(bench.hand().p_WH, before.p_WH);
    EXPECT_NEAR(norm(bench.hand().force - before.force), 0.0, 1e-6);
    bench.place({0.0, -0.001});
    bench.run(3);
    EXPECT_EQ(bench.force().state, ForceState::live);
    EXPECT_NEAR(norm(bench.hand().force - before.force), 0.0, 0.01);
}

TEST(ServoFault, AHandleThatJumpedHasNoForceAndIsTrackedWhereItIs) {
    const auto scene = line_scene(0.0);
    Bench bench = pressing_bench(scene);
    bench.place({0.02, -0.002});
    bench.run(4);
    EXPECT_EQ(bench.force().fault, Fault::position_jump);
    EXPECT_EQ(bench.told.torques, JointTorques{});
    EXPECT_NEAR(norm(bench.hand().p_WH - Position{0.02, -0.002}), 0.0, 1e-9);
    EXPECT_FALSE(comes_back(bench));
    ++bench.input.commands.faults_cleared;
    EXPECT_TRUE(comes_back(bench));
}

TEST(ServoFault, ContactAndEventsGoOnWithoutForce) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.input.commands.is_emergency_stop = true;
    bench.run(1);
    EXPECT_EQ(bench.force().fault, Fault::emergency_stop);
    int made = 0;
    for (int i = 1; i <= 120; ++i) {
        bench.place({0.0, 0.01 - 1e-4 * i});
        bench.run(1);
        for (const ContactEvent& event : bench.step->events())
            made += event.kind == ContactEventKind::contact_made ? 1 : 0;
        ASSERT_EQ(bench.told.torques, JointTorques{});
    }
    EXPECT_EQ(made, 1);
    EXPECT_EQ(bench.hand().state, ContactState::edge);
    EXPECT_NEAR(bench.hand().p_WP.y, 0.0, 1e-6);
}

TEST(ServoFault, TheEmergencyStopIsZeroAtOnceUntilItIsReleasedAndCleared) {
    const auto scene = line_scene(0.0);
    Bench bench = pressing_bench(scene);
    bench.input.commands.is_emergency_stop = true;
    bench.run(1);
    EXPECT_EQ(bench.told.torques, JointTorques{});
    ++bench.input.commands.faults_cleared;
    EXPECT_FALSE(comes_back(bench));
    bench.input.commands.is_emergency_stop = false;
    EXPECT_FALSE(comes_back(bench));
    ++bench.input.commands.faults_cleared;
    EXPECT_TRUE(comes_back(bench));
}

TEST(ServoFault, ALostDeviceThatIsBackIsArmedByItself) {
    const auto scene = line_scene(0.0);
    Bench bench = pressing_bench(scene);
    bench.input.reading.reset();
    bench.run(25);
    EXPECT_EQ(bench.force().fault, Fault::device_lost);
    bench.place({0.0, -0.001});
    bench.run(100);
    EXPECT_EQ(bench.force().state, ForceState::armed);  // the hand presses: nobody is pushed
    EXPECT_TRUE(comes_back(bench));
}

TEST(ServoFault, RefusedTorquesAreALostDeviceUntilTheyAreTaken) {
    Bench bench;
    bench.run(800);
    bench.step->lose_device();
    bench.run(1);
    EXPECT_EQ(bench.force().fault, Fault::device_lost);
    bench.run(1);
    EXPECT_EQ(bench.force().state, ForceState::armed);
}

TEST(ServoFault, AnglesThatAreNoNumbersAreAFaultForTheOperator) {
    const auto scene = line_scene(0.0);
    Bench bench = pressing_bench(scene);
    bench.input.reading = reading_of(bench.profile.geometry,
                                     JointAngles{std::numeric_limits<double>::quiet_NaN(), 0.2});
    bench.run(1);
    EXPECT_EQ(bench.told.torques, JointTorques{});
    EXPECT_EQ(bench.force().fault, Fault::not_finite);
    bench.place({0.0, -0.001});
    EXPECT_FALSE(comes_back(bench));
    ++bench.input.commands.faults_cleared;
    EXPECT_TRUE(comes_back(bench));
}

TEST(ServoFault, ForceSwitchedOffIsGoneAtOnceAndComesBackByArming) {
    const auto scene = line_scene(0.0);
    Bench bench = pressing_bench(scene);
    bench.input.commands.is_force_wanted = false;
    bench.run(2);
    EXPECT_EQ(bench.told.torques, JointTorques{});
    EXPECT_EQ(bench.force().state, ForceState::off);
    bench.input.commands.is_force_wanted = true;
    bench.run(1000);
    EXPECT_EQ(bench.force().state, ForceState::armed);
    EXPECT_TRUE(comes_back(bench));
}

TEST(ServoFault, AThrownHandleIsBrakedAndThenAFaultThatEndsByItself) {
    Bench bench;
    bench.run(800);
    bench.drag({0.0, 0.01}, {-0.04, 0.01});
    for (int i = 1; i <= 30; ++i) {
        bench.place({-0.04 + 1.8e-3 * i, 0.01});
        bench.run(1);
    }
    EXPECT_EQ(bench.force().fault, Fault::too_fast);
    bench.run(1100);
    EXPECT_NE(bench.force().state, ForceState::fault);
}

}  // namespace
}  // namespace touchline
