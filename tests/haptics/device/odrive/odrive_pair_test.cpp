// What an ODrive must confirm before there is force, and what is told if it does not.
#include "haptics/device/odrive/odrive_pair.h"

#include "haptics/device/serial/serial_port.h"
#include "tests/haptics/device/drives/drive_ends.h"
#include "tests/machines/sim/drives/real_time_hosts.h"

#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using OdriveRig = DriveRig<OdriveMachine>;

TEST(OdrivePair, AWatchdogThatReadsBackOtherwiseGetsNoTorque) {
    for (const double factor : {0.5, 1.01, 5.0}) {
        auto axes = OdriveMachine::units();
        axes[0].watchdog_factor = factor;
        expect_refused<OdriveMachine>(axes, "axis 0 (motor 1) does not confirm its watchdog");
    }
    auto axes = OdriveMachine::units();
    axes[1].has_watchdog = false;
    expect_refused<OdriveMachine>(axes, "axis 1 (motor 2) does not confirm its watchdog");
}

TEST(OdrivePair, AnAxisThatWasNeverCalibratedGetsNoTorque) {
    auto axes = OdriveMachine::units();
    axes[1].is_calibrated = false;
    expect_refused<OdriveMachine>(axes, "axis 1 (motor 2) does not know its motor yet");
    axes = OdriveMachine::units();
    axes[0].is_encoder_ready = false;
    expect_refused<OdriveMachine>(axes, "axis 0 (motor 1) does not know its encoder yet");
}

// Arming clears what it finds, so it clears nothing where the look found nothing.
TEST(OdrivePair, AFaultBetweenLookAndArmingIsToldThoughTheArmingsAnswerIsLostToo) {
    for (const std::size_t motor : {0U, 1U}) {
        for (int ticks = 0; ticks < 60; ++ticks) {
            SCOPED_TRACE(testing::Message() << "motor " << motor << " after " << ticks << " ms");
            OdriveRig rig;
            ASSERT_TRUE(rig.driver->open().has_value());
            rig.tick_for(0.05, press);
            rig.line->spoil(LineFault::lost_reply, 0.006);
            rig.tick_for(drive_tick_s * ticks, press);
            rig.machine.fail(motor);
            rig.tick_for(drive_tick_s, press);
            rig.line->spoil(LineFault::lost_reply, 0.003);
            rig.tick_for(1.0, press);  // a set-up whose answers are lost is begun anew after 0.8 s
            expect_told(rig, motor);
        }
    }
}

TEST(OdrivePair, AFirmwareThatLacksAPropertyGetsNoTorque) {
    auto axes = OdriveMachine::units();
    axes[1].knows_torque_limit = false;
    expect_refused<OdriveMachine>(axes, "lacks what force needs");
}

TEST(OdrivePair, AnAxisThatKeepsItsRampGetsNoTorque) {
    auto axes = OdriveMachine::units();
    axes[0].stored_input_mode = 6;
    axes[0].deaf_to_input_modes = 1000;
    expect_refused<OdriveMachine>(axes, "axis 0 (motor 1) keeps a control mode or a ramp");
}

TEST(OdrivePair, ARampWhoseEndWasLostInArmingIsSeenAndAZeroIsOne) {
    auto axes = OdriveMachine::units();
    axes[1].stored_input_mode = 6;
    axes[1].deaf_to_input_modes = 1;
    OdriveRig rig({}, axes);
    const auto opened = rig.driver->open();
    ASSERT_TRUE(opened.has_value()) << opened.error().line;
    rig.tick_for(0.1, press);
    EXPECT_NEAR(norm(rig.held() - press), 0.0, 1e-4);
    for (int k = 0; k < 10; ++k) {
        (void)rig.tick({});
        if (!rig.is_written) continue;
        EXPECT_EQ(rig.held(), JointTorques{});
    }
    EXPECT_TRUE(rig.is_written);
}

TEST(OdrivePair, AnEncoderThatOnlyCountsLeavesThePlaceInDoubt) {
    auto axes = OdriveMachine::units();
    axes[1].encoder_mode = 0;
    OdriveRig rig({}, axes);
    ASSERT_TRUE(rig.driver->open().has_value());
    EXPECT_TRUE(rig.driver->report().is_position_doubtful);
}

TEST(OdrivePair, ABoardThatStartsAnewInMidVisitIsArmedAnew) {
    OdriveRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.05, press);
    rig.machine.board.reset();  // without a watchdog
    rig.tick_for(0.005, press);
    EXPECT_EQ(rig.driver->report().state, DriveState::setting_up);
    EXPECT_EQ(rig.held(), JointTorques{});
    rig.tick_for(0.2, press);
    EXPECT_EQ(rig.driver->report().state, DriveState::ready);
    rig.pass(0.1);
    EXPECT_EQ(rig.bridges(), both_off);
}

TEST(OdrivePair, EveryBitOfAnErrorSaysWhatToDo) {
    const OdrivePair pair(nullptr, 0.1);
    for (unsigned bit = 0; bit < 32; ++bit) {
        const std::string words = pair.words_of({MotorTrouble::Kind::fault, 2, 1U << bit});
        EXPECT_NE(words.find("axis 1 (motor 2) stopped with error"), std::string::npos);
        EXPECT_NE(words.find(": "), std::string::npos);
    }
}

TEST(OdriveInRealTime, PressesThroughASerialPortAndItsWatchdogLetsGo) {
    OdriveMachine machine({}, OdriveMachine::units(), hand_in_the_middle());
    PtyHost host(machine.peer());
    auto port = open_serial_port(host.path());
    ASSERT_TRUE(port.has_value()) << port.error().line;
    MotorPantograph driver(OdriveMachine::pair_over(std::move(*port)), DriveTruth{}.profile, {});
    const auto opened = driver.open();
    ASSERT_TRUE(opened.has_value()) << opened.error().line;
    const auto start = std::chrono::steady_clock::now();
    int with_angles = 0;
    for (int k = 0; k < 500; ++k) {
        std::this_thread::sleep_until(start + k * std::chrono::milliseconds(1));
        const std::chrono::duration<double> now = std::chrono::steady_clock::now() - start;
        const auto angles = driver.read_angles(now.count());
        with_angles += angles ? 1 : 0;
        (void)driver.write_torques(angles ? press : JointTorques{});
    }
    EXPECT_GT(with_angles, 20);
    host.end_after(0.2);
    bool has_pressed = false;
    for (const BridgeChange& change : machine.plant().changes())
        has_pressed = has_pressed || change.torques != ShaftTorques{};
    EXPECT_TRUE(has_pressed);
    EXPECT_EQ(machine.plant().changes().back().torques, ShaftTorques{});
    EXPECT_EQ(machine.plant().changes().back().bridges, both_off);
}

}  // namespace
}  // namespace touchline
