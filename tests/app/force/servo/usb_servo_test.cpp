// Tests the whole chain: the kiosk's guard, the program touchline-servo, libusb and an emulated
// board that holds its last torque. servo_process_test.cpp tests what dies and is killed: umockdev
// does not survive a program that is killed in the middle of a call.
#include "app/force/device/board_files.h"
#include "app/force/servo/servo_process.h"
#include "app/force/servo/usb_search.h"
#include "tests/app/force/servo/felt_line.h"
#include "tests/app/wait_until.h"
#include "tests/machines/sim/umockdev/mocked_board.h"

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

class UsbServo : public testing::Test {
  protected:
    void start(const std::string& program, std::vector<std::string> arguments = {}) {
        device_.profile = default_profile().name;
        device_.is_homed_first = false;  // the test's hand rests at home
        for (const std::string& argument : arguments_of(device_)) arguments.push_back(argument);
        servo_ = std::make_unique<ServoProcess>(ServoProcessOptions{
            program, arguments,
            [this](const std::string& bus_path) { return zero_usb_device(device_, bus_path); }});
    }

    /// Starts a servo whose force does not depend on how busy the machine is.
    void start_at_any_tier() { start(TOUCHLINE_SERVO_RIG, {"usb"}); }

    /// Runs frames as the kiosk does, until the condition holds.
    [[nodiscard]] bool frames_until(const std::function<bool()>& condition) {
        return wait_until([&] {
            (void)servo_->latest();
            const std::string notice = servo_->take_notice();
            if (!notice.empty()) std::printf("%s\n", notice.c_str());
            notices_ += notice;
            return condition();
        });
    }

    [[nodiscard]] JointTorques held() {
        JointTorques torques;
        board_.with([&](BoardEmulator& emulator, UsbFaults&) {
            if (!emulator.told_torques().empty()) torques = emulator.told_torques().back().torques;
        });
        return torques;
    }

    /// Sets a groove a millimetre beside the hand, which pulls it.
    void feel_a_pull() {
        servo_->feel(felt_line(0.045, ++version_));
        ServoCommands commands;
        commands.contact.mode = Mode::groove;
        commands.has_frame = false;  // home lies beyond the drawing area
        servo_->set(commands);
        ASSERT_TRUE(frames_until([&] { return servo_->force_status().state == ForceState::live; }));
        servo_->feel(felt_line(servo_->latest().p_WH.y + 0.001, ++version_));
        ASSERT_TRUE(frames_until([&] { return held() != JointTorques{}; }));
    }

    MockedUsb mocked_;
    MockedBoard board_{mocked_, {}};
    UsbDevice device_ = find_usb_device(read_board_files(board_files()).value()).value().value();
    std::unique_ptr<ServoProcess> servo_;
    std::string notices_;
    std::uint64_t version_ = 0;
};

TEST_F(UsbServo, TheProgramItselfTakesTheBoardAndGivesItBackWithZeroTorque) {
    start(TOUCHLINE_SERVO, {"usb-board"});
    ASSERT_TRUE(frames_until([&] { return servo_->latest().ticks > 100; }));
    const auto home = forward(default_profile().geometry, default_profile().home).value();
    const Position home_W = picture_from_device(default_profile(), home.p_DH);
    EXPECT_LT(norm(servo_->latest().p_WH - home_W), 0.001);
    servo_->stop();
    EXPECT_EQ(held(), JointTorques{});
    EXPECT_TRUE(zero_usb_device(device_).has_value());  // no process holds it any more
}

TEST_F(UsbServo, PullsAtTheHandAndEndsWithZeroTorque) {
    start_at_any_tier();
    feel_a_pull();
    servo_->stop();
    EXPECT_EQ(held(), JointTorques{});
    EXPECT_EQ(notices_, "");
}

TEST_F(UsbServo, ABoardIsZeroedWhereItIsThoughThereAreTwo) {
    const MockedBoard other(mocked_, {}, 2);
    device_.serial.clear();
    EXPECT_FALSE(zero_usb_device(device_).has_value()) << "which one is meant?";
    EXPECT_TRUE(zero_usb_device(device_, "1-1").has_value());
    EXPECT_FALSE(zero_usb_device(device_, "1-7").has_value());
}

}  // namespace
}  // namespace touchline
