// Faults at every moment: while the controllers are armed, at work, and while the motors are let
// go. The motors never pull where nobody told them to, and a zero that is told is one.
#include "tests/haptics/device/drives/drive_ends.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr JointTorques wanted{0.04, -0.05};

constexpr std::array every_line_fault{
    LineFault::lost_write, LineFault::cut_write,  LineFault::garbled_write, LineFault::full,
    LineFault::late_reply, LineFault::lost_reply, LineFault::garbled_reply, LineFault::cut_reply};

template <class Machine>
class DriveFaults : public testing::Test {};

using FaultMachines = testing::Types<MoteusMachine, OdriveMachine>;
TYPED_TEST_SUITE(DriveFaults, FaultMachines);

TYPED_TEST(DriveFaults, OneFaultAnywhereInOpeningIsOvercomeWithoutTorque) {
    for (const LineFault fault : every_line_fault) {
        for (std::size_t at = 0; at < 36; at += 2) {
            DriveRig<TypeParam> rig;
            rig.line->spoil_write(at, fault, 0.012, at + 1);
            SCOPED_TRACE(testing::Message() << static_cast<int>(fault) << " at write " << at);
            const auto opened = rig.driver->open();
            ASSERT_TRUE(opened.has_value()) << opened.error().line;
            for (const BridgeChange& change : rig.plant().changes())
                ASSERT_EQ(change.torques, ShaftTorques{});
            rig.tick_for(0.1, wanted);
            ASSERT_NEAR(norm(rig.held() - wanted), 0.0, 1e-4);
        }
    }
}

TYPED_TEST(DriveFaults, UnpluggedWhileItIsOpenedIsSaid) {
    for (std::size_t at = 0; at < 20; ++at) {
        DriveRig<TypeParam> rig;
        rig.line->spoil_write(at, LineFault::unplugged);
        const auto opened = rig.driver->open();
        ASSERT_FALSE(opened.has_value()) << at;
        EXPECT_NE(opened.error().line.find("plug"), std::string::npos) << opened.error().line;
        rig.pass(0.1);
        EXPECT_EQ(rig.bridges(), both_off);
    }
}

TYPED_TEST(DriveFaults, OneFaultAnywhereInStoppingStillLetsTheMotorsGo) {
    for (const LineFault fault : every_line_fault) {
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            DriveRig<TypeParam> rig;
            ASSERT_TRUE(rig.driver->open().has_value());
            rig.tick_for(0.03, wanted);
            rig.line->spoil(fault, 0.001 * static_cast<double>(seed), seed);
            const bool is_confirmed = rig.driver->stop();
            SCOPED_TRACE(testing::Message() << static_cast<int>(fault) << " seed " << seed);
            EXPECT_TRUE(is_confirmed);
            rig.pass(0.001);
            EXPECT_EQ(rig.held(), JointTorques{});
            EXPECT_EQ(rig.bridges(), both_off);
        }
    }
}

// The watchdogs would do it too, but stop() says that it was done.
TYPED_TEST(DriveFaults, AStopThatIsLostAfterAZeroIsSaidAgain) {
    for (const LineFault fault : every_line_fault) {
        DriveRig<TypeParam> rig;
        ASSERT_TRUE(rig.driver->open().has_value());
        rig.tick_for(0.03, wanted);
        rig.tick_for(0.03, {});
        ASSERT_TRUE(rig.is_written);
        rig.line->spoil(fault, 0.004, 3);
        const bool is_confirmed = rig.driver->stop();
        SCOPED_TRACE(testing::Message() << static_cast<int>(fault));
        EXPECT_TRUE(is_confirmed);
        EXPECT_EQ(rig.bridges(), both_off);
    }
}

// Where no tick follows, a zero from before is as good as a new one; without one the motors go.
TYPED_TEST(DriveFaults, AnEndInZeroIsZeroOrLetsGo) {
    for (const LineFault fault : every_line_fault) {
        for (const JointTorques before : {JointTorques{}, wanted}) {
            DriveRig<TypeParam> rig;
            ASSERT_TRUE(rig.driver->open().has_value());
            rig.tick_for(0.03, before);
            rig.line->spoil(fault, 0.03, 3);
            const bool is_confirmed = rig.driver->end_in_zero();
            SCOPED_TRACE(testing::Message() << static_cast<int>(fault));
            EXPECT_TRUE(is_confirmed);
            EXPECT_EQ(rig.held(), JointTorques{});
        }
    }
}

