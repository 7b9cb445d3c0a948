// Tests touchline device, through libusb against the emulated board. Runs under umockdev-wrapper.
#include "app/force/backends/kiosk_backends.h"
#include "app/force/device/board_files.h"
#include "tests/app/force/device/person.h"
#include "tests/machines/sim/umockdev/mocked_board.h"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <thread>
#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// Hands each line over as soon as it is complete.
class Lines final : public std::streambuf {
  public:
    explicit Lines(std::function<void(const std::string&)> hear) : hear_(std::move(hear)) {}

  protected:
    int_type overflow(int_type c) override {
        if (c != '\n') {
            line_.push_back(static_cast<char>(c));
        } else {
            hear_(std::exchange(line_, {}));
        }
        return c;
    }

  private:
    std::function<void(const std::string&)> hear_;
    std::string line_;
};

/// A board, and a person at its handle who hears what a command says.
struct Visit {
    Visit(MockedUsb& usb, BoardTruth truth)
        : person(std::make_shared<Person>(truth.profile)), board(usb, firm(truth), 1, person) {}

    static BoardTruth firm(BoardTruth truth) {
        truth.hand = stiff_arm;
        return truth;
    }

    Result<void> run(DeviceAction action) {
        std::atomic<bool> is_over{false};
        // Lets go when the words say so, and takes the handle again for the next words.
        std::thread hand([&] {
            for (; !is_over; std::this_thread::sleep_for(std::chrono::milliseconds(5)))
                board.with([&](BoardEmulator& emulator, UsbFaults&) {
                    const bool holds = person->holds(emulator.now_s());
                    if (std::exchange(is_held, holds) != holds)
                        emulator.grip(holds ? stiff_arm : no_hand);
                });
        });
        Lines lines([&](const std::string& line) {
            double now_s = 0.0;
            board.with([&](BoardEmulator& emulator, UsbFaults&) { now_s = emulator.now_s(); });
            person->hear(line, now_s);
        });
        std::ostream out(&lines);
        const auto ended = command_device({action, "", std::string(default_profile().name)}, out);
        is_over = true;
        hand.join();
        return ended;
    }

    std::shared_ptr<Person> person;
    MockedBoard board;
    bool is_held = true;
};

