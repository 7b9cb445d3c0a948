// Tests homing and the nudge test with the driver, an emulated board and a person who does what is
// said.
#include "tests/app/force/device/device_visit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace touchline {
namespace {

double worst_angle_rad(DeviceVisit& visit) {
    const JointAngles read = visit.rig.tick({}).value();
    const JointAngles off = read - visit.rig.board.true_angles();
    return std::max(std::abs(off.x), std::abs(off.y));
}

Calibration measured() {
    Calibration stored;
    stored.is_measured = true;
    return stored;
}

TEST(Procedures, HomingPutsRightABoardThatWasSetUpInTheMiddle) {
    DeviceVisit visit;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    visit.rig.tick_for(0.1, {});
    EXPECT_GT(worst_angle_rad(visit), 0.3);
    const auto homed = home(visit.procedure(), measured());
    ASSERT_TRUE(homed.has_value());
    EXPECT_FALSE(homed->is_new);
    visit.rig.tick_for(0.1, {});
    EXPECT_LT(worst_angle_rad(visit), 0.01);
    EXPECT_EQ(visit.rig.held(), JointTorques{});
}

TEST(Procedures, HomingMeasuresAScaleThatIsOffByPerCent) {
    BoardTruth truth;
    truth.scale_error = {-0.02, -0.02};
    truth.hand = stiff_arm;
    DeviceVisit visit(truth);
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    const auto homed = home(visit.procedure(), {});
    ASSERT_TRUE(homed.has_value());
    EXPECT_TRUE(homed->is_new);
    EXPECT_TRUE(homed->unit.is_measured);
    EXPECT_NEAR(homed->unit.scale, 1.0 / 0.98, 0.006);
    EXPECT_TRUE(visit.was_heard("to the left"));
    EXPECT_NE(homed->words.find("has been measured"), std::string::npos);
    visit.rig.tick_for(0.1, {});
    EXPECT_LT(worst_angle_rad(visit), 0.01);
}

TEST(Procedures, HomingEndsWhenStoppedUnpluggedOrOutOfTime) {
    DeviceVisit stopped;
    ASSERT_TRUE(stopped.rig.driver->open().has_value());
    stopped.is_stop_wanted = true;
    EXPECT_FALSE(home(stopped.procedure(), {}).has_value());

    DeviceVisit unplugged;
    ASSERT_TRUE(unplugged.rig.driver->open().has_value());
    unplugged.rig.board.unplug();
    const auto ended = home(unplugged.procedure(), {});
    ASSERT_FALSE(ended.has_value());
    EXPECT_NE(ended.error().line.find("unplugged"), std::string::npos);

    DeviceVisit slow;
    ASSERT_TRUE(slow.rig.driver->open().has_value());
    Procedure hasty = slow.procedure();
    hasty.longest_s = 2.0;
    const auto late = home(hasty, {});
    ASSERT_FALSE(late.has_value());
    EXPECT_NE(late.error().line.find("too long"), std::string::npos);
}

TEST(Procedures, TheNudgeTestSeesPowerAndItsOwnEnd) {
    const auto verdict_of = [](bool has_power) {
        BoardTruth truth;
        truth.have_motors_power = has_power;
        DeviceVisit visit(truth);
        EXPECT_TRUE(visit.rig.driver->open().has_value());
        EXPECT_TRUE(home(visit.procedure(), measured()).has_value());
        const auto tried = nudge(visit.procedure());
        EXPECT_EQ(visit.rig.held(), JointTorques{});
        return tried.value().verdict();
    };
    EXPECT_EQ(verdict_of(true), NudgeVerdict::works);
    EXPECT_EQ(verdict_of(false), NudgeVerdict::no_power);
}

TEST(Procedures, ABoardIsReadyOnceBothMotorsMovedTheHandle) {
    DeviceVisit visit;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    const auto unit = make_ready(visit.procedure(), measured());
    ASSERT_TRUE(unit.has_value());
    EXPECT_EQ(unit->motors, Plugs{});
    EXPECT_TRUE(visit.was_heard("let go"));
    EXPECT_EQ(visit.rig.held(), JointTorques{});
    EXPECT_LT(visit.tip_off_m(), 1e-3);
}

TEST(Procedures, NoTorqueIsHeldThatWasNotMarked) {
    DeviceVisit visit;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    Procedure procedure = visit.procedure();
    bool is_marked = false;
    int marks = 0, ticks_unmarked_under_torque = 0;
    procedure.mark_force = [&](bool is_on) { marks += std::exchange(is_marked, is_on) != is_on; };
    const auto goes_on = procedure.goes_on;
    procedure.goes_on = [&, goes_on] {
        ticks_unmarked_under_torque += !is_marked && visit.rig.held() != JointTorques{};
        return goes_on();
    };
    ASSERT_TRUE(make_ready(procedure, measured()).has_value());
    EXPECT_EQ(ticks_unmarked_under_torque, 0);
    EXPECT_GE(marks, 2);
    EXPECT_FALSE(is_marked);
}

TEST(Procedures, NoForceComesWhileTheMotorsHaveNoPowerAndThenItDoes) {
    BoardTruth truth;
    truth.have_motors_power = false;
    DeviceVisit visit(truth);
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    Procedure procedure = visit.procedure();
    const auto goes_on = procedure.goes_on;
    procedure.goes_on = [&, goes_on] {
        if (visit.rig.time.now_s > 60.0) visit.rig.board.switch_motors(true);
        return goes_on();
    };
    const auto unit = make_ready(procedure, measured());
    ASSERT_TRUE(unit.has_value());
    EXPECT_GT(visit.rig.time.now_s, 60.0);
    EXPECT_TRUE(visit.was_heard("power of the motors"));
}

/// A homed unit; the hand stays at the second stop, whatever is said.
struct Homebody {
    explicit Homebody(bool have_motors_power = true) : visit(truth(have_motors_power)) {
        EXPECT_TRUE(visit.rig.driver->open().has_value());
        EXPECT_TRUE(home(visit.procedure(), measured()).has_value());
        visit.person->heard.clear();
    }

