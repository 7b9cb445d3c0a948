// A kiosk and its servo as real processes with a fake board, for tests that kill them. No test here
// judges the machine's speed: limits are far off.
#pragma once

#include "config/types/steady_clock.h"
#include "tests/app/force/servo/fake_board.h"
#include "tests/app/force/servo/mapped_file.h"
#include "tests/app/signal_one.h"
#include "tests/app/wait_until.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>

namespace touchline {

inline constexpr std::uint64_t everyday_runs = 2;

class ProcessRig : public testing::Test {
  protected:
    ProcessRig()
        : path_(testing::TempDir() + "board-" + std::to_string(getpid())),
          board_(make_mapped<FakeBoard>(path_)) {
        // Servos of dead kiosks become children of this process.
        prctl(PR_SET_CHILD_SUBREAPER, 1UL, 0UL, 0UL, 0UL);
    }

    ~ProcessRig() override {
        if (kiosk_ != 0) end_kiosk(SIGKILL);
        if (listener_ != 0) signal_one(listener_, SIGKILL);
        if (board_.owner != 0) signal_one(board_.owner, SIGKILL);
        while (waitpid(-1, nullptr, 0) > 0) {
        }
        std::filesystem::remove(path_);
        std::filesystem::remove(words_path());
        std::filesystem::remove(socket_path());
    }

    void start_kiosk();

    /// From now on a kiosk asks for its servo, and this process starts it, as systemd would.
    void start_listener();

    /// Ends the kiosk and returns its status.
    int end_kiosk(int signal) {
        signal_one(kiosk_, signal);
        signal_one(kiosk_, SIGCONT);
        int status = 0;
        waitpid(std::exchange(kiosk_, 0), &status, 0);
        return status;
    }

    /// Returns what kiosk and servo said since the last call.
    [[nodiscard]] std::string new_words() {
        std::ifstream file(words_path());
        const std::string all{std::istreambuf_iterator<char>(file), {}};
        return all.substr(std::min(std::exchange(words_read_, all.size()), all.size()));
    }

    /// Lifts the handle until force is armed, then presses until there is torque; tries again if
    /// the scene came late or force was held off for a moment.
    [[nodiscard]] bool press() {
        for (int i = 0; i < 20 && board_.is_torque_on == 0; ++i) {
            board_.is_pressed = 0;
            if (!wait_for_ticks(800)) return false;
            board_.is_pressed = 1;
            if (!wait_for_ticks(200)) return false;
        }
        return board_.is_torque_on == 1;
    }

    [[nodiscard]] bool wait_for_ticks(std::uint64_t count) {
        const std::uint64_t from = board_.reads;
        return wait_until([&] { return board_.reads > from + count; });
    }

    /// Presses on the servo with this number or a later one until torque is on.
    [[nodiscard]] bool press_on_servo(int number) {
        return wait_until([&] { return board_.opened >= number && board_.reads > 0; }) && press();
    }

    /// Turns torque on, at a moment that the seed chooses; if a servo died, by a new one.
    void be_pressed(std::uint64_t seed) {
        constexpr int most_deaths = 2;  // of servos: after each, a kiosk waits twice as long
        if (kiosk_ != 0 && deaths_ == most_deaths) {
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

    [[nodiscard]] static bool is_there(int process) { return kill(process, 0) == 0; }

    /// Returns the milliseconds from `act` until the torque is zero.
    double ms_to_zero(const std::function<void()>& act) {
        const std::int64_t start_ns = steady_now_ns();
        act();
        EXPECT_TRUE(wait_until([&] { return board_.is_torque_on == 0; }));
        board_.is_pressed = 0;  // above the line when the next scene comes, which decides the side
        return 1e-6 * static_cast<double>(board_.zeroed_ns - start_ns);
    }

    [[nodiscard]] std::string socket_path() const { return path_ + ".socket"; }

    [[nodiscard]] std::string words_path() const { return path_ + ".words"; }

    std::string path_;
    FakeBoard& board_;
    pid_t kiosk_ = 0;
    pid_t listener_ = 0;
    int deaths_ = 0;      // of its servos
    int next_servo_ = 0;  // in the board's count

  private:
    std::size_t words_read_ = 0;
};

}  // namespace touchline
