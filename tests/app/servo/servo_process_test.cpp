// Real processes, killed in every way. Nothing here judges how fast the machine is: the times are
// told, and the limits are far away. The rules themselves are tested on a virtual clock
// (tests/haptics/servo/loop_rules_test.cpp).
#include "app/process/child.h"
#include "app/servo/messages.h"
#include "app/servo/shared_region.h"
#include "config/types/map_bytes.h"
#include "tests/app/servo/fake_board.h"

#include <cstdio>
#include <filesystem>
#include <functional>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>

namespace touchline {
namespace {

constexpr int longest_wait_ms = 60'000;

/// Until the condition holds, or a minute has passed.
[[nodiscard]] bool wait_until(const std::function<bool()>& condition) {
    for (int i = 0; i < longest_wait_ms; ++i) {
        if (condition()) return true;
        poll(nullptr, 0, 1);
    }
    return false;
}

class ServoProcess : public testing::Test {
  protected:
    ServoProcess()
        : path_(testing::TempDir() + "board-" + std::to_string(getpid())),
          board_(make_fake_board(path_)) {
        prctl(PR_SET_CHILD_SUBREAPER, 1UL, 0UL, 0UL, 0UL);
    }

    ~ServoProcess() override {
        if (kiosk_ != 0) end_kiosk(SIGKILL);
        if (board_.owner != 0) kill(board_.owner, SIGKILL);
        while (waitpid(-1, nullptr, 0) > 0) {
        }
        std::filesystem::remove(path_);
    }

    void start_kiosk() {
        std::string program = TOUCHLINE_SERVO_RIG;
        std::string mode = "kiosk";
        char* const words[] = {program.data(), mode.data(), path_.data(), nullptr};
        ASSERT_EQ(posix_spawn(&kiosk_, program.c_str(), nullptr, nullptr, words, environ), 0);
    }

    int end_kiosk(int signal) {
        kill(kiosk_, signal);
        kill(kiosk_, SIGCONT);
        int status = 0;
        waitpid(std::exchange(kiosk_, 0), &status, 0);
        return status;
    }

    /// Lifts the handle until force is armed, then presses until there is torque; again where the
    /// scene came late or force was held off for a moment.
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

    /// A servo of this number or a later one, with torque on.
    [[nodiscard]] bool press_on_servo(int number) {
        return wait_until([&] { return board_.opened >= number && board_.reads > 0; }) && press();
    }

    /// Milliseconds until the torque is zero after `act`; told.
    double ms_to_zero(const char* what, const std::function<void()>& act) {
        const std::int64_t start_ns = steady_now_ns();
        act();
        EXPECT_TRUE(wait_until([&] { return board_.is_torque_on == 0; })) << what;
        board_.is_pressed = 0;  // above the line when the next scene comes: that is the side it has
        const double ms = 1e-6 * static_cast<double>(board_.zeroed_ns - start_ns);
        std::printf("%s: zero torque after %.1f ms\n", what, ms);
        return ms;
    }

    void kill_servo(int signal) const { kill(board_.owner, signal); }

    static constexpr double far_away_ms = 5000.0;

    std::string path_;
    FakeBoard& board_;
    pid_t kiosk_ = 0;
};

TEST_F(ServoProcess, MakesForceAndEndsAsAsked) {
    start_kiosk();
    ASSERT_TRUE(press_on_servo(1));
    const int servo = board_.owner;
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
    EXPECT_EQ(board_.is_torque_on, 0);
    EXPECT_EQ(board_.zeroed_by_guard, 0);  // it ended by itself
    EXPECT_NE(kill(servo, 0), 0);
}

TEST_F(ServoProcess, TheGuardZeroesABoardThatDidNotConfirmItAtTheEnd) {
    board_.is_zero_unconfirmed = 1;
    start_kiosk();
    ASSERT_TRUE(press_on_servo(1));
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
    EXPECT_EQ(board_.is_torque_on, 0);
    EXPECT_EQ(board_.zeroed_by_guard, 1);
}

TEST_F(ServoProcess, KilledKioskLeavesNoTorqueAndNoServo) {
    for (int round = 1; round <= 3; ++round) {
        for (const int signal : {SIGKILL, SIGSEGV}) {
            const int before = board_.opened;
            start_kiosk();
            ASSERT_TRUE(press_on_servo(before + 1));
            const int servo = board_.owner;
            EXPECT_LT(ms_to_zero(signal == SIGKILL ? "kiosk killed" : "kiosk crashed",
                                 [&] { end_kiosk(signal); }),
                      far_away_ms);
            int status = 0;
            EXPECT_EQ(waitpid(servo, &status, 0), servo);
            EXPECT_EQ(status, 0);
        }
    }
}

TEST_F(ServoProcess, FrozenKioskLosesTheForceAndGetsItBackByTheArmRule) {
    start_kiosk();
    for (int round = 1; round <= 3; ++round) {
        ASSERT_TRUE(press_on_servo(1));
        EXPECT_LT(ms_to_zero("kiosk frozen", [&] { kill(kiosk_, SIGSTOP); }), far_away_ms);
        kill(kiosk_, SIGCONT);
    }
    ASSERT_TRUE(press_on_servo(1));
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
}

TEST_F(ServoProcess, KilledServoIsZeroedByTheGuardAndStartedAgain) {
    start_kiosk();
    int servos = 0;
    for (const int signal : {SIGKILL, SIGSTOP}) {
        ASSERT_TRUE(press_on_servo(++servos));
        const int zeroed = board_.zeroed_by_guard;
        EXPECT_LT(ms_to_zero(signal == SIGKILL ? "servo killed" : "servo frozen",
                             [&] { kill_servo(signal); }),
                  far_away_ms);
        EXPECT_TRUE(wait_until([&] { return board_.zeroed_by_guard == zeroed + 1; }));
        servos = std::max(servos, board_.opened.load());
    }
    ASSERT_TRUE(press_on_servo(servos + 1));
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
}

TEST_F(ServoProcess, CrashingServoZeroesTheTorqueItself) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) {
        const int before = board_.opened;
        start_kiosk();
        ASSERT_TRUE(press_on_servo(before + 1));
        const int zeroed = board_.zeroed_by_handler;
        EXPECT_LT(ms_to_zero("servo crashed", [&] { kill_servo(signal); }), far_away_ms);
        EXPECT_TRUE(wait_until([&] { return board_.zeroed_by_handler == zeroed + 1; })) << signal;
        EXPECT_TRUE(wait_until([&] { return board_.opened > before + 1; })) << signal;
        EXPECT_EQ(end_kiosk(SIGTERM), 0);
    }
}

