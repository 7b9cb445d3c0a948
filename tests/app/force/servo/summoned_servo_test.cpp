// Tests a servo that another program starts when the kiosk asks at a socket, as systemd does with a
// separate unit: whatever ends kiosk or servo leads to zero torque and another servo.
#include "tests/app/force/servo/process_rig.h"
#include "tests/app/signal_one.h"

#include <csignal>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

class SummonedServo : public ProcessRig {
  protected:
    void SetUp() override {
        start_listener();
        start_kiosk();
        ASSERT_TRUE(press_on_servo(1));
        servo_ = board_.owner;
    }

    /// Expects these words, and force again from another servo.
    void expect_another(const std::string& words) {
        std::string said;
        EXPECT_TRUE(wait_until([&] {
            return (said += new_words()).find(words) != std::string::npos;
        })) << said;
        EXPECT_TRUE(press_on_servo(2));
        EXPECT_NE(board_.owner, servo_);
        EXPECT_FALSE(is_there(servo_));
    }

    int servo_ = 0;
};

TEST_F(SummonedServo, MakesForceAndEndsAsAsked) {
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
    EXPECT_EQ(board_.is_torque_on, 0);
    EXPECT_EQ(board_.zeroed_by_guard, 0);  // it ended by itself, and said so
    EXPECT_TRUE(wait_until([&] { return !is_there(servo_); }));
}

TEST_F(SummonedServo, KilledIsZeroedByTheGuardAndAskedForAgain) {
    (void)ms_to_zero([&] { signal_one(servo_, SIGKILL); });
    expect_another("the servo ended with no farewell; the torque was zeroed");
    EXPECT_EQ(board_.zeroed_by_guard, 1);
}

TEST_F(SummonedServo, FrozenIsKilledByTheGuardThoughItIsNoChildOfIts) {
    (void)ms_to_zero([&] { signal_one(servo_, SIGSTOP); });
    expect_another("the servo ended with no farewell; the torque was zeroed");
    EXPECT_EQ(board_.zeroed_by_guard, 1);
}

TEST_F(SummonedServo, CrashedZeroesByItsHandler) {
    (void)ms_to_zero([&] { signal_one(servo_, SIGSEGV); });
    expect_another("the servo ended with no farewell");
    EXPECT_GE(board_.zeroed_by_handler, 1);
}

TEST_F(SummonedServo, EndsWithZeroTorqueWhenItsKioskIsKilled) {
    (void)ms_to_zero([&] { (void)end_kiosk(SIGKILL); });
    EXPECT_TRUE(wait_until([&] { return !is_there(servo_); }));
    start_kiosk();
    EXPECT_TRUE(press_on_servo(2));
}

TEST_F(SummonedServo, FadesWhenItsKioskIsFrozen) {
    (void)ms_to_zero([&] { signal_one(kiosk_, SIGSTOP); });
    signal_one(kiosk_, SIGCONT);
    EXPECT_TRUE(press());
    EXPECT_EQ(board_.owner, servo_);
}

TEST_F(SummonedServo, NobodyThereIsSaidAndTriedAgain) {
    EXPECT_EQ(end_kiosk(SIGTERM), 0);
    signal_one(listener_, SIGKILL);
    waitpid(listener_, nullptr, 0);
    start_kiosk();
    std::string said;
    EXPECT_TRUE(wait_until([&] {
        return (said += new_words()).find("no servo comes from") != std::string::npos;
    })) << said;
    std::filesystem::remove(socket_path());
    start_listener();
    EXPECT_TRUE(press_on_servo(2));
}

}  // namespace
}  // namespace touchline
