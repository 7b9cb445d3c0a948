// Tests the driver's libusb half against the emulated board: the library's real code, but no USB in
// the kernel.
#include "haptics/device/board/usb_boards.h"

#include "haptics/device/board/pantograph_board.h"
#include "tests/machines/sim/umockdev/mocked_board.h"
#include "tests/machines/sim/umockdev/usb_rig.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::vector<BoardId> known_boards() {
    return read_boards(TOUCHLINE_SOURCE_DIR "/config/defaults/boards.toml")->boards;
}

constexpr JointTorques push{0.02, -0.02};

class UsbBoardsTest : public testing::Test {
  protected:
    Result<OpenedBoard> try_to_open(std::string_view serial) {
        const auto found = usb_.find(known_, serial);
        if (!found) return tl::unexpected(found.error());
        return usb_.open(*found);
    }

    std::unique_ptr<BoardLink> open(std::string_view serial = "") {
        auto opened = try_to_open(serial);
        EXPECT_TRUE(opened.has_value()) << opened.error().line;
        return opened ? std::move(opened->link) : nullptr;
    }

    std::string error_of_open(std::string_view serial = "") {
        const auto link = try_to_open(serial);
        return link ? "it opened" : link.error().line;
    }

    MockedUsb mocked_;
    std::vector<BoardId> known_ = known_boards();
    UsbBoards usb_ = UsbBoards::create().value();
};

JointTorques held(MockedBoard& board) {
    JointTorques torques;
    board.with([&](BoardEmulator& emulator, UsbFaults&) {
        if (!emulator.told_torques().empty()) torques = emulator.told_torques().back().torques;
    });
    return torques;
}

TEST_F(UsbBoardsTest, WithNoBoardItSaysWhatItLookedFor) {
    EXPECT_TRUE(usb_.list(known_).empty());
    const std::string line = error_of_open();
    EXPECT_EQ(line.rfind("no pantograph's board is plugged in; looked for Haply M0 board (Arduino "
                         "Zero) (2341:804d), Haply M3 board (Arduino Due) (2341:003e), ",
                         0),
              0U)
        << line;
}

TEST_F(UsbBoardsTest, ListsABoardWithSerialNumberAndPlace) {
    MockedBoard board(mocked_, {}, 3);
    const auto found = usb_.list(known_);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].serial, "0123456789ABCDEF0123456789ABCDEF");
    EXPECT_EQ(found[0].bus_path, "1-3");
    EXPECT_EQ(found[0].access, BoardAccess::available);
    EXPECT_EQ(describe(found[0]),
              "Haply M0 board (Arduino Zero) (2341:804d, serial number "
              "0123456789ABCDEF0123456789ABCDEF, at 1-3) is ready to be opened");
    board.with([](BoardEmulator& emulator, UsbFaults&) {
        EXPECT_EQ(emulator.firmware().set_ups(), 0U);  // it was sent nothing
    });
}

TEST_F(UsbBoardsTest, DrivesBothBoardsThroughTheLibrary) {
    for (const char* name : {"2diy-gen3.1", "haplet"}) {
        BoardTruth truth;
        truth.profile = find_profile(name).value();
        truth.type = truth.profile.name == "haplet" ? BoardType::due : BoardType::m0;
        MockedBoard board(mocked_, truth);
        Drive drive(open(), truth.profile);
        const auto opened = drive.driver.open();
        ASSERT_TRUE(opened.has_value()) << opened.error().line;
        ASSERT_TRUE(drive.tick_until_good({}));
        for (int k = 0; k < 100; ++k) (void)drive.tick(push);
        ASSERT_TRUE(drive.tick_until_good(push));
        ASSERT_TRUE(drive.tick_until_good(push));
        EXPECT_LT(norm(held(board) - push), 1e-3) << name;
        board.with([](BoardEmulator& emulator, UsbFaults&) {
            EXPECT_FALSE(emulator.firmware().is_broken());
        });
        EXPECT_TRUE(drive.driver.stop());
        EXPECT_EQ(held(board), JointTorques{});
    }
}

