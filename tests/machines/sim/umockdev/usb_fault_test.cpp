// Tests every fault that libusb can meet, at moments that seeds choose, through the library's real
// code. In real time: times are reported, but no test depends on the machine's speed.
#include "haptics/device/board/usb_boards.h"
#include "tests/machines/sim/board/fault_run.h"
#include "tests/machines/sim/fault_lines.h"
#include "tests/machines/sim/umockdev/mocked_board.h"
#include "tests/machines/sim/umockdev/usb_rig.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr JointTorques push{0.02, -0.02};
constexpr double late_s = 0.02;
constexpr std::int64_t most_bytes_left = 32768;  // of all runs: what umockdev keeps for a while

struct UsbFaultKind {
    const char* name;
    void (*cause)(BoardEmulator& board, UsbFaults& faults);
    BoardState worst = BoardState::resyncing;
    bool is_replugged = false;  // if not, the driver recovers, or is told the position
};

/// Prints the kind for GoogleTest.
void PrintTo(const UsbFaultKind& kind, std::ostream* out) {
    *out << kind.name;
}

const std::vector<UsbFaultKind> kinds{
    {"short", [](BoardEmulator&, UsbFaults& faults) { faults.short_out = 1; }},
    {"lost send", [](BoardEmulator&, UsbFaults& faults) { faults.drops_out = 1; }},
    {"stall, out", [](BoardEmulator&, UsbFaults& faults) { faults.stalls_out = 1; }},
    {"late reply", [](BoardEmulator&, UsbFaults& faults) { faults.late_in = 1; }},
    {"lost reply", [](BoardEmulator&, UsbFaults& faults) { faults.lost_in = 1; }},
    {"garbled", [](BoardEmulator&, UsbFaults& faults) { faults.garbled_in = 1; }},
    {"duplicate", [](BoardEmulator&, UsbFaults& faults) { faults.doubled_in = 1; }},
    {"zero-length packet", [](BoardEmulator&, UsbFaults& faults) { faults.empty_in = 1; }},
    {"stall, in", [](BoardEmulator&, UsbFaults& faults) { faults.stalls_in = 1; }},
    {"unconfigured",
     [](BoardEmulator& board, UsbFaults&) {
         board.host_sends(std::vector<std::uint8_t>{0, 0});
     }},
    {"encoder jump", [](BoardEmulator& board, UsbFaults&) { board.lose_counts(1, 300); },
     BoardState::jumped},
    {"unplugged, back as another number",
     [](BoardEmulator&, UsbFaults& faults) { faults.unplug_after_out = 3; }, BoardState::lost,
     true},
};

class UsbFault : public testing::TestWithParam<UsbFaultKind> {
  protected:
    std::unique_ptr<BoardLink> open() {
        const auto found = usb_.find(known_, "");
        auto opened =
            found ? usb_.open(*found) : Result<OpenedBoard>(tl::unexpected(found.error()));
        EXPECT_TRUE(opened.has_value()) << opened.error().line;
        return opened ? std::move(opened->link) : nullptr;
    }

    void connect() {
        drive_.reset();
        drive_.emplace(open());
        ASSERT_TRUE(drive_->driver.open().has_value());
    }

    double board_time_s() {
        double now_s = 0.0;
        board_.with([&](BoardEmulator& board, UsbFaults&) { now_s = board.now_s(); });
        return now_s;
    }

    /// Returns the time from a moment to zero torque; nothing if torque went on.
    std::optional<double> zero_after(double from_s) {
        std::optional<double> span_s;
        board_.with([&](BoardEmulator& board, UsbFaults&) {
            span_s = time_to_zero(board.told_torques(), from_s);
        });
        return span_s;
    }

    /// Does `ticks` ticks, and more while the driver recovers: on a busy machine the reply before
    /// the fault may be late, and the lost send is then the zero that followed. Returns the worst
    /// state.
    BoardState tick_and_watch(int ticks) {
        constexpr int most_more = 200;
        BoardState worst = BoardState::ready;
        BoardState state = BoardState::ready;
        for (int k = 0; k < ticks || (state == BoardState::resyncing && k < ticks + most_more);
             ++k) {
            (void)drive_->tick(push);
            state = drive_->driver.report().state;
            is_doubtful_ = is_doubtful_ || drive_->driver.report().is_position_doubtful;
            worst = std::max(worst, state);
            if (state == BoardState::lost || state == BoardState::jumped) break;
        }
        return worst;
    }

    void recover(const UsbFaultKind& kind) {
        if (kind.worst == BoardState::jumped) drive_->driver.accept_position();
        if (!kind.is_replugged) return;
        const int number = board_.device_number();
        drive_.reset();
        board_.unplug();
        board_.plug();
        EXPECT_NE(board_.device_number(), number);
        connect();
    }

    MockedUsb mocked_;
    MockedBoard board_{mocked_, {}};
    std::vector<BoardId> known_ =
        read_boards(TOUCHLINE_SOURCE_DIR "/config/defaults/boards.toml")->boards;
    UsbBoards usb_ = UsbBoards::create().value();
    std::optional<Drive> drive_;
    bool is_doubtful_ = false;
};

