// Tests what real processes of kiosk and servo must not even notice: a full disk, a step of the
// wall clock.
#include "tests/app/force/servo/process_rig.h"
#include "tests/app/force/servo/stepped_clock.h"
#include "tests/app/signal_one.h"
#include "tests/machines/sim/fault_lines.h"

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace touchline {
namespace {

/// These must not interrupt the force at all. A machine that stands still for 10 ms interrupts it
/// too, by other rules; such a run is repeated.
class Harmless : public ProcessRig {
  protected:
    void run_each_seed(const std::function<bool(std::uint64_t)>& keeps_torque) {
        constexpr int most_tries = 5;
        for (std::uint64_t seed = 0; seed < fault_runs(everyday_runs); ++seed) {
            SCOPED_TRACE("seed " + std::to_string(seed));
            int tries = 0;
            do {
                // A hand that rests for 20 s counts as off the handle: it presses anew each time.
                board_.is_pressed = 0;
                EXPECT_TRUE(wait_until([&] { return board_.is_torque_on == 0; }));
                ASSERT_NO_FATAL_FAILURE(be_pressed(seed));
            } while (!keeps_torque(seed) && ++tries < most_tries);
            EXPECT_LT(tries, most_tries);
        }
    }

    /// Returns true if torque was on and never went to zero meanwhile.
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

    /// Lets the servo write so many bytes into a file and no more, as on a nearly full disk.
    void leave_bytes(rlim_t bytes) {
        const rlimit limit{bytes, RLIM_INFINITY};
        (void)prlimit(board_.owner, RLIMIT_FSIZE, &limit, nullptr);
    }

    /// Asks for a recording and returns what is said about it.
    std::string words_of_recording() {
        std::string words;
        signal_one(kiosk_, SIGUSR1);
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
        if (!wait_for_ticks(100)) return false;  // more to keep than there is room for
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

TEST_F(Harmless, AStepOfTheWallClockIsNoticedByNobody) {
    const std::string path = path_ + ".clock";
    SteppedClock& clock = make_mapped<SteppedClock>(path);
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
        EXPECT_EQ(clock.reads, reads);  // neither guard nor servo read the wall clock
        tell({"processes", "clock step", seed, {}, "force goes on", {}, true, {}});
        return true;
    });
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
    std::filesystem::remove(path);
}

/// Otherwise the test before proves nothing.
TEST_F(Harmless, TheSteppedClockIsTheOneThatAProgramSees) {
    const std::string path = path_ + ".clock";
    SteppedClock& clock = make_mapped<SteppedClock>(path);
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