TEST_F(UsbBoardsTest, OfTwoBoardsTheSerialNumberChooses) {
    BoardTruth left, right;
    left.serial = "AAAA";
    right.serial = "BBBB";
    MockedBoard first(mocked_, left, 1);
    MockedBoard second(mocked_, right, 2);
    EXPECT_EQ(
        error_of_open().rfind("more than one board is plugged in: choose one by its serial", 0),
        0U);
    EXPECT_EQ(error_of_open("CCCC").rfind("no board has the serial number CCCC; found Haply M0", 0),
              0U);
    Drive drive(open("BBBB"));
    ASSERT_TRUE(drive.driver.open().has_value());
    first.with([](BoardEmulator& board, UsbFaults&) { EXPECT_EQ(board.firmware().set_ups(), 0U); });
    second.with(
        [](BoardEmulator& board, UsbFaults&) { EXPECT_GT(board.firmware().set_ups(), 0U); });
}

TEST_F(UsbBoardsTest, AUnitsSettingsComeWithItsSerialNumber) {
    BoardTruth truth;
    truth.serial = "AAAA";
    truth.profile = find_profile("2diy-gen2").value();
    MockedBoard board(mocked_, truth);
    BoardSettings settings{known_, {{"AAAA", "2diy-gen2", {}}}};
    settings.units[0].calibration.torque_limit_Nm = 0.05;
    auto taken = take_pantograph(usb_, settings, "", "2diy-gen3.1");
    ASSERT_TRUE(taken.has_value()) << taken.error().line;
    EXPECT_EQ(taken->profile.name, "2diy-gen2");
    EXPECT_EQ(taken->profile.torque_limit_Nm, 0.05);
    EXPECT_EQ(taken->found.serial, "AAAA");
    EXPECT_TRUE(taken->driver->open().has_value());
    taken->driver.reset();
    settings.units.clear();
    EXPECT_EQ(take_pantograph(usb_, settings, "", "2diy-gen3")->profile.name, "2diy-gen3");
    EXPECT_EQ(
        take_pantograph(usb_, settings, "", "none").error().line.rfind("no device profile", 0), 0U);
}

TEST_F(UsbBoardsTest, ABoardThatWentSinceItWasFoundSaysSo) {
    MockedBoard board(mocked_, {});
    const FoundBoard found = usb_.find(known_, "").value();
    board.unplug();
    EXPECT_EQ(usb_.open(found).error().line,
              "Haply M0 board (Arduino Zero) (2341:804d, serial number "
              "0123456789ABCDEF0123456789ABCDEF, at 1-1) is no longer plugged in");
}

TEST_F(UsbBoardsTest, ABoardInItsBootLoaderIsRecognisedAndNotOpened) {
    MockedBoard board(mocked_, {});
    board.with([](BoardEmulator& emulator, UsbFaults&) {
        emulator.set_line_coding(1200);
        emulator.set_lines(false, false);
    });
    board.unplug();
    board.plug();
    ASSERT_EQ(usb_.list(known_).size(), 1U);
    EXPECT_EQ(usb_.list(known_)[0].id.condition, BoardCondition::needs_firmware);
    EXPECT_EQ(error_of_open(),
              "found only Haply M0 board (Arduino Zero) (2341:004d, at 1-1) has no firmware: it "
              "waits to be flashed");
}

TEST_F(UsbBoardsTest, ABoardByItsWrongSocketIsRecognised) {
    const BoardId socket{0x2341, 0x804d, BoardCondition::wrong_socket, false, "Some board"};
    MockedBoard board(mocked_, {});
    const auto found = usb_.list(std::span(&socket, 1));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(describe(found[0]),
              "Some board (2341:804d, at 1-1) is plugged in by its programming socket: use its "
              "other USB socket");
}

TEST_F(UsbBoardsTest, ABoardThatAnotherProgramHoldsIsBusy) {
    MockedBoard board(mocked_, {});
    board.with([](BoardEmulator&, UsbFaults& faults) { faults.is_held = true; });
    EXPECT_EQ(usb_.list(known_).at(0).access, BoardAccess::busy);
    const std::string line = error_of_open();
    EXPECT_NE(line.find(" is in use by another program: close that program"), std::string::npos)
        << line;
    board.with([](BoardEmulator&, UsbFaults& faults) { faults.is_held = false; });
    EXPECT_NE(open(), nullptr);
}

TEST_F(UsbBoardsTest, ABoardThatTheUserMayNotOpenSaysSo) {
    MockedBoard board(mocked_, {});
    const Unprivileged somebody(mocked_.folder() + board.node(), mocked_.folder());
    EXPECT_EQ(usb_.list(known_).at(0).access, BoardAccess::denied);
    EXPECT_EQ(error_of_open(),
              "Haply M0 board (Arduino Zero) (2341:804d, at 1-1) may not be opened by "
              "this user: install the udev rules of Touchline");
}

