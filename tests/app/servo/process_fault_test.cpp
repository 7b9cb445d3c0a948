// Kiosk and servo as real processes, killed, frozen, crashed, out of disk and out of time: zero
// torque where it must be, none lost where not, the way back, nothing left behind. The times are
// told, not judged; the rules are tested on a virtual clock (tests/sim/loop).
#include "tests/app/servo/process_rig.h"
#include "tests/app/servo/stepped_clock.h"
#include "tests/sim/fault_lines.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace touchline {
namespace {

constexpr double far_away_ms = 5000.0;
constexpr int deaths_of_a_kiosk = 2;  // of its servos: after each it waits twice as long
constexpr std::uint64_t everyday = 2;
constexpr std::array crash_signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU};
constexpr std::array crashes{Mischief::write_nowhere, Mischief::throw_something};

/// How a fault of the processes ends.
enum class Ends { kiosk, servo, neither };

struct ProcessFaultKind {
    const char* name;
    Ends ends;
    void (*act)(FakeBoard& board, pid_t kiosk, std::uint64_t seed);
    const char* words;                                 // that the operator is told
    std::atomic<int> FakeBoard::*zeroed_by = nullptr;  // who did, besides the loop
};

const std::vector<ProcessFaultKind> kinds{
    {"kiosk killed", Ends::kiosk,
     [](FakeBoard&, pid_t kiosk, std::uint64_t) { kill(kiosk, SIGKILL); }, ""},
    {"kiosk crashed", Ends::kiosk,
     [](FakeBoard&, pid_t kiosk, std::uint64_t) { kill(kiosk, SIGSEGV); }, ""},
    {"kiosk frozen", Ends::neither,
     [](FakeBoard&, pid_t kiosk, std::uint64_t) { kill(kiosk, SIGSTOP); }, ""},
    {"kiosk's main thread hangs", Ends::neither,
     [](FakeBoard&, pid_t kiosk, std::uint64_t) { kill(kiosk, SIGUSR2); }, ""},
    {"servo killed", Ends::servo,
     [](FakeBoard& board, pid_t, std::uint64_t) { kill(board.owner, SIGKILL); },
     "the servo ended with signal", &FakeBoard::zeroed_by_guard},
    {"servo frozen", Ends::servo,
     [](FakeBoard& board, pid_t, std::uint64_t) { kill(board.owner, SIGSTOP); },
     "the servo ended with signal", &FakeBoard::zeroed_by_guard},
    {"servo crashed beside its loop", Ends::servo,
     [](FakeBoard& board, pid_t, std::uint64_t seed) {
         kill(board.owner, crash_signals[seed % crash_signals.size()]);
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
     [](FakeBoard& board, pid_t, std::uint64_t) { kill(board.owner, SIGTERM); }, ""},
};

class ProcessFault : public ProcessRig {
  protected:
    /// Torque is on, by a servo that was not there before; at a moment that the seed chooses.
    void be_pressed(std::uint64_t seed) {
        if (kiosk_ != 0 && deaths_ == deaths_of_a_kiosk) {
            EXPECT_EQ(end_kiosk(SIGTERM), 0);
        }
        if (kiosk_ == 0) {
            deaths_ = 0;
            next_servo_ = board_.opened + 1;
            start_kiosk();
        }
        ASSERT_TRUE(press_on_servo(next_servo_));
        std::mt19937_64 random(seed);
        (void)wait_for_ticks(random() % 20);
        ASSERT_TRUE(press());
    }

    /// Neither children nor descriptors are left of what died.
    void bury_servo(int servo) {
        int status = 0;
        EXPECT_EQ(waitpid(servo, &status, 0), servo);
        EXPECT_EQ(status, 0);
        EXPECT_EQ(waitpid(-1, &status, WNOHANG), -1);
    }

    [[nodiscard]] bool is_there(int process) const { return kill(process, 0) == 0; }

    int deaths_ = 0;
    int next_servo_ = 0;
};

class EveryProcessFault : public ProcessFault,
                          public testing::WithParamInterface<ProcessFaultKind> {
  protected:
    /// What the dead leave to be done, and torque again.
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
            EXPECT_FALSE(is_there(servo));  // no zombie either
        } else {
            kill(kiosk_, SIGCONT);
        }
    }

    int opened_before_ = 0;
};

