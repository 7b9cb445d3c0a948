// Tests kiosk and servo as real processes that are killed, frozen and crashed: zero torque, what is
// said, the way back, nothing left behind. Times are reported but not judged;
// tests/machines/sim/loop tests the rules on a virtual clock.
#include "tests/app/force/servo/process_rig.h"
#include "tests/app/signal_one.h"
#include "tests/machines/sim/fault_lines.h"

#include <array>
#include <atomic>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double far_away_ms = 5000.0;
constexpr std::array crash_signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU};
constexpr std::array crashes{Mischief::write_nowhere, Mischief::throw_something};

/// Which process a fault ends.
enum class Ends { kiosk, servo, neither };

struct ProcessFaultKind {
    const char* name;
    Ends ends;
    void (*act)(FakeBoard& board, pid_t kiosk, std::uint64_t seed);
    const char* words;                                 // what the operator is told
    std::atomic<int> FakeBoard::*zeroed_by = nullptr;  // who zeroed it, besides the loop
};

/// Prints the kind for GoogleTest.
void PrintTo(const ProcessFaultKind& kind, std::ostream* out) {
    *out << kind.name;
}

const std::vector<ProcessFaultKind> kinds{
    {"kiosk killed", Ends::kiosk,
     [](FakeBoard&, pid_t kiosk, std::uint64_t) { signal_one(kiosk, SIGKILL); }, ""},
    {"kiosk crashed", Ends::kiosk,
     [](FakeBoard&, pid_t kiosk, std::uint64_t) { signal_one(kiosk, SIGSEGV); }, ""},
    {"kiosk frozen", Ends::neither,
     [](FakeBoard&, pid_t kiosk, std::uint64_t) { signal_one(kiosk, SIGSTOP); }, ""},
    {"kiosk's main thread hangs", Ends::neither,
     [](FakeBoard&, pid_t kiosk, std::uint64_t) { signal_one(kiosk, SIGUSR2); }, ""},
    {"servo killed", Ends::servo,
     [](FakeBoard& board, pid_t, std::uint64_t) { signal_one(board.owner, SIGKILL); },
     "the servo ended with signal", &FakeBoard::zeroed_by_guard},
    {"servo frozen", Ends::servo,
     [](FakeBoard& board, pid_t, std::uint64_t) { signal_one(board.owner, SIGSTOP); },
     "the servo ended with signal", &FakeBoard::zeroed_by_guard},
    {"servo crashed beside its loop", Ends::servo,
     [](FakeBoard& board, pid_t, std::uint64_t seed) {
         signal_one(board.owner, crash_signals[seed % crash_signals.size()]);
     },
     "the servo ended with signal", &FakeBoard::zeroed_by_handler},
    {"the loop itself crashed", Ends::servo,
     [](FakeBoard& board, pid_t, std::uint64_t seed) {
         board.mischief = crashes[seed % crashes.size()];
     },
     "the servo ended with signal", &FakeBoard::zeroed_by_guard},
    {"the loop hangs", Ends::servo,
     [](FakeBoard& board, pid_t, std::uint64_t) { board.mischief = Mischief::spin; },
     "the servo ended with signal", &FakeBoard::zeroed_by_guard},
    {"servo asked to end", Ends::servo,
     [](FakeBoard& board, pid_t, std::uint64_t) { signal_one(board.owner, SIGTERM); }, ""},
};

class ProcessFault : public ProcessRig, public testing::WithParamInterface<ProcessFaultKind> {
  protected:
    /// Expects the servo to have ended well, and no other child to be left.
    void bury_servo(int servo) {
        int status = 0;
        EXPECT_EQ(waitpid(servo, &status, 0), servo);
        EXPECT_EQ(status, 0);
        EXPECT_EQ(waitpid(-1, &status, WNOHANG), -1);
    }

    /// Reaps the dead and waits for the next servo, or lets the kiosk go on.
    void recover(const ProcessFaultKind& kind, int servo) {
        if (kind.ends == Ends::kiosk) {
            int status = 0;
            EXPECT_EQ(waitpid(std::exchange(kiosk_, 0), &status, 0) > 0 && WIFSIGNALED(status),
                      true);
            bury_servo(servo);
        } else if (kind.ends == Ends::servo) {
            ++deaths_;
            next_servo_ = opened_before_ + 1;
            EXPECT_TRUE(wait_until([&] { return board_.opened > opened_before_; }));
            EXPECT_FALSE(is_there(servo));  // not even a zombie
        } else {
            signal_one(kiosk_, SIGCONT);
        }
    }

    int opened_before_ = 0;
};

TEST_P(ProcessFault, EndsInZeroTorqueAndFindsBack) {
    const ProcessFaultKind kind = GetParam();
    int descriptors = 0;
    for (std::uint64_t seed = 0; seed < fault_runs(everyday_runs); ++seed) {
        SCOPED_TRACE(std::string(kind.name) + ", seed " + std::to_string(seed));
        ASSERT_NO_FATAL_FAILURE(be_pressed(seed));
        if (kind.ends == Ends::kiosk || deaths_ == 0) descriptors = open_descriptors(kiosk_);
        (void)new_words();
        const int servo = board_.owner;
        opened_before_ = board_.opened;
        const int zeroed = kind.zeroed_by != nullptr ? (board_.*kind.zeroed_by).load() : 0;
        const std::int64_t from_ns = steady_now_ns();
        const double zero_ms = ms_to_zero([&] { kind.act(board_, kiosk_, seed); });
        EXPECT_LT(zero_ms, far_away_ms);
        const bool has_words = *kind.words != '\0';
        std::string words;
        EXPECT_TRUE(!has_words || wait_until([&] {
            return (words += new_words()).find(kind.words) != std::string::npos;
        })) << words;
        EXPECT_TRUE(kind.zeroed_by == nullptr ||
                    wait_until([&] { return board_.*kind.zeroed_by > zeroed; }));
        recover(kind, servo);
        ASSERT_NO_FATAL_FAILURE(be_pressed(seed));
        FaultLine line{"processes", kind.name, seed, {}, {}, {}, kind.ends != Ends::kiosk, {}};
        line.zero_s = 1e-3 * zero_ms;
        line.back_s = 1e-9 * static_cast<double>(steady_now_ns() - from_ns);
        line.state = has_words ? "the servo ended and was started again" : "no force for a while";
        if (deaths_ > 0 || kind.ends == Ends::neither)
            line.left.descriptors = open_descriptors(kiosk_) - descriptors;
        EXPECT_EQ(line.left.descriptors, 0);
        tell(line);
    }
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
    EXPECT_EQ(board_.is_torque_on, 0);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
}

INSTANTIATE_TEST_SUITE_P(Every, ProcessFault, testing::ValuesIn(kinds),
                         [](const auto& kind) { return test_name(kind.param.name); });

}  // namespace
}  // namespace touchline
