// Tests kiosk, servo and board as three processes, with the board behind a USB file: the servo is
// killed or frozen with torque on, and the board must soon be at zero. The guard has the servo's
// own descriptor. A few runs every day report their times; with TOUCHLINE_EXHAUSTIVE set there are
// 200 of each, at rest and beside other work, judged by 20 ms.
#include "app/force/device/board_files.h"
#include "app/force/servo/usb_search.h"
#include "app/isolation/process/child.h"
#include "config/types/pinned.h"
#include "tests/app/signal_one.h"
#include "tests/app/wait_until.h"
#include "tests/machines/sim/board/board_rig.h"
#include "tests/machines/sim/fault_lines.h"
#include "tests/machines/sim/umockdev/mocked_board.h"
#include "tests/machines/sim/usbfs/usb_node_server.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>

namespace touchline {
namespace {

constexpr double longest_zero_ms = 20.0;
constexpr int device_number = 2;
constexpr int busy_programs = 4;
constexpr int time_to_open_ms = 1500;  // far longer than a servo takes to its first write

struct Death {
    const char* name;
    int signal;
    bool is_busy;  // the machine has other work
};

/// Prints the death for GoogleTest.
void PrintTo(const Death& death, std::ostream* out) {
    *out << death.name;
}

/// While it lives, programs take all the processor time they can get.
class OtherWork : private Pinned {
  public:
    explicit OtherWork(int programs) {
        for (int i = 0; i < programs; ++i) {
            const pid_t child = fork();
            if (child == 0) {
                prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGKILL), 0UL, 0UL, 0UL);
                for (volatile bool works = true; works;) {
                }
            }
            children_.push_back(child);
        }
    }

    ~OtherWork() {
        for (const pid_t child : children_) {
            signal_one(child, SIGKILL);
            waitpid(child, nullptr, 0);
        }
    }

  private:
    std::vector<pid_t> children_;
};

class SharedNode : public testing::TestWithParam<Death> {
  protected:
    SharedNode() {
        mocked_.show(BoardEmulator({}, resting_hand(default_profile())), 1, device_number);
        board_ = UsbNodeServer::create(mocked_.folder() + MockedUsb::node_of(device_number), {});
    }

    void SetUp() override { ASSERT_NE(board_, nullptr) << "a file system could not be mounted"; }

    ~SharedNode() override { end_kiosk(); }

    void start_kiosk() {
        UsbDevice device = find_usb_device(read_board_files(board_files()).value()).value().value();
        device.is_homed_first = false;  // the test's hand rests at home
        device.profile = default_profile().name;
        std::vector<std::string> words{"usb-kiosk"};
        for (const std::string& word : arguments_of(device)) words.push_back(word);
        const std::string before = "LD_PRELOAD=" TOUCHLINE_REAL_NODE_LIBRARY ":";
        kiosk_ = std::make_unique<Child>(Child::start(TOUCHLINE_SERVO_RIG, words, {},
                                                      StandardStreams::ours,
                                                      {before + std::getenv("LD_PRELOAD")})
                                             .value());
    }

    void end_kiosk() {
        if (!kiosk_) return;
        kiosk_->kill();
        (void)kiosk_->reap();
        kiosk_.reset();
    }

    [[nodiscard]] JointTorques held() {
        JointTorques torques;
        board_->with([&](BoardEmulator& board, UsbFaults&) {
            if (!board.told_torques().empty()) torques = board.told_torques().back().torques;
        });
        return torques;
    }

    /// Returns the servo: the only child of the kiosk's guard.
    [[nodiscard]] pid_t servo() {
        const std::string tasks = "/proc/" + std::to_string(kiosk_->pid()) + "/task";
        for (const auto& task : std::filesystem::directory_iterator(tasks)) {
            std::ifstream children(task.path() / "children");
            if (pid_t child = 0; children >> child) return child;
        }
        return 0;
    }

    [[nodiscard]] std::uint64_t set_ups() {
        std::uint64_t count = 0;
        board_->with([&](BoardEmulator& board, UsbFaults&) { count = board.firmware().set_ups(); });
        return count;
    }

    /// Sends the signal and returns the board's time. No time passes between reading the clock and
    /// the signal.
    [[nodiscard]] double end_servo(int signal) {
        const pid_t pid = servo();
        double now_s = 0.0;
        std::thread([&] {
            become_hardware();
            board_->with([&](BoardEmulator& board, UsbFaults&) { now_s = board.now_s(); });
            signal_one(pid, signal);
        }).join();
        return now_s;
    }

    MockedUsb mocked_;
    std::unique_ptr<UsbNodeServer> board_;
    std::unique_ptr<Child> kiosk_;  // a pointer, since GCC 14 takes a Child in an optional for
                                    // uninitialised
};

TEST_P(SharedNode, IsZeroedByTheGuardAtOnce) {
    const Death death = GetParam();
    const std::uint64_t runs = fault_runs(2, 200);
    const bool is_judged = runs > 2;
    const OtherWork work(death.is_busy ? busy_programs : 0);
    std::vector<double> zero_ms;
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
        start_kiosk();
        ASSERT_TRUE(wait_until([&] { return held() != JointTorques{}; }));
        poll(nullptr, 0, static_cast<int>(seed % 7));
        const double from_s = end_servo(death.signal);
        ASSERT_TRUE(wait_until([&] { return held() == JointTorques{}; }));
        board_->with([&](BoardEmulator& board, UsbFaults&) {
            zero_ms.push_back(1e3 * (board.told_torques().back().at_s - from_s));
            board.forget_told_torques();
        });
        tell({"usb", death.name, seed, 1e-3 * zero_ms.back(), "the servo ended", {}, false, {}});
        end_kiosk();
    }
    std::sort(zero_ms.begin(), zero_ms.end());
    std::printf("zero after %.2f ms, at worst %.2f, of %zu\n", zero_ms[zero_ms.size() / 2],
                zero_ms.back(), zero_ms.size());
    EXPECT_TRUE(!is_judged || zero_ms.back() <= longest_zero_ms);
}

/// Neither homed nor set up: it counts on.
TEST_P(SharedNode, IsTakenOverByTheNextServo) {
    const Death death = GetParam();
    const OtherWork work(death.is_busy ? busy_programs : 0);
    start_kiosk();
    ASSERT_TRUE(wait_until([&] { return held() != JointTorques{}; }));
    const pid_t before = servo();
    const std::uint64_t set_ups = this->set_ups();
    (void)end_servo(death.signal);
    ASSERT_TRUE(wait_until([&] { return servo() != 0 && servo() != before; }));
    poll(nullptr, 0, time_to_open_ms);
    EXPECT_EQ(this->set_ups(), set_ups);
}

INSTANTIATE_TEST_SUITE_P(Every, SharedNode,
                         testing::Values(Death{"servo killed", SIGKILL, false},
                                         Death{"servo frozen", SIGSTOP, false},
                                         Death{"servo killed beside other work", SIGKILL, true},
                                         Death{"servo frozen beside other work", SIGSTOP, true}),
                         [](const auto& each) { return test_name(each.param.name); });

}  // namespace
}  // namespace touchline
