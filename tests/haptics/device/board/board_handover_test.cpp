// What the driver finds, leaves and loses: boards that others drove, stopping, the plug.
#include "haptics/device/board/pantograph_board.h"
#include "tests/machines/sim/board/board_rig.h"

#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr JointTorques steady_push{0.03, -0.02};

TEST(BoardHandover, StopLeavesZeroTorqueAndGivesTheBoardBack) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.1, steady_push);
    EXPECT_TRUE(rig.driver->stop());
    EXPECT_EQ(rig.held(), JointTorques{});
    EXPECT_EQ(rig.driver->report().state, BoardState::closed);
    EXPECT_FALSE(rig.tick(steady_push).has_value());
    EXPECT_FALSE(rig.driver->write_torques(steady_push));
    EXPECT_FALSE(rig.driver->stop());
    EXPECT_EQ(rig.held(), JointTorques{});
}

TEST(BoardHandover, DestroyingTheDriverStopsTheMotors) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.1, steady_push);
    rig.driver.reset();
    EXPECT_EQ(rig.held(), JointTorques{});
}

TEST(BoardHandover, ABoardThatSomebodyElseLeftPullingIsStopped) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.1, steady_push);
    const std::uint64_t set_ups = rig.board.firmware().set_ups();
    // The other program is gone; the board does not know.
    EXPECT_TRUE(zero_torque(std::make_unique<EmulatedLink>(rig.board, rig.time)));
    EXPECT_EQ(rig.held(), JointTorques{});
    EXPECT_EQ(rig.board.firmware().set_ups(), set_ups);  // it still knows where the handle is
}

TEST(BoardHandover, ZeroIsTheFirstThingThatAStopSends) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.1, steady_push);
    const double before_s = rig.time.now_s;
    EXPECT_TRUE(rig.driver->stop());
    EXPECT_LE(rig.board.told_torques().back().at_s, before_s + 1e-3);
}

TEST(BoardHandover, ABoardThatWasNeverSetUpIsStoppedToo) {
    BoardRig rig;
    EXPECT_TRUE(zero_torque(std::make_unique<EmulatedLink>(rig.board, rig.time)));
    EXPECT_EQ(rig.held(), JointTorques{});
}

TEST(BoardHandover, AStaleReplyFromBeforeIsDrained) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.05, steady_push);
    // A program died with a reply unread.
    rig.board.host_listens(false);
    rig.board.host_sends(write_command({0.01, 0.01}).bytes());
    rig.time.now_s += 0.01;
    rig.board.advance_to(rig.time.now_s);
    auto fresh = std::make_unique<EmulatedLink>(rig.board, rig.time);
    PantographBoard second(std::move(fresh), rig.board.truth().profile, {});
    ASSERT_TRUE(second.open().has_value());
    EXPECT_EQ(second.report().state, BoardState::ready);
    EXPECT_EQ(second.report().replies, 2U);  // the stale one and the reply to the zero write
}

TEST(BoardHandover, TheEmptyPacketAfterAnOverflowIsIgnored) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.board.host_listens(false);
    for (int i = 0; i < 3; ++i) rig.board.host_sends(write_command({}).bytes());
    rig.time.now_s += 0.2;
    rig.board.advance_to(rig.time.now_s);
    rig.connect();
    ASSERT_TRUE(rig.driver->open().has_value());
    EXPECT_EQ(rig.driver->report().empty_packets, 1U);
    EXPECT_TRUE(rig.tick({}).has_value());
}

/// A driver on a board that another one drove a tenth of a second ago.
class TakenOver : public testing::Test {
  protected:
    TakenOver() {
        EXPECT_TRUE(rig_.driver->open().has_value());
        rig_.tick_for(0.1, steady_push);
        last_ = rig_.tick(steady_push).value();
        set_ups_ = rig_.board.firmware().set_ups();
    }

    static constexpr double sprung_back = 0.03;  // rad, of a hand that is no longer pushed

    BoardRig rig_;
    JointAngles last_;
    std::uint64_t set_ups_ = 0;
};

TEST_F(TakenOver, ItGoesOnWithoutASetUpAndWithZeroTorque) {
    rig_.connect();
    ASSERT_TRUE(rig_.driver->take_over(last_, 0.1));
    EXPECT_EQ(rig_.held(), JointTorques{});
    EXPECT_EQ(rig_.board.firmware().set_ups(), set_ups_);
    EXPECT_LT(norm(rig_.tick({}).value() - last_), sprung_back);
    rig_.tick_for(0.05, steady_push);
    EXPECT_LT(norm(rig_.held() - steady_push), 1e-3);
}