TEST_P(UsbFault, EndsInZeroTorqueAndFindsBack) {
    const UsbFaultKind kind = GetParam();
    connect();
    Holdings before;
    for (std::uint64_t seed = 0; seed < fault_runs(5); ++seed) {
        SCOPED_TRACE(std::string(kind.name) + ", seed " + std::to_string(seed));
        std::mt19937_64 random(seed);
        if (drive_->driver.report().is_position_doubtful) drive_->driver.accept_position();
        is_doubtful_ = false;
        ASSERT_TRUE(drive_->tick_until_good(push));
        for (std::uint64_t k = random() % 10; k > 0; --k) (void)drive_->tick(push);
        if (seed == 0) before = Holdings::now(Sockets::left_out);
        const Holdings now = Holdings::now(Sockets::left_out);
        const double from_s = board_time_s();
        board_.with([&](BoardEmulator& board, UsbFaults& faults) {
            faults.late_s = late_s;
            kind.cause(board, faults);
        });
        const BoardState worst = tick_and_watch(40);
        const auto zero_s = zero_after(from_s);
        recover(kind);
        ASSERT_TRUE(drive_->tick_until_good(push));
        const double back_s = board_time_s() - from_s;
        const bool is_back_by_itself = kind.worst == BoardState::resyncing;
        tell({"libusb", kind.name, seed, zero_s, words_of(worst, is_doubtful_), back_s,
              is_back_by_itself, Holdings::now(Sockets::left_out) - now});
        EXPECT_LE(worst, kind.worst);
        EXPECT_TRUE(zero_s.has_value() || worst == BoardState::ready);
    }
    const Holdings left = Holdings::now(Sockets::left_out) - before;
    EXPECT_EQ(left.descriptors, 0);
    EXPECT_LT(left.bytes, most_bytes_left);
    board_.with(
        [](BoardEmulator& board, UsbFaults&) { EXPECT_FALSE(board.firmware().is_broken()); });
    EXPECT_TRUE(drive_->driver.stop());
    board_.with([](BoardEmulator& board, UsbFaults&) {
        EXPECT_EQ(board.told_torques().back().torques, JointTorques{});
    });
}

INSTANTIATE_TEST_SUITE_P(Every, UsbFault, testing::ValuesIn(kinds),
                         [](const auto& kind) { return test_name(kind.param.name); });

/// Tries a board that cannot be opened again and again: one line says why, and once it is free it
/// opens.
class UsbRefusal : public UsbFault {
  protected:
    /// Opens as another program, which umockdev may leak descriptors in when it is refused.
    std::string refusal() {
        std::array<int, 2> ends{};
        EXPECT_EQ(pipe(ends.data()), 0);
        const pid_t child = fork();
        if (child == 0) {
            const std::string line = line_of_open();
            _exit(write(ends[1], line.data(), line.size()) < 0 ? 1 : 0);
        }
        close(ends[1]);
        std::array<char, 1000> line{};
        const ssize_t size = read(ends[0], line.data(), line.size());
        close(ends[0]);
        EXPECT_EQ(waitpid(child, nullptr, 0), child);
        return {line.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
    }

    void refuse_often(const char* fault, const char* words,
                      const std::function<std::string()>& refused) {
        (void)refused();  // makes what all runs share
        const int descriptors = open_descriptors(getpid(), Sockets::left_out);
        for (std::uint64_t seed = 0; seed < fault_runs(5); ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            const double from_s = board_time_s();
            const std::string line = refused();
            EXPECT_NE(line.find(words), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos);
            connect();
            EXPECT_TRUE(drive_->tick_until_good(push));
            drive_.reset();
            FaultLine told{"libusb", fault, seed, {}, std::string("refused: ") + words,
                           {},       true,  {}};
            told.back_s = board_time_s() - from_s;
            tell(told);
        }
        // umockdev's own thread closes what it opened at any time.
        for (int i = 0; i < 5000; ++i) {
            if (open_descriptors(getpid(), Sockets::left_out) <= descriptors) return;
            poll(nullptr, 0, 1);
        }
        ADD_FAILURE() << "descriptors are left";
    }

  private:
    std::string line_of_open() {
        const UsbBoards usb = UsbBoards::create().value();
        const auto found = usb.find(known_, "");
        if (!found) return found.error().line;
        const auto link = usb.open(*found);
        return link ? "it opened" : link.error().line;
    }
};

TEST_F(UsbRefusal, ABusyBoardIsSaidAndOpensOnceItIsFree) {
    refuse_often("device busy", "in use by another program", [this] {
        board_.with([](BoardEmulator&, UsbFaults& faults) { faults.is_held = true; });
        const std::string line = refusal();
        board_.with([](BoardEmulator&, UsbFaults& faults) { faults.is_held = false; });
        return line;
    });
}

TEST_F(UsbRefusal, ADeniedBoardIsSaidAndOpensOnceItIsAllowed) {
    refuse_often("permission denied", "may not be opened by this user", [this] {
        const Unprivileged somebody(mocked_.folder() + board_.node(), mocked_.folder());
        return refusal();
    });
}

}  // namespace
}  // namespace touchline
