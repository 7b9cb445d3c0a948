// Motors with controllers of their own as a servo's device: the words that name them, and what is
// said if they cannot be had. In real time, through a pseudo-terminal.
#include "app/force/servo/motors_device.h"

#include "tests/machines/sim/drives/drive_rig.h"
#include "tests/machines/sim/drives/real_time_hosts.h"

#include <atomic>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

MotorsDevice some_motors() {
    MotorsDevice device;
    device.port = "/dev/ttyACM3";
    device.ids = {7, 126};
    device.drives = {{Turn::clockwise, 1.0 / 3.0, -0.1}, {Turn::counter_clockwise, 0.7, 1e-17}};
    return device;
}

TEST(MotorsDevice, ComesBackFromTheCommandLineBitForBit) {
    const MotorsDevice device = some_motors();
    const auto back = motors_of(MotorsMake::odrive, arguments_of(device));
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->make, MotorsMake::odrive);
    EXPECT_EQ(back->port, device.port);
    EXPECT_EQ(back->ids, device.ids);
    EXPECT_EQ(back->drives.joint_1.turn, Turn::clockwise);
    EXPECT_EQ(back->drives.joint_1.ratio, device.drives.joint_1.ratio);
    EXPECT_EQ(back->drives.joint_1.zero_turns, device.drives.joint_1.zero_turns);
    EXPECT_EQ(back->drives.joint_2.zero_turns, device.drives.joint_2.zero_turns);
}

TEST(MotorsDevice, WordsThatNoKioskMakesAreRefused) {
    const auto good = arguments_of(some_motors());
    EXPECT_FALSE(motors_of(MotorsMake::moteus, {}).has_value());
    for (const auto& [at, word] : std::vector<std::pair<std::size_t, std::string>>{{0, ""},
                                                                                   {1, "0"},
                                                                                   {1, "127"},
                                                                                   {1, "126"},
                                                                                   {2, "x"},
                                                                                   {3, "left"},
                                                                                   {4, "0"},
                                                                                   {4, "nan"},
                                                                                   {4, "1e9"},
                                                                                   {5, "inf"},
                                                                                   {5, ""},
                                                                                   {7, "-1"},
                                                                                   {8, "1e300"}}) {
        auto words = good;
        words[at] = word;
        EXPECT_FALSE(motors_of(MotorsMake::moteus, words).has_value()) << at << ' ' << word;
    }
}

TEST(MotorsDevice, APortThatIsNotThereIsSaidInOneLine) {
    MotorsDevice device = some_motors();
    device.port = "/dev/no-such-port";
    const auto opened = open_motors(device, {});
    ASSERT_FALSE(opened.has_value());
    EXPECT_NE(opened.error().line.find("plug the device in"), std::string::npos);
    device.port = "no-such-can";
    EXPECT_NE(open_motors(device, {}).error().line.find("CAN interface"), std::string::npos);
    EXPECT_FALSE(zero_motors(device).has_value());
}

TEST(MotorsDevice, AGivenUpTestOfTheMotorsIsNoDevice) {
    MoteusMachine machine({}, MoteusMachine::units(), hand_in_the_middle());
    PtyHost host(machine.adapter);
    MotorsDevice device;
    device.port = host.path();
    std::vector<std::string> said;
    std::atomic<int> asked{0};
    Opening opening;
    opening.say = [&](const std::string& words) { said.push_back(words); };
    opening.goes_on = [&] { return ++asked < 100; };
    const auto opened = open_motors(device, opening);
    ASSERT_FALSE(opened.has_value());
    EXPECT_NE(opened.error().line.find("was stopped"), std::string::npos) << opened.error().line;
    ASSERT_FALSE(said.empty());
    EXPECT_NE(said.front().find("let go of it"), std::string::npos);
}

TEST(MotorsDevice, MotorsOfAServoThatDiedAreLetGoAndThatIsConfirmed) {
    OdriveMachine machine({}, OdriveMachine::units(), hand_in_the_middle());
    PtyHost host(machine.peer());
    MotorsDevice device;
    device.make = MotorsMake::odrive;
    device.port = host.path();
    const auto zeroed = zero_motors(device);
    EXPECT_TRUE(zeroed.has_value()) << zeroed.error().line;
}

}  // namespace
}  // namespace touchline