TEST_F(UsbBoardsTest, UnpluggedInMidTransferIsLostThenFoundUnderAnotherNumber) {
    MockedBoard board(mocked_, {});
    const int number = usb_.list(known_).at(0).device_number;
    {
        Drive drive(open());
        ASSERT_TRUE(drive.driver.open().has_value());
        ASSERT_TRUE(drive.tick_until_good(push));
        board.with([](BoardEmulator&, UsbFaults& faults) { faults.unplug_after_out = 5; });
        for (int k = 0; k < 3000 && drive.driver.report().state != BoardState::lost; ++k)
            (void)drive.tick(push);
        EXPECT_EQ(drive.driver.report().state, BoardState::lost);
        EXPECT_EQ(drive.driver.report().last_failure, LinkStatus::gone);
        EXPECT_FALSE(drive.tick(push).has_value());
        EXPECT_FALSE(drive.is_written);
    }
    EXPECT_EQ(held(board), JointTorques{});
    board.unplug();
    EXPECT_TRUE(usb_.list(known_).empty());
    board.plug();
    ASSERT_EQ(usb_.list(known_).size(), 1U);
    EXPECT_NE(usb_.list(known_)[0].device_number, number);
    Drive drive(open("0123456789ABCDEF0123456789ABCDEF"));
    ASSERT_TRUE(drive.driver.open().has_value());
    EXPECT_TRUE(drive.tick_until_good(push));
}

TEST_F(UsbBoardsTest, ASendThatHangsIsCalledBackAndNothingOfItWasTaken) {
    MockedBoard board(mocked_, {});
    const auto link = open();
    board.with([](BoardEmulator&, UsbFaults& faults) { faults.drops_out = 1; });
    link->cancel_send();  // nothing is under way
    ASSERT_EQ(link->send(write_command({}).bytes()), LinkStatus::done);
    link->rest(0.001);
    EXPECT_EQ(link->sent().status, LinkStatus::under_way);
    link->cancel_send();
    for (int i = 0; i < 100 && link->sent().status == LinkStatus::under_way; ++i) link->rest(0.001);
    EXPECT_EQ(link->sent().status, LinkStatus::timed_out);
    EXPECT_EQ(link->sent().bytes, 0U);
}

TEST_F(UsbBoardsTest, HaltedEndpointsAreClearedBesideTheTicks) {
    MockedBoard board(mocked_, {});
    const auto link = open();
    for (int time = 0; time < 2; ++time) {
        board.with([](BoardEmulator&, UsbFaults& faults) { faults.stalls_out = 1; });
        ASSERT_EQ(link->send(write_command({}).bytes()), LinkStatus::done);
        link->rest(0.005);
        EXPECT_EQ(link->sent().status, LinkStatus::stalled);
        EXPECT_EQ(link->clear_stall(), LinkStatus::under_way) << "it waits for nothing";
        LinkStatus status = LinkStatus::under_way;
        for (int i = 0; i < 1000 && status == LinkStatus::under_way; ++i) {
            link->rest(0.001);
            status = link->clear_stall();
        }
        EXPECT_EQ(status, LinkStatus::done);
        ASSERT_EQ(link->send(write_command({}).bytes()), LinkStatus::done);
        link->rest(0.005);
        EXPECT_EQ(link->sent().status, LinkStatus::done);
    }
}

TEST_F(UsbBoardsTest, AnotherProgramStopsABoardThatWasLeftPulling) {
    MockedBoard board(mocked_, {});
    {
        auto link = open();
        ASSERT_EQ(link->set_lines(true), LinkStatus::done);
        ASSERT_EQ(
            link->send(set_up_command(BoardFrame(default_profile(), {}).set_up_at_home()).bytes()),
            LinkStatus::done);
        link->rest(0.02);
        ASSERT_EQ(link->send(write_command({0.05, 0.05}).bytes()), LinkStatus::done);
        link->rest(0.02);
        // The program dies here without telling the board.
    }
    EXPECT_GT(norm(held(board)), 0.06);
    EXPECT_TRUE(zero_torque(open()));
    EXPECT_EQ(held(board), JointTorques{});
}

}  // namespace
}  // namespace touchline
