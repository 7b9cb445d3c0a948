// What two moteus controllers must confirm before there is force, and what is told if they do not.
#include "haptics/device/moteus/moteus_pair.h"

#include "tests/haptics/device/drives/drive_ends.h"

#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using MoteusRig = DriveRig<MoteusMachine>;

TEST(MoteusPair, TheTimeOutThatDampsIsChangedToOneThatLetsGo) {
    auto units = MoteusMachine::units();
    EXPECT_EQ(units[0].stored_timeout_mode, 12);  // as they are sold
    MoteusRig rig({}, units);
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.05, press);
    rig.pass(0.1);
    EXPECT_EQ(rig.machine.bus.unit(0).mode(), 11);
    EXPECT_EQ(rig.machine.bus.unit(0).bridge(), Bridge::off);
}

TEST(MoteusPair, AControllerThatKeepsTheTimeOutThatDampsGetsNoTorque) {
    auto units = MoteusMachine::units();
    units[1].takes_settings = false;
    expect_refused<MoteusMachine>(units, "motor 2 (id 2) would not let its motor go");
}

TEST(MoteusPair, AWatchdogThatReadsBackOtherwiseGetsNoTorque) {
    for (const double factor : {0.5, 1.01, 5.0}) {
        auto units = MoteusMachine::units();
        units[0].watchdog_factor = factor;
        expect_refused<MoteusMachine>(units, "motor 1 (id 1) does not confirm its watchdog");
    }
}

TEST(MoteusPair, AFirmwareThatLacksARegisterOrTheSettingGetsNoTorque) {
    auto units = MoteusMachine::units();
    units[1].knows_bounds = false;
    expect_refused<MoteusMachine>(units, "motor 2 (id 2) lacks what force needs");
    units = MoteusMachine::units();
    units[0].knows_timeout_mode = false;
    expect_refused<MoteusMachine>(units, "motor 1 (id 1) lacks what force needs");
}

TEST(MoteusPair, WhatSomebodyElseLeftInTheConsoleIsNotTakenForAnAnswer) {
    MoteusRig rig;
    rig.machine.bus.unit(0).leave_in_console("0\r\nOK\r\n0\r\nERR unknown command\r\n" +
                                             std::string(300, 'x') + "\r\n");
    ASSERT_TRUE(rig.driver->open().has_value());
}

TEST(MoteusPair, AControllerThatStartsAnewInMidVisitIsArmedAnew) {
    MoteusRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.05, press);
    rig.machine.bus.unit(1).reset();  // its time-out damps again
    rig.tick_for(0.005, press);
    EXPECT_EQ(rig.driver->report().state, DriveState::setting_up);
    EXPECT_EQ(rig.held(), JointTorques{});
    rig.tick_for(0.2, press);
    EXPECT_EQ(rig.driver->report().state, DriveState::ready);
    rig.pass(0.1);
    EXPECT_EQ(rig.bridges(), both_off);
}

TEST(MoteusPair, AnEncoderThatOnlyCountsLeavesThePlaceInDoubt) {
    auto units = MoteusMachine::units();
    units[1].home = 0;
    MoteusRig rig({}, units);
    ASSERT_TRUE(rig.driver->open().has_value());
    EXPECT_TRUE(rig.driver->report().is_position_doubtful);
}

TEST(MoteusPair, OneControllerThatIsMissingIsNamed) {
    auto units = MoteusMachine::units();
    units[1].id = 3;
    MoteusRig rig({}, units);
    const auto opened = rig.driver->open();
    ASSERT_FALSE(opened.has_value());
    EXPECT_NE(opened.error().line.find("motor 2 (id 2) does not answer"), std::string::npos)
        << opened.error().line;
}

TEST(MoteusPair, EveryFaultCodeSaysWhatToDo) {
    for (std::uint32_t code = 0; code < 256; ++code)
        EXPECT_FALSE(words_of_moteus_fault(code).empty());
    EXPECT_NE(words_of_moteus_fault(40).find("power"), std::string_view::npos);
}

}  // namespace
}  // namespace touchline