    static BoardTruth truth(bool have_motors_power) {
        BoardTruth truth;
        truth.have_motors_power = have_motors_power;
        return truth;
    }

    /// A procedure that may take so long; the person does not do what is said.
    Procedure deaf(double longest_s) {
        Procedure procedure = visit.procedure();
        procedure.longest_s = longest_s;
        procedure.say = [this](const std::string& words) { visit.person->heard.push_back(words); };
        return procedure;
    }

    [[nodiscard]] bool was_torque_told() const {
        const auto& told = visit.rig.board.told_torques();
        return std::any_of(told.begin(), told.end(), [](const TorqueChange& change) {
            return change.torques != JointTorques{};
        });
    }

    DeviceVisit visit;
};

TEST(Procedures, NoMotorIsTriedOutsideTheMiddleHoweverLongItTakes) {
    for (const double longest_s : {1.0, 3.0, 7.0}) {
        Homebody body;
        const auto tried = try_motors(body.deaf(longest_s), true);
        ASSERT_FALSE(tried.has_value());
        EXPECT_NE(tried.error().line.find("too long"), std::string::npos) << tried.error().line;
        EXPECT_FALSE(body.was_torque_told());
    }
}

TEST(Procedures, WhoMissesTheMiddleHearsSoAgainAndAgainInOtherWords) {
    Homebody body;
    EXPECT_FALSE(try_motors(body.deaf(90.0), false).has_value());
    const auto& heard = body.visit.person->heard;
    EXPECT_TRUE(body.visit.was_heard("not in the middle yet"));
    EXPECT_GE(heard.size(), 5U);
    EXPECT_EQ(std::adjacent_find(heard.begin(), heard.end()), heard.end());
    EXPECT_FALSE(body.was_torque_told());
}

TEST(Procedures, MotorsWithoutPowerAreTriedNoLongerThanItMayTake) {
    Homebody body(false);
    Procedure procedure = body.visit.procedure();
    procedure.longest_s = 40.0;
    const double began_s = body.visit.rig.time.now_s;
    body.visit.end_s = began_s + 200.0;
    const auto tried = try_motors(procedure, false);
    ASSERT_FALSE(tried.has_value());
    EXPECT_NE(tried.error().line.find("too long"), std::string::npos) << tried.error().line;
    EXPECT_NEAR(body.visit.rig.time.now_s - began_s, 40.0, 1.0);
    const auto& heard = body.visit.person->heard;
    EXPECT_EQ(std::adjacent_find(heard.begin(), heard.end()), heard.end());
}

/// A hand that holds on settles nothing: it is asked to let go again and again.
TEST(Procedures, AHandleThatIsHeldProvesNothing) {
    BoardTruth truth;
    truth.hand = {0.5, 20.0, 6000.0, {}};  // a fist that leans on the table
    DeviceVisit visit(truth);
    visit.end_s = 80.0;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    Procedure procedure = visit.procedure();
    procedure.say = [&](const std::string& words) {
        visit.person->hear(words, visit.rig.time.now_s);
        visit.person->go(visit.person->at(1e9).position, visit.rig.time.now_s);  // holds on
        visit.person->heard.push_back(words);
    };
    EXPECT_FALSE(make_ready(procedure, measured()).has_value());
    EXPECT_TRUE(visit.was_heard("Let go of it"));
    EXPECT_EQ(visit.rig.held(), JointTorques{});
}

TEST(Procedures, AMotorThatWasReversedSinceGivesNoForceAndSaysWhichPlug) {
    BoardTruth truth;
    truth.motors.is_1_reversed = true;
    DeviceVisit visit(truth);
    visit.end_s = 90.0;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    EXPECT_FALSE(make_ready(visit.procedure(), measured()).has_value());
    EXPECT_TRUE(visit.was_heard("The motor on plug 2 pushes the wrong way"));
    const double told_s = visit.rig.board.told_torques().back().at_s;
    EXPECT_LT(told_s, 70.0);  // nothing moves after the verdict
    EXPECT_EQ(visit.rig.held(), JointTorques{});
}

}  // namespace
}  // namespace touchline
