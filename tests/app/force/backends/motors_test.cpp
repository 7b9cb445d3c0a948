// Motors with controllers of their own from the kiosk's side: what is kept of a unit, and the
// commands, in real time through a pseudo-terminal.
#include "app/force/backends/motors.h"

#include "app/force/backends/servo_backends.h"
#include "tests/machines/sim/drives/drive_rig.h"
#include "tests/machines/sim/drives/real_time_hosts.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

MotorUnit some_unit() {
    return {"moteus", {{{7, true, 1.0 / 3.0, -0.1}, {3, false, 1.0, 2.0}}}};
}

/// The kept units are in a file of the test's own.
class Motors : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("touchline-motors-" + std::to_string(getpid()));
        setenv("TOUCHLINE_MOTORS", (folder_ / "motors.toml").c_str(), 1);
    }

    void TearDown() override {
        unsetenv("TOUCHLINE_MOTORS");
        std::filesystem::remove_all(folder_);
    }

    std::filesystem::path folder_;
};

TEST_F(Motors, WhatIsKeptComesBackAndReplacesOnlyItsMake) {
    EXPECT_FALSE(stored_motors(MotorsMake::moteus).value().has_value());
    MotorUnit other = some_unit();
    other.make = "odrive";
    ASSERT_TRUE(keep_motors(other).has_value());
    MotorUnit first = some_unit();
    first.motors[0].ratio = 2.0;
    ASSERT_TRUE(keep_motors(first).has_value());
    ASSERT_TRUE(keep_motors(some_unit()).has_value());
    EXPECT_EQ(stored_motors(MotorsMake::moteus).value(), some_unit());
    EXPECT_EQ(stored_motors(MotorsMake::odrive).value(), other);
}

TEST_F(Motors, AFileThatIsWrongIsOneLineWithItsPlace) {
    for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
             {"[[moteus]]\nid = 1\n", "two motors"},
             {"moteus = 3\n", "two motors"},
             {"[[abacus]]\n[[abacus]]\n", "no make of device"},
             {"[[moteus]]\nid = 0\nclockwise=true\nratio=1.0\nzero_turns=0.0\n[[moteus]]\n",
              "'id' must be a number from 1 to 126"},
             {"[[moteus]]\nid = 1\nclockwise=1\nratio=nan\nzero_turns=0\n[[moteus]]\n", "'ratio'"},
             {"[[moteus]]\nspeed = 1\n[[moteus]]\n", "'speed' is not a setting here"},
             {"[[moteus", ""}}) {
        const auto read = parse_motor_units(text, "motors.toml");
        ASSERT_FALSE(read.has_value()) << text;
        EXPECT_TRUE(read.error().line.starts_with("motors.toml:")) << read.error().line;
        EXPECT_NE(read.error().line.find(words), std::string::npos) << read.error().line;
    }
    MotorUnit twin = some_unit();
    twin.motors[1].id = 7;
    EXPECT_FALSE(parse_motor_units(motor_units_text({twin}), "x").has_value());
}

TEST_F(Motors, AUnitThatWasNeverSetUpIsNotDrivenAndSaysWhatToDo) {
    const auto found = find_moteus("/dev/ttyACM7");
    ASSERT_FALSE(found.has_value());
    EXPECT_NE(found.error().line.find("touchline device home --make moteus"), std::string::npos);
}

TEST_F(Motors, TheServoTakesTheWordsOfAUnitThatIsSetUp) {
    ASSERT_TRUE(keep_motors(some_unit()).has_value());
    const auto found = find_moteus("can0");
    ASSERT_TRUE(found.has_value() && found->has_value());
    EXPECT_TRUE(names_device((*found)->servo.arguments));
    EXPECT_EQ((*found)->profile.name, "open-five-bar");
    const auto read =
        motors_of(MotorsMake::moteus, std::span((*found)->servo.arguments).subspan(1));
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->port, "can0");
    EXPECT_EQ(read->ids, (std::array<std::uint8_t, 2>{7, 3}));
    EXPECT_EQ(read->drives.joint_1.ratio, 1.0 / 3.0);
    EXPECT_EQ(read->drives.joint_1.turn, Turn::clockwise);
}

TEST_F(Motors, HomeFindsTheZerosProbeAsksAndStopLetsGo) {
    DriveTruth truth;
    truth.hand = stiff_arm;
    truth.drives.joint_1.zero_turns = 0.2;
    truth.drives.joint_2.zero_turns = -0.3;
    const Position home = forward(truth.profile.geometry, truth.profile.home).value().p_DH;
    const auto at_home = std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.0, picture_from_device(truth.profile, home)}});
    MoteusMachine machine(truth, MoteusMachine::units(), at_home);
    PtyHost host(machine.adapter);
    DeviceCommandOptions options;
    options.port = host.path();
    options.make = "moteus";
    std::ostringstream out;
    options.action = DeviceAction::home;
    const CommandEnd homed = command_moteus(options, out);
    ASSERT_TRUE(homed.result.has_value()) << homed.result.error().line;
    const auto kept = stored_motors(MotorsMake::moteus).value();
    ASSERT_TRUE(kept.has_value());
    const auto part_of_a_turn = [](double turns) { return turns - std::round(turns); };
    EXPECT_NEAR(part_of_a_turn(kept->motors[0].zero_turns - 0.2), 0.0, 1e-3);
    EXPECT_NEAR(part_of_a_turn(kept->motors[1].zero_turns + 0.3), 0.0, 1e-3);
    options.action = DeviceAction::probe;
    EXPECT_TRUE(command_moteus(options, out).result.has_value());
    EXPECT_NE(out.str().find("answers to 1000 questions"), std::string::npos) << out.str();
    options.action = DeviceAction::stop;
    const CommandEnd stopped = command_moteus(options, out);
    EXPECT_TRUE(stopped.was_there);
    EXPECT_TRUE(stopped.result.has_value()) << stopped.result.error().line;
    EXPECT_NE(out.str().find("are let go: confirmed"), std::string::npos);
}

TEST_F(Motors, StopSendsNothingToAnAdapterOfAMakeThatNobodySetUp) {
    MoteusMachine machine({}, MoteusMachine::units(), hand_in_the_middle());
    PtyHost host(machine.adapter);
    DeviceCommandOptions options{DeviceAction::stop, "", "", "", host.path()};
    std::ostringstream out;
    EXPECT_FALSE(command_moteus(options, out).was_there);
    EXPECT_TRUE(out.str().empty());
}

}  // namespace
}  // namespace touchline