TYPED_TEST(DriveFaults, AFaultIsToldInWhicheverTickItComes) {
    for (const std::size_t motor : {0U, 1U}) {
        for (int ticks = 40; ticks < 44; ++ticks) {
            SCOPED_TRACE(testing::Message() << "motor " << motor << " after " << ticks);
            DriveRig<TypeParam> rig;
            ASSERT_TRUE(rig.driver->open().has_value());
            rig.tick_for(drive_tick_s * ticks, press);
            rig.machine.fail(motor);
            expect_told(rig, motor);
        }
    }
}

// The controllers are armed anew for the silence, which clears what nobody was told of.
TYPED_TEST(DriveFaults, AFaultNearALostAnswerIsToldAndNotCleared) {
    for (const std::size_t motor : {0U, 1U}) {
        for (const double silent_s : {0.006, 0.012}) {
            for (int ticks = 0; ticks < 60; ++ticks) {
                SCOPED_TRACE(testing::Message()
                             << "motor " << motor << ", " << ticks << " ms after a silence of "
                             << silent_s << " s began");
                DriveRig<TypeParam> rig;
                ASSERT_TRUE(rig.driver->open().has_value());
                rig.tick_for(0.05, press);
                rig.line->spoil(LineFault::lost_reply, silent_s);
                rig.tick_for(drive_tick_s * ticks, press);
                rig.machine.fail(motor);
                expect_told(rig, motor);
            }
        }
    }
}

TYPED_TEST(DriveFaults, ZeroIsSaidOnlyWhileTheMotorsHoldIt) {
    for (const LineFault fault : every_line_fault) {
        for (int spoiled = 0; spoiled < 4; ++spoiled) {
            DriveRig<TypeParam> rig;
            ASSERT_TRUE(rig.driver->open().has_value());
            rig.tick_for(0.03, wanted);
            for (int i = 0; i < 200; ++i) {
                if (i == spoiled) rig.line->spoil(fault, 0.004, 3);
                (void)rig.tick(i == 0 ? wanted : JointTorques{});
                if (i > 0 && rig.is_written) {
                    ASSERT_EQ(rig.held(), JointTorques{}) << static_cast<int>(fault) << ' ' << i;
                }
            }
            EXPECT_TRUE(rig.is_written) << static_cast<int>(fault);
        }
    }
}

TYPED_TEST(DriveFaults, ManyFaultsNeverLeaveTheMotorsPulling) {
    std::mt19937_64 random(11);
    for (int run = 0; run < 20; ++run) {
        DriveRig<TypeParam> rig;
        (void)rig.driver->open();
        for (int k = 0; k < 500; ++k) {
            if (random() % 12 == 0) {
                const double span_s = 1e-3 * static_cast<double>(random() % 10);
                rig.line->spoil(every_line_fault[random() % every_line_fault.size()], span_s,
                                random());
            }
            const auto angles = rig.tick(wanted);
            if (angles) {
                ASSERT_LT(norm(*angles - rig.plant().angles()), 0.1) << run << ' ' << k;
            }
        }
        rig.line->spoil(LineFault::none);
        EXPECT_TRUE(rig.driver->stop()) << run;
        rig.pass(0.03);
        ASSERT_EQ(rig.held(), JointTorques{}) << run;
    }
}

// Its process died with torque on, and another program comes before the watchdogs do.
TYPED_TEST(DriveFaults, AnotherProgramTakesOverFromOneThatDied) {
    DriveRig<TypeParam> rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.05, wanted);
    rig.line->spoil(LineFault::unplugged);
    rig.pass(0.002);
    EXPECT_NE(rig.held(), JointTorques{});
    const double from_s = rig.time.now_s;
    rig.connect({});
    ASSERT_TRUE(rig.driver->open().has_value());
    EXPECT_LE(rig.zero_from(from_s) - from_s, 0.0025);
    EXPECT_TRUE(rig.tick({}).has_value());
    EXPECT_FALSE(rig.driver->report().is_position_doubtful);
}

}  // namespace
}  // namespace touchline
