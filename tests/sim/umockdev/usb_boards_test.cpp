// The driver's libusb half against the emulated board: the library's real code, no USB in the
// kernel.
#include "haptics/device/usb_boards.h"

#include "haptics/device/pantograph_board.h"
#include "tests/sim/umockdev/mocked_board.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::vector<BoardId> known_boards() {
    return read_boards(std::string(TOUCHLINE_SOURCE_DIR) + "/config/defaults/boards.toml")->boards;
}

class UsbBoardsTest : public testing::Test {
  protected:
    MockedUsb mocked_;
    std::vector<BoardId> known_ = known_boards();
};

TEST_F(UsbBoardsTest, WithNoBoardItSaysWhatItLookedFor) {
    const auto usb = UsbBoards::create();
    ASSERT_TRUE(usb.has_value()) << usb.error().line;
    EXPECT_TRUE(usb->list(known_).empty());
    const std::string line = usb->open(known_, "").error().line;
    EXPECT_EQ(line.rfind("no pantograph's board is plugged in; looked for Haply M0 board (Arduino "
                         "Zero) (2341:804d), ",
                         0),
              0U)
        << line;
}

TEST_F(UsbBoardsTest, OpensHomesAndDrivesTheBoard) {
    MockedBoard board(mocked_, {});
    const auto usb = UsbBoards::create();
    const auto found = usb->list(known_);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].serial, "0123456789ABCDEF0123456789ABCDEF");
    EXPECT_EQ(found[0].bus_path, "1-1");
    EXPECT_EQ(found[0].access, BoardAccess::available);
    auto link = usb->open(known_, "");
    ASSERT_TRUE(link.has_value()) << link.error().line;
    PantographBoard driver(std::move(*link), default_profile(), {});
    const auto opened = driver.open();
    ASSERT_TRUE(opened.has_value()) << opened.error().line;
    EXPECT_EQ(driver.report().state, BoardState::ready);
}

}  // namespace
}  // namespace touchline