TEST_P(EveryProcessFault, EndsInZeroTorqueAndFindsBack) {
    const ProcessFaultKind kind = GetParam();
    int descriptors = 0;
    for (std::uint64_t seed = 0; seed < fault_runs(everyday); ++seed) {
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

INSTANTIATE_TEST_SUITE_P(Each, EveryProcessFault, testing::ValuesIn(kinds), [](const auto& kind) {
    std::string name(kind.param.name);
    const auto is_other = [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); };
    std::replace_if(name.begin(), name.end(), is_other, '_');
    return name;
});

/// What must not cost the force at all. A machine that stands still for 10 ms costs it too, by
/// other rules: such a run is done again.
class Harmless : public ProcessFault {
  protected:
    void run_each_seed(const std::function<bool(std::uint64_t)>& keeps_torque) {
        constexpr int most_tries = 5;
        for (std::uint64_t seed = 0; seed < fault_runs(everyday); ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            int tries = 0;
            do {
                // A hand that rests for 20 s is taken to be off: it presses anew each time.
                board_.is_pressed = 0;
                EXPECT_TRUE(wait_until([&] { return board_.is_torque_on == 0; }));
                ASSERT_NO_FATAL_FAILURE(be_pressed(seed));
            } while (!keeps_torque(seed) && ++tries < most_tries);
            EXPECT_LT(tries, most_tries);
        }
    }

    /// It was on before, and went to zero at no time meanwhile.
    [[nodiscard]] bool is_torque_kept(const std::function<void()>& meanwhile) {
        const std::int64_t zeroed_ns = board_.zeroed_ns;
        meanwhile();
        return board_.is_torque_on == 1 && board_.zeroed_ns == zeroed_ns;
    }
};

class FullDisk : public Harmless {
  protected:
    FullDisk() { setenv("TOUCHLINE_RECORDINGS", folder_.c_str(), 1); }

    ~FullDisk() override {
        unsetenv("TOUCHLINE_RECORDINGS");
        std::filesystem::remove_all(folder_);
    }

    /// The servo may write so many bytes into a file and no more, as on a disk with that much left.
    void leave_bytes(rlim_t bytes) {
        const rlimit limit{bytes, RLIM_INFINITY};
        (void)prlimit(board_.owner, RLIMIT_FSIZE, &limit, nullptr);
    }

    /// Asks for a recording; what is said of it.
    std::string words_of_recording() {
        std::string words;
        kill(kiosk_, SIGUSR1);
        EXPECT_TRUE(wait_until([&] { return !(words += new_words()).empty(); }));
        return words;
    }

    [[nodiscard]] int files() const {
        std::error_code error;
        int count = 0;
        for (std::filesystem::directory_iterator entry(folder_, error);
             !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
            ++count;
        return count;
    }

    [[nodiscard]] bool fails_and_goes_on(std::uint64_t seed) {
        std::mt19937_64 random(seed);
        const int servo = board_.owner;
        const int descriptors = open_descriptors(servo);
        const std::int64_t from_ns = steady_now_ns();
        std::string words;
        if (!wait_for_ticks(100)) return false;  // more to be kept than there is room for
        (void)new_words();
        leave_bytes(random() % 10'000);
        if (!is_torque_kept([&] { words = words_of_recording(); })) return false;
        EXPECT_NE(words.find("is the disk full?"), std::string::npos) << words;
        EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
        EXPECT_EQ(files(), 0);
        leave_bytes(RLIM_INFINITY);
        if (!is_torque_kept([&] { words = words_of_recording(); })) return false;
        EXPECT_NE(words.find("a recording was kept"), std::string::npos) << words;
        EXPECT_EQ(files(), 1);
        FaultLine line{"processes", "disk full", seed, {}, "force goes on", {}, true, {}};
        line.state += ", no recording is kept: is the disk full?";
        line.back_s = 1e-9 * static_cast<double>(steady_now_ns() - from_ns);
        line.left.descriptors = open_descriptors(servo) - descriptors;
        EXPECT_EQ(line.left.descriptors, 0);
        tell(line);
        return true;
    }

    std::string folder_ = path_ + ".recordings";
};

TEST_F(FullDisk, CostsTheRecordingAndNothingElse) {
    run_each_seed([&](std::uint64_t seed) {
        std::filesystem::remove_all(folder_);
        return fails_and_goes_on(seed);
    });
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
}

/// Maps a file of zeros.
SteppedClock& make_clock(const std::string& path) {
    std::ofstream(path, std::ios::binary)
        .write(std::string(sizeof(SteppedClock), '\0').data(), sizeof(SteppedClock));
    const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
    void* const start =
        mmap(nullptr, sizeof(SteppedClock), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file < 0 || start == MAP_FAILED) std::abort();
    close(file);
    return *static_cast<SteppedClock*>(start);
}

TEST_F(Harmless, AStepOfTheWallClockIsNoticedByNobody) {
    const std::string path = path_ + ".clock";
    SteppedClock& clock = make_clock(path);
    setenv("LD_PRELOAD", TOUCHLINE_STEPPED_CLOCK_LIBRARY, 1);
    setenv(stepped_clock_variable, path.c_str(), 1);
    next_servo_ = 1;
    start_kiosk();
    unsetenv("LD_PRELOAD");
    run_each_seed([&](std::uint64_t seed) {
        std::mt19937_64 random(seed);
        constexpr std::int64_t year_s = 31'536'000;
        const std::uint64_t reads = clock.reads;
        const bool is_kept = is_torque_kept([&] {
            clock.step_ns = 1'000'000'000 * std::uniform_int_distribution(-year_s, year_s)(random);
            EXPECT_TRUE(wait_for_ticks(100));
        });
        if (!is_kept) return false;
        EXPECT_EQ(clock.reads, reads);  // neither guard nor servo asked what time it is
        tell({"processes", "clock step", seed, {}, "force goes on", {}, true, {}});
        return true;
    });
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
    std::filesystem::remove(path);
}

/// Or the test before proves nothing.
TEST_F(Harmless, TheSteppedClockIsTheOneThatAProgramSees) {
    const std::string path = path_ + ".clock";
    SteppedClock& clock = make_clock(path);
    clock.step_ns = -1'000'000'000'000'000'000;
    setenv(stepped_clock_variable, path.c_str(), 1);
    const std::string command = std::string("test $(LD_PRELOAD=") +
                                TOUCHLINE_STEPPED_CLOCK_LIBRARY + " date +%s) -lt 1000000000";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_GT(clock.reads, 0U);
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace touchline