class DeviceCommand : public testing::Test {
  protected:
    DeviceCommand() {
        fs::remove(units_);
        setenv("TOUCHLINE_UNITS", units_.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
    }

    ~DeviceCommand() override { fs::remove(units_); }

    Result<void> run(DeviceAction action) {
        return command_device({action, "", std::string(default_profile().name)}, out_);
    }

    static JointTorques held(MockedBoard& board) {
        JointTorques torques;
        board.with([&](BoardEmulator& emulator, UsbFaults&) {
            if (!emulator.told_torques().empty()) torques = emulator.told_torques().back().torques;
        });
        return torques;
    }

    static bool asks_for_another_try(const Error& error) {
        return error.line.find("held or moved") != std::string::npos;
    }

    MockedUsb usb_;
    fs::path units_ =
        fs::temp_directory_path() / ("touchline-" + std::to_string(getpid()) + ".toml");
    std::ostringstream out_;
};

TEST_F(DeviceCommand, WithoutABoardEveryCommandSaysWhatWasLookedFor) {
    ASSERT_TRUE(run(DeviceAction::list).has_value());
    EXPECT_NE(out_.str().find("2341:804d"), std::string::npos);
    for (const DeviceAction action :
         {DeviceAction::probe, DeviceAction::home, DeviceAction::nudge, DeviceAction::stop}) {
        const auto ended = run(action);
        ASSERT_FALSE(ended.has_value());
        EXPECT_NE(ended.error().line.find("Haply"), std::string::npos) << ended.error().line;
        EXPECT_EQ(ended.error().line.find('\n'), std::string::npos);
    }
}

TEST_F(DeviceCommand, ListProbeAndStopTellOfTheBoard) {
    MockedBoard board(usb_, {});
    ASSERT_TRUE(run(DeviceAction::list).has_value());
    EXPECT_NE(out_.str().find(BoardTruth{}.serial), std::string::npos);
    ASSERT_TRUE(run(DeviceAction::probe).has_value());
    EXPECT_NE(out_.str().find("answers to 1000 questions"), std::string::npos);
    EXPECT_NE(out_.str().find("began the ticks"), std::string::npos);
    ASSERT_TRUE(run(DeviceAction::stop).has_value());
    EXPECT_NE(out_.str().find("confirmed zero torque"), std::string::npos);
    EXPECT_EQ(held(board), JointTorques{});
}

TEST_F(DeviceCommand, StopNeedsNoSoundFileOfUnits) {
    MockedBoard board(usb_, {});
    std::ofstream(units_) << "[[unit]]\nserial = 7\n";
    EXPECT_FALSE(run(DeviceAction::probe).has_value());
    EXPECT_TRUE(run(DeviceAction::stop).has_value());
}

TEST_F(DeviceCommand, NudgeHomesAKnownUnitAndTellsWhetherTheMotorsHavePower) {
    Visit visit(usb_, {});
    EXPECT_NE(visit.run(DeviceAction::nudge).error().line.find("Home the handle first"),
              std::string::npos);
    UnitSettings known{BoardTruth{}.serial, std::string(default_profile().name), {}};
    known.calibration.is_measured = true;
    ASSERT_TRUE(keep_unit(board_files(), known).has_value());
    visit.board.with([](BoardEmulator& emulator, UsbFaults&) { emulator.switch_motors(false); });
    const auto without = visit.run(DeviceAction::nudge);
    ASSERT_FALSE(without.has_value());
    EXPECT_NE(without.error().line.find("power of the motors"), std::string::npos)
        << without.error().line;
    EXPECT_EQ(held(visit.board), JointTorques{});
    visit.board.with([](BoardEmulator& emulator, UsbFaults&) { emulator.switch_motors(true); });
    // If a tick is late, a pulse may throw the free handle; the words then ask for another try.
    auto with = visit.run(DeviceAction::nudge);
    for (int tries = 1; tries < 10 && !with && asks_for_another_try(with.error()); ++tries)
        with = visit.run(DeviceAction::nudge);
    EXPECT_TRUE(with.has_value()) << with.error().line;
    EXPECT_EQ(held(visit.board), JointTorques{});
}

TEST_F(DeviceCommand, TheKindOfANewUnitIsAskedAndNotAssumed) {
    MockedBoard board(usb_, {});
    for (const DeviceAction action : {DeviceAction::home, DeviceAction::nudge}) {
        const auto ended = command_device({action, "", ""}, out_);
        ASSERT_FALSE(ended.has_value());
        EXPECT_NE(ended.error().line.find("which kind"), std::string::npos) << ended.error().line;
        EXPECT_NE(ended.error().line.find("2diy-gen3.1-172"), std::string::npos);
    }
    EXPECT_EQ(held(board), JointTorques{});
}

/// The stored calibration is wrong and would never fit.
TEST_F(DeviceCommand, HomeOfANamedKindMeasuresAnewAndKeepsWhatItFound) {
    BoardTruth truth;
    truth.scale_error = {0.015, 0.015};
    UnitSettings stored{truth.serial, "2diy-gen3.1", {}};
    stored.calibration = {{}, {}, 0.5, {}, {}, true, false, 0.1};
    ASSERT_TRUE(keep_unit(board_files(), stored).has_value());
    Visit visit(usb_, truth);
    const auto homed = visit.run(DeviceAction::home);
    ASSERT_TRUE(homed.has_value()) << homed.error().line;
    const auto settings = read_board_files(board_files());
    ASSERT_TRUE(settings.has_value());
    const UnitSettings* unit = find_unit(*settings, truth.serial);
    ASSERT_NE(unit, nullptr);
    EXPECT_NEAR(unit->calibration.scale, 1.0 / 1.015, 0.006);
    EXPECT_TRUE(unit->calibration.is_measured);
    EXPECT_EQ(unit->calibration.torque_limit_Nm, 0.1);
    EXPECT_EQ(unit->calibration.motors, Plugs{});
    EXPECT_NE(visit.person->heard.back().find("kept in"), std::string::npos);
    EXPECT_EQ(held(visit.board), JointTorques{});
}

}  // namespace
}  // namespace touchline