TEST_F(TakenOver, WithItsOwnCalibration) {
    Calibration unit;
    unit.offset = {0.02, -0.01};
    unit.scale = 1.01;
    unit.encoders = {true, false, true};
    rig_.connect({}, unit);
    const JointAngles seen =
        rig_.driver->frame().joint_angles(BoardFrame(default_profile(), {}).reading_at(last_));
    ASSERT_TRUE(rig_.driver->take_over(seen, 0.1));
    EXPECT_LT(norm(rig_.tick({}).value() - seen), sprung_back);
}

TEST_F(TakenOver, NotIfTheHandleIsWhereNoHandCanHaveMovedIt) {
    rig_.connect();
    EXPECT_FALSE(rig_.driver->take_over(last_ + JointAngles{0.5, 0.0}, 0.001));
}

TEST_F(TakenOver, NotIfTheBoardForgotItsSetUp) {
    rig_.driver.reset();
    rig_.board.host_sends(reset_command().bytes());
    rig_.time.now_s += 0.01;
    rig_.connect();
    EXPECT_FALSE(rig_.driver->take_over(last_, 0.1));
    ASSERT_TRUE(rig_.driver->open().has_value()) << "it can be opened as ever";
    EXPECT_TRUE(rig_.tick({}).has_value());
}

TEST_F(TakenOver, NotIfItWasPluggedInAgain) {
    rig_.driver.reset();
    rig_.board.unplug();
    rig_.board.plug();
    rig_.connect();
    EXPECT_FALSE(rig_.driver->take_over(last_, 0.1));
}

TEST_F(TakenOver, NotFromWhatIsNoPlaceOrTime) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    rig_.connect();
    EXPECT_FALSE(rig_.driver->take_over({nan, 0.0}, 0.1));
    EXPECT_FALSE(rig_.driver->take_over(last_, nan));
    EXPECT_FALSE(rig_.driver->take_over(last_, -1.0));
}

TEST_F(TakenOver, AZeroedBoardTellsWhetherItWasSetUpAllTheTime) {
    rig_.driver.reset();
    EXPECT_EQ(zero_board(std::make_unique<EmulatedLink>(rig_.board, rig_.time), default_profile()),
              ZeroedBoard::kept);
    rig_.board.host_sends(reset_command().bytes());
    rig_.time.now_s += 0.01;
    EXPECT_EQ(zero_board(std::make_unique<EmulatedLink>(rig_.board, rig_.time), default_profile()),
              ZeroedBoard::unknown);
}

TEST(BoardHandover, UnpluggedInMidStrokeIsLostAndSaysSo) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.1, steady_push);
    rig.board.unplug();
    EXPECT_FALSE(rig.tick(steady_push).has_value());
    EXPECT_FALSE(rig.is_written);
    EXPECT_EQ(rig.driver->report().state, BoardState::lost);
    EXPECT_EQ(rig.driver->report().last_failure, LinkStatus::gone);
    EXPECT_FALSE(rig.driver->stop());
    EXPECT_EQ(rig.driver->open().error().line, "the board was given back");
}

TEST(BoardHandover, PluggedInAgainUnderAnotherNumberItOpensAnew) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.1, steady_push);
    rig.board.unplug();
    (void)rig.tick(steady_push);
    const int number = rig.board.device_number();
    rig.board.plug();
    EXPECT_NE(rig.board.device_number(), number);
    EXPECT_EQ(rig.held(), JointTorques{});
    rig.connect();
    ASSERT_TRUE(rig.driver->open().has_value());
    (void)rig.tick({});
    rig.tick_for(0.05, steady_push);
    EXPECT_LT(norm(rig.held() - steady_push), 1e-3);
}

TEST(BoardHandover, SomethingThatIsNoPantographIsRefused) {
    BoardTruth truth;
    BoardRig rig(truth);
    std::vector<PlannedFault> deaf;
    for (std::size_t i = 0; i < 100; ++i) deaf.push_back({i, LinkFault::lost_reply, 0.0, 0});
    rig.connect(deaf);
    const double before_s = rig.time.now_s;
    const auto opened = rig.driver->open();
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().line,
              "the board does not answer as a pantograph's board does: check that it is the right "
              "one, unplug it and plug it in again");
    EXPECT_LT(rig.time.now_s - before_s, 4.5);
    EXPECT_FALSE(rig.board.firmware().is_broken());
}

}  // namespace
}  // namespace touchline
