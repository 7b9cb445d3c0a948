// Zero means that a zero was sent: what write_torques({}) reports, and how soon the board holds it
// when a send hangs.
#include "tests/machines/sim/board/board_rig.h"
#include "tests/machines/sim/fault_lines.h"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr JointTorques push_against{0.05, -0.05};

/// A rig whose driver has been pushing.
class Pushing : public BoardRig {
  public:
    explicit Pushing(double for_s = 0.05) {
        EXPECT_TRUE(driver->open().has_value());
        tick_for(for_s, push_against);
        EXPECT_NE(held(), JointTorques{});
    }

    void spoil(LinkFault fault, double span_s = 0.0) { link->spoil_next({0, fault, span_s, 1}); }
};

TEST(ZeroTorque, IsNotSaidBeforeItsOwnSendHasEnded) {
    Pushing rig;
    EXPECT_FALSE(rig.driver->write_torques({})) << "the tick's own write is still under way";
    (void)rig.tick({});
    EXPECT_FALSE(rig.is_written) << "only just sent";
    (void)rig.tick({});
    EXPECT_TRUE(rig.is_written);
    EXPECT_EQ(rig.held(), JointTorques{});
    (void)rig.tick(push_against);
    EXPECT_TRUE(rig.is_written) << "other torques are taken at once";
    (void)rig.tick({});
    EXPECT_FALSE(rig.is_written);
}

TEST(ZeroTorque, IsSaidOnlyWhileTheBoardHoldsIt) {
    for (const LinkFault fault : {LinkFault::short_send, LinkFault::late_send, LinkFault::lost_send,
                                  LinkFault::unconfirmed_send, LinkFault::stalled_send}) {
        for (int spoiled = 0; spoiled < 3; ++spoiled) {
            Pushing rig;
            for (int i = 0; i < 100; ++i) {
                if (i == spoiled) rig.spoil(fault, 0.004);
                (void)rig.tick(i == 0 ? push_against : JointTorques{});
                if (i > 0 && rig.is_written) {
                    EXPECT_EQ(rig.held(), JointTorques{}) << static_cast<int>(fault) << ' ' << i;
                }
            }
            EXPECT_TRUE(rig.is_written);
        }
    }
}

/// Returns the time from the tick that wants a zero; the send before it hangs, or the zero's own
/// does.
double zero_after_s(LinkFault fault, double span_s, bool is_zero_spoiled, std::uint64_t& resyncs) {
    Pushing rig(0.01);
    const std::uint64_t before = rig.driver->report().resyncs;
    if (!is_zero_spoiled) rig.spoil(fault, span_s);
    (void)rig.tick(push_against);
    const double wanted_s = rig.time.now_s + rig_tick_s;
    if (is_zero_spoiled) rig.spoil(fault, span_s);
    for (int i = 0; i < 60 && rig.held() != JointTorques{}; ++i) (void)rig.tick({});
    const double zero_s = rig.board.told_torques().back().at_s;
    EXPECT_EQ(rig.held(), JointTorques{});
    rig.tick_for(0.05, {});
    resyncs += rig.driver->report().resyncs - before;
    return zero_s - wanted_s;
}

TEST(ZeroTorque, OvertakesASendThatHangs) {
    const std::uint64_t runs = fault_runs(100, 1000);
    for (const LinkFault fault : {LinkFault::late_send, LinkFault::lost_send}) {
        double worst_s = 0.0;
        std::uint64_t resyncs = 0;
        for (std::uint64_t run = 0; run < runs; ++run) {
            const double span_s =
                0.001 + 0.009 * static_cast<double>(run) / static_cast<double>(runs);
            worst_s = std::max(worst_s, zero_after_s(fault, span_s, run % 2 == 0, resyncs));
        }
        EXPECT_LE(worst_s, 0.004);
        EXPECT_EQ(resyncs, 0U);
        testing::Test::RecordProperty(fault == LinkFault::late_send ? "late, us" : "lost, us",
                                      static_cast<int>(1e6 * worst_s));
    }
}

/// Three in a row are no accident: the driver asks what has become of the board.
TEST(ZeroTorque, SendsThatNeverGetThroughEndInAResync) {
    Pushing rig;
    for (int i = 0; i < 12; ++i) {
        rig.spoil(LinkFault::lost_send);
        (void)rig.tick(push_against);
    }
    EXPECT_EQ(rig.driver->report().state, BoardState::resyncing);
    rig.link->spoil_next({});
    rig.tick_for(0.2, {});
    EXPECT_EQ(rig.driver->report().state, BoardState::ready);
    EXPECT_TRUE(rig.is_written);
}

TEST(ZeroTorque, WhoHasNoNextTickEndsInZero) {
    for (const LinkFault fault :
         {LinkFault::none, LinkFault::short_send, LinkFault::late_send, LinkFault::lost_send,
          LinkFault::unconfirmed_send, LinkFault::stalled_send}) {
        Pushing rig;
        rig.spoil(fault, 0.009);
        (void)rig.tick(push_against);
        const double before_s = rig.time.now_s;
        EXPECT_TRUE(rig.driver->end_in_zero()) << static_cast<int>(fault);
        EXPECT_LE(rig.time.now_s - before_s, 0.008) << static_cast<int>(fault);
        EXPECT_EQ(rig.held(), JointTorques{}) << static_cast<int>(fault);
    }
}

TEST(ZeroTorque, IsNotSaidOfABoardThatIsGone) {
    Pushing rig;
    rig.board.unplug();
    (void)rig.tick({});
    EXPECT_FALSE(rig.is_written);
    EXPECT_FALSE(rig.driver->end_in_zero());
}

}  // namespace
}  // namespace touchline