TEST_F(ServoProcess, CrashOrHangInTheLoopItselfLeavesNoTorque) {
    start_kiosk();
    int servos = 0;
    for (const Mischief mischief :
         {Mischief::write_nowhere, Mischief::throw_something, Mischief::spin}) {
        ASSERT_TRUE(press_on_servo(++servos));
        const int zeroed = board_.zeroed_by_guard;
        EXPECT_LT(ms_to_zero("loop crashed or hung", [&] { board_.mischief = mischief; }),
                  far_away_ms);
        EXPECT_TRUE(wait_until([&] { return board_.zeroed_by_guard > zeroed; }));
        servos = std::max(servos, board_.opened.load());
    }
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
}

TEST_F(ServoProcess, ServoEndsWithZeroTorqueOnSigterm) {
    start_kiosk();
    ASSERT_TRUE(press_on_servo(1));
    EXPECT_LT(ms_to_zero("servo asked to end", [&] { kill_servo(SIGTERM); }), far_away_ms);
    EXPECT_EQ(board_.zeroed_by_handler, 0);
    EXPECT_TRUE(wait_until([&] { return board_.opened == 2; }));  // nobody asked the kiosk
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
}

/// A kiosk gone mad: it scribbles over all that is shared, sends nonsense, and dies.
TEST_F(ServoProcess, AKioskGoneMadNeitherCrashesTheServoNorLeavesTorque) {
    auto sockets = socket_pair().value();
    auto region = SharedRegion::create().value();
    auto child =
        Child::start(TOUCHLINE_SERVO_RIG, {"3", path_}, std::array{&sockets.second}).value();
    sockets.second = Descriptor{};
    ASSERT_TRUE(send(sockets.first, message_of(MessageKind::region), &region.descriptor()));
    ASSERT_TRUE(wait_until([&] { return board_.reads > 100; }));
    std::mt19937 random(20261122);
    auto* const bytes = reinterpret_cast<volatile unsigned char*>(&region.channel());
    const std::size_t stop = offsetof(ServoChannel, is_stop_wanted);
    for (int round = 0; round < 200; ++round) {
        for (int i = 0; i < 2000; ++i) {
            const std::size_t at = random() % sizeof(ServoChannel);
            if (at != stop) bytes[at] = static_cast<unsigned char>(random());
        }
        Message message = message_of(static_cast<MessageKind>(round % 4));
        message.scene.radius_m = round % 3 == 0 ? -1.0 : 0.001;
        (void)send(sockets.first, message, round % 2 == 0 ? &region.descriptor() : nullptr);
        poll(nullptr, 0, 1);
    }
    const std::uint64_t reads = board_.reads;
    EXPECT_TRUE(wait_until([&] { return board_.reads > reads + 100; }));  // it ticks on
    sockets.first = Descriptor{};
    pollfd waiting{child.pidfd().number(), POLLIN, 0};
    ASSERT_EQ(poll(&waiting, 1, longest_wait_ms), 1);
    EXPECT_TRUE(child.reap().is_good());
    EXPECT_EQ(board_.is_torque_on, 0);
}

TEST_F(ServoProcess, ServoWithoutAKioskEnds) {
    auto sockets = socket_pair().value();
    auto child =
        Child::start(TOUCHLINE_SERVO_RIG, {"3", path_}, std::array{&sockets.second}).value();
    sockets.second = Descriptor{};
    sockets.first = Descriptor{};
    pollfd waiting{child.pidfd().number(), POLLIN, 0};
    ASSERT_EQ(poll(&waiting, 1, longest_wait_ms), 1);
    EXPECT_EQ(child.reap(), (ChildEnd{1, 0}));
    EXPECT_EQ(board_.opened, 0);
}

}  // namespace
}  // namespace touchline
