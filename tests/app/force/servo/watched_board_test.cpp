// Tests the board as the servo sees it after the machine slept.
#include "app/force/servo/watched_board.h"

#include "tests/machines/sim/board/board_rig.h"

#include <memory>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::int64_t slept_in_test_ns = 0;

std::int64_t slept_in_test() {
    return slept_in_test_ns;
}

class SleepyBoard : public testing::Test {
  protected:
    SleepyBoard()
        : emulated_({}, resting_hand(default_profile())),
          board_(std::make_unique<EmulatedLink>(emulated_, time_), default_profile(), {},
                 slept_in_test) {
        MonotonicClock clock;
        const Opening opening{[](const std::string&) {},
                              [] { return true; },
                              [](const Calibration&) {},
                              [](bool) {},
                              {},
                              {}};
        EXPECT_TRUE(board_.open(false, opening, clock).has_value());
    }

    /// Ticks so often and returns the angles of the last tick.
    std::optional<JointAngles> tick(int times) {
        std::optional<JointAngles> angles;
        for (int i = 0; i < times; ++i) {
            time_.now_s += rig_tick_s;
            angles = board_.read_angles(time_.now_s);
            (void)board_.write_torques(angles ? JointTorques{0.02, 0.02} : JointTorques{});
        }
        return angles;
    }

    VirtualTime time_;
    BoardEmulator emulated_;
    WatchedBoard board_;
};

TEST_F(SleepyBoard, HasLostItsPlaceAfterASleepAndHoldsZero) {
    ASSERT_TRUE(tick(10).has_value());
    slept_in_test_ns += 3'600'000'000'000;
    EXPECT_FALSE(tick(1).has_value()) << "on the first tick after";
    EXPECT_TRUE(board_.has_lost_place());
    EXPECT_FALSE(tick(20).has_value()) << "and until it is opened anew";
    emulated_.advance_to(time_.now_s);
    EXPECT_EQ(emulated_.told_torques().back().torques, JointTorques{});
}

class FollowedBoard : public SleepyBoard {
  protected:
    /// Returns whether a servo that comes after this one takes the board over.
    [[nodiscard]] bool is_taken_over(const Handover& from) {
        next_ = std::make_unique<WatchedBoard>(std::make_unique<EmulatedLink>(emulated_, time_),
                                               default_profile(), Calibration{}, slept_in_test);
        return next_->take_over(from);
    }

    [[nodiscard]] Handover handover() {
        return {board_.place(), tick(10).value(), steady_now_ns(), 0.0, "1-1"};
    }

    std::unique_ptr<WatchedBoard> next_;
};

TEST_F(FollowedBoard, IsTakenOverWhereItIs) {
    ASSERT_TRUE(is_taken_over(handover()));
    time_.now_s += rig_tick_s;
    (void)next_->read_angles(time_.now_s);
    EXPECT_FALSE(next_->has_lost_place());
    EXPECT_EQ(next_->place().slept_ns, board_.place().slept_ns) << "for the one after it";
}

TEST_F(FollowedBoard, IsNotTakenOverAfterASleepOrTwoSeconds) {
    Handover late = handover();
    late.seen_ns -= 3'000'000'000;
    EXPECT_FALSE(is_taken_over(late));
    const Handover before = handover();
    slept_in_test_ns += 3'600'000'000'000;
    EXPECT_FALSE(is_taken_over(before));
}

TEST_F(SleepyBoard, TakesNoJitterOfTheClocksForASleep) {
    slept_in_test_ns -= 50'000'000;
    ASSERT_TRUE(tick(10).has_value());
    slept_in_test_ns += 100'000'000;
    EXPECT_TRUE(tick(10).has_value());
    EXPECT_FALSE(board_.has_lost_place());
}

}  // namespace
}  // namespace touchline
