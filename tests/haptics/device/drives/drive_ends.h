// How it ends with an emulated pair of controllers that may not or cannot work, the same for every
// make.
#pragma once

#include "tests/machines/sim/drives/drive_rig.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace touchline {

inline constexpr JointTorques press{0.05, -0.03};
inline constexpr std::array both_off{Bridge::off, Bridge::off};

/// Such a pair is not opened, in these words among others, and never gets a torque.
template <class Machine>
void expect_refused(const std::array<typename Machine::Truth, 2>& units, std::string_view words) {
    DriveRig<Machine> rig({}, units);
    const auto opened = rig.driver->open();
    ASSERT_FALSE(opened.has_value()) << words;
    EXPECT_NE(opened.error().line.find(words), std::string::npos) << opened.error().line;
    EXPECT_EQ(rig.driver->report().state, DriveState::refused);
    rig.tick_for(0.2, press);
    EXPECT_FALSE(rig.driver->write_torques(press));
    for (const BridgeChange& change : rig.plant().changes())
        EXPECT_EQ(change.torques, ShaftTorques{});
    EXPECT_EQ(rig.bridges(), both_off);
}

/// A fault of a motor ends in a refusal that names it, and only open() leads back.
template <class Machine>
void expect_told(DriveRig<Machine>& rig, std::size_t motor) {
    rig.tick_for(0.3, press);
    EXPECT_EQ(rig.driver->report().state, DriveState::refused);
    EXPECT_EQ(rig.driver->report().trouble.kind, MotorTrouble::Kind::fault);
    EXPECT_EQ(rig.driver->report().trouble.motor, static_cast<int>(motor) + 1);
    EXPECT_EQ(rig.bridges(), both_off);
    ASSERT_TRUE(rig.driver->open().has_value());  // somebody was told and wants it so
    rig.tick_for(0.05, press);
    EXPECT_NEAR(norm(rig.held() - press), 0.0, 1e-4);
}

}  // namespace touchline
