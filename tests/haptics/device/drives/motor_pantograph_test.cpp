// The driver against every emulated pair of controllers: the same rules for each.
#include "haptics/device/drives/motor_pantograph.h"

#include "haptics/device/nudge_test.h"
#include "tests/haptics/device/drives/drive_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace touchline {
namespace {

template <class Machine>
class MotorPantographOf : public testing::Test {};

using Machines = testing::Types<MoteusMachine, OdriveMachine>;
TYPED_TEST_SUITE(MotorPantographOf, Machines);

template <class Machine>
void open(DriveRig<Machine>& rig) {
    const auto opened = rig.driver->open();
    ASSERT_TRUE(opened.has_value()) << opened.error().line;
}

TYPED_TEST(MotorPantographOf, OpensWithoutTorqueAndReadsTheTrueAngles) {
    DriveRig<TypeParam> rig;
    open(rig);
    EXPECT_EQ(rig.driver->report().state, DriveState::ready);
    EXPECT_FALSE(rig.driver->report().is_position_doubtful);
    const auto angles = rig.tick({});
    ASSERT_TRUE(angles.has_value());
    EXPECT_NEAR(norm(*angles - rig.plant().angles()), 0.0, 1e-3);
    for (const BridgeChange& change : rig.plant().changes())
        EXPECT_EQ(change.torques, ShaftTorques{});
}

TYPED_TEST(MotorPantographOf, EachJointHasItsOwnDirectionRatioAndZero) {
    DriveTruth truth;
    truth.drives.joint_1 = {Turn::clockwise, 0.5, 0.31};
    truth.drives.joint_2 = {Turn::counter_clockwise, 1.0, -7.2};
    DriveRig<TypeParam> rig(truth);
    open(rig);
    (void)rig.tick({});
    rig.tick_for(0.1, press);
    EXPECT_NEAR(norm(rig.held() - press), 0.0, 1e-4);
    const auto angles = rig.tick(press);
    ASSERT_TRUE(angles.has_value());
    EXPECT_NEAR(norm(*angles - rig.plant().angles()), 0.0, 0.01);
}

TYPED_TEST(MotorPantographOf, WholeTurnsOfTheEncodersDoNotMatter) {
    for (const double turns : {-3.0, 0.0, 5.0}) {
        DriveTruth truth;
        truth.drives.joint_1.zero_turns = turns;
        DriveRig<TypeParam> rig(truth);
        rig.connect({});
        open(rig);
        const auto angles = rig.tick({});
        ASSERT_TRUE(angles.has_value());
        EXPECT_NEAR(norm(*angles - rig.plant().angles()), 0.0, 1e-3) << turns;
    }
}

TYPED_TEST(MotorPantographOf, AGearedShaftLeavesThePlaceInDoubt) {
    DriveTruth truth;
    truth.drives.joint_1.ratio = 5.0;
    DriveRig<TypeParam> rig(truth);
    open(rig);
    EXPECT_TRUE(rig.driver->report().is_position_doubtful);
}

TYPED_TEST(MotorPantographOf, AnglesEveryTickAndNoCallWaits) {
    DriveRig<TypeParam> rig;
    open(rig);
    (void)rig.tick({});
    const std::uint64_t before = rig.driver->report().late;
    for (int k = 0; k < 1000; ++k) {
        const double due_s = rig.time.now_s + drive_tick_s;
        ASSERT_TRUE(rig.tick(press).has_value()) << k;
        ASSERT_TRUE(rig.is_written);
        ASSERT_EQ(rig.time.now_s, due_s);  // whoever waits moves the clock
    }
    EXPECT_EQ(rig.driver->report().late, before);
    EXPECT_EQ(rig.driver->report().wrong, 0U);
    EXPECT_EQ(rig.driver->report().set_ups, 1U);
}

TYPED_TEST(MotorPantographOf, TheHandIsPushedTheWayTheTorquesSay) {
    DriveTruth truth;
    truth.hand = no_hand;
    DriveRig<TypeParam> rig(truth);
    open(rig);
    const auto from = rig.tick({});
    rig.tick_for(0.02, {0.03, 0.0});
    const auto to = rig.tick({});
    ASSERT_TRUE(from.has_value() && to.has_value());
    EXPECT_GT(to->x - from->x, 0.01);
}

TYPED_TEST(MotorPantographOf, ZeroCountsOnceBothControllersHaveConfirmedIt) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.05, press);
    (void)rig.tick({});
    EXPECT_FALSE(rig.is_written);
    int ticks = 1;
    while (!rig.is_written && ticks < 10) {
        (void)rig.tick({});
        ++ticks;
    }
    EXPECT_EQ(rig.held(), JointTorques{});
    EXPECT_LE(ticks, 4);
    (void)rig.tick(press);
    (void)rig.tick({});
    EXPECT_FALSE(rig.is_written);
}

TYPED_TEST(MotorPantographOf, BothTorquesAreScaledTogetherAtTheLimit) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.05, {0.4, -0.2});
    const double limit = rig.plant().truth().profile.torque_limit_Nm;
    EXPECT_NEAR(rig.held().x, limit, 1e-4);
    EXPECT_NEAR(rig.held().y, -0.5 * limit, 1e-4);
}

TYPED_TEST(MotorPantographOf, ATorqueThatIsNotFiniteIsZeroAndReported) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        DriveRig<TypeParam> rig;
        open(rig);
        rig.tick_for(0.05, press);
        (void)rig.tick({0.01, bad});
        rig.pass(5e-4);
        EXPECT_EQ(rig.held(), JointTorques{});
        EXPECT_TRUE(rig.driver->report().was_torque_not_finite);
    }
}

// The watchdogs' own test: this computer died, and nobody said stop.
TYPED_TEST(MotorPantographOf, AHostThatFallsSilentLosesTheMotorsWithinTheStatedTime) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.1, press);
    const double last_s = rig.time.now_s;
    EXPECT_NEAR(norm(rig.held() - press), 0.0, 1e-4);
    rig.pass(watchdog_s - 0.002);
    EXPECT_NEAR(norm(rig.held() - press), 0.0, 1e-4);
    rig.pass(0.004);
    EXPECT_LE(rig.zero_from(last_s) - last_s, watchdog_s + 0.001);
    EXPECT_EQ(rig.bridges(), both_off);  // and not damped
    rig.pass(10.0);
    EXPECT_EQ(rig.held(), JointTorques{});
    EXPECT_EQ(rig.bridges(), both_off);
}

TYPED_TEST(MotorPantographOf, AHostThatWasSilentFindsItsWayBack) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.1, press);
    rig.pass(0.5);
    rig.tick_for(0.2, press);
    EXPECT_EQ(rig.driver->report().state, DriveState::ready);
    EXPECT_NEAR(norm(rig.held() - press), 0.0, 1e-4);
    EXPECT_FALSE(rig.driver->report().is_position_doubtful);
}

TYPED_TEST(MotorPantographOf, AFaultGivesNoForceAndIsToldInWords) {
    for (const std::size_t motor : {0U, 1U}) {
        DriveRig<TypeParam> rig;
        open(rig);
        rig.tick_for(0.05, press);
        rig.machine.fail(motor);
        const double failed_s = rig.time.now_s;
        rig.tick_for(0.1, press);
        EXPECT_EQ(rig.driver->report().state, DriveState::refused);
        EXPECT_EQ(rig.driver->report().trouble.motor, static_cast<int>(motor) + 1);
        EXPECT_LE(rig.zero_from(failed_s) - failed_s, 0.005);
        EXPECT_EQ(rig.bridges(), both_off);
        EXPECT_FALSE(rig.driver->write_torques(press));
        const std::string words = rig.driver->words();
        EXPECT_NE(words.find("motor " + std::to_string(motor + 1)), std::string::npos) << words;
        EXPECT_NE(words.find(TypeParam::fault_words()), std::string::npos) << words;
    }
}

TYPED_TEST(MotorPantographOf, LosingThePowerIsNoForceAndWithItThereIsAWayBack) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.1, press);
    rig.machine.switch_power(false);
    rig.tick_for(0.05, press);
    EXPECT_EQ(rig.driver->report().state, DriveState::setting_up);
    EXPECT_FALSE(rig.tick(press).has_value());
    rig.machine.switch_power(true);
    for (int k = 0; k < 20; ++k) {
        rig.tick_for(0.1, {});
        if (rig.driver->report().state == DriveState::ready) break;
    }
    EXPECT_EQ(rig.driver->report().state, DriveState::ready);
    rig.tick_for(0.1, press);
    EXPECT_NEAR(norm(rig.held() - press), 0.0, 1e-4);
}

TYPED_TEST(MotorPantographOf, WithoutPowerForGoodTheDeviceIsLostAndOpenSaysWhy) {
    DriveRig<TypeParam> rig;
    rig.machine.switch_power(false);
    const auto opened = rig.driver->open();
    ASSERT_FALSE(opened.has_value());
    EXPECT_NE(opened.error().line.find("does not answer"), std::string::npos);
    EXPECT_EQ(rig.driver->report().state, DriveState::lost);
    rig.machine.switch_power(true);
    open(rig);
}

TYPED_TEST(MotorPantographOf, UnpluggedIsLostAtOnceAndTheWatchdogsLetGo) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.1, press);
    rig.line->spoil(LineFault::unplugged);
    const double from_s = rig.time.now_s;
    EXPECT_FALSE(rig.tick(press).has_value());
    EXPECT_EQ(rig.driver->report().state, DriveState::lost);
    EXPECT_FALSE(rig.is_written);
    rig.tick_for(0.05, press);
    EXPECT_LE(rig.zero_from(from_s) - from_s, watchdog_s + 0.001);
    EXPECT_EQ(rig.bridges(), both_off);
    rig.connect({});
    open(rig);
}

TYPED_TEST(MotorPantographOf, ALateAnswerGivesTheAnglesBeforeForFourTicksAndThenNone) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.05, press);
    rig.line->spoil(LineFault::late_reply, 0.0305);
    int given = 0;
    const double from_s = rig.time.now_s;
    for (int k = 0; k < 25; ++k) given += rig.tick(press).has_value() ? 1 : 0;
    EXPECT_GE(given, 3);
    EXPECT_LE(given, 5);
    EXPECT_LE(rig.zero_from(from_s) - from_s, 0.008);
    rig.tick_for(0.3, press);
    EXPECT_EQ(rig.driver->report().state, DriveState::ready);
    EXPECT_NEAR(norm(rig.held() - press), 0.0, 1e-4);
}

TYPED_TEST(MotorPantographOf, NoFaultOfTheLineMakesAWrongAngleOrLeavesATorque) {
    for (const LineFault fault :
         {LineFault::lost_write, LineFault::cut_write, LineFault::garbled_write, LineFault::full,
          LineFault::lost_reply, LineFault::garbled_reply, LineFault::cut_reply,
          LineFault::late_reply}) {
        for (std::uint64_t seed = 1; seed <= 15; ++seed) {
            DriveRig<TypeParam> rig;
            open(rig);
            rig.tick_for(0.02, press);
            const double span_s = 0.0015 * static_cast<double>(seed);
            rig.line->spoil(fault, span_s, seed);
            for (int k = 0; k < 400; ++k) {
                const auto angles = rig.tick(press);
                if (angles) {
                    EXPECT_LT(norm(*angles - rig.plant().angles()), 0.05)
                        << static_cast<int>(fault) << ' ' << seed << ' ' << k;
                }
                const JointTorques held = rig.held();
                ASSERT_LE(norm(held), norm(press) + 1e-3)
                    << static_cast<int>(fault) << ' ' << seed << ' ' << k;
            }
            EXPECT_EQ(rig.driver->report().state, DriveState::ready)
                << static_cast<int>(fault) << ' ' << seed;
            EXPECT_NEAR(norm(rig.held() - press), 0.0, 1e-4);
        }
    }
}

TYPED_TEST(MotorPantographOf, AnEncoderThatLeapsGivesNoAnglesUntilThePlaceIsAccepted) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.05, press);
    rig.plant().leap(0, 0.1);
    const double from_s = rig.time.now_s;
    (void)rig.tick(press);  // its angles were on the way
    EXPECT_FALSE(rig.tick(press).has_value());
    rig.tick_for(0.01, press);
    EXPECT_EQ(rig.driver->report().state, DriveState::jumped);
    EXPECT_TRUE(rig.driver->report().is_position_doubtful);
    EXPECT_LE(rig.zero_from(from_s) - from_s, 0.0025);
    rig.driver->accept_position();
    rig.tick_for(0.01, {});
    EXPECT_TRUE(rig.tick({}).has_value());
}

TYPED_TEST(MotorPantographOf, ALeapOutlastsASetUp) {
    for (const int ticks : {2, 3, 20}) {  // the first brings angles from before
        DriveRig<TypeParam> rig;
        open(rig);
        rig.tick_for(0.05, press);
        rig.plant().leap(0, 0.1);
        for (int k = 0; k < ticks; ++k) (void)rig.tick(press);
        const double from_s = rig.time.now_s;
        rig.line->spoil(LineFault::late_reply, 0.0305);
        for (int k = 0; k < 300; ++k)
            ASSERT_FALSE(rig.tick(press).has_value()) << ticks << ' ' << k;
        EXPECT_GT(rig.driver->report().set_ups, 1U);
        EXPECT_EQ(rig.driver->report().state, DriveState::jumped) << ticks;
        EXPECT_TRUE(rig.driver->report().is_position_doubtful);
        EXPECT_LE(rig.zero_from(from_s) - from_s, 0.0025);
        rig.driver->accept_position();
        rig.tick_for(0.01, {});
        EXPECT_TRUE(rig.tick({}).has_value());
        EXPECT_EQ(rig.driver->report().state, DriveState::ready);
    }
}

/// Some other thing at the port: it prints a line every 100 ms, whatever it is told.
class ChattyPort final : public ByteLink {
  public:
    explicit ChattyPort(VirtualTime& time) : time_(time) {}

    [[nodiscard]] bool write(std::span<const std::uint8_t>) override { return true; }

    [[nodiscard]] std::size_t read(std::span<std::uint8_t> room) override {
        constexpr std::string_view line = "temperature 21\r\n";
        if (time_.now_s < next_s_ || room.size() < line.size()) return 0;
        next_s_ = time_.now_s + 0.1;
        std::ranges::copy(line, room.begin());
        return line.size();
    }

    /// So that a driver that waits for ever fails here.
    [[nodiscard]] bool is_gone() const override { return time_.now_s > 20.0; }

    void rest(double span_s) override { time_.now_s += span_s; }

  private:
    VirtualTime& time_;
    double next_s_ = 0.0;
};

TYPED_TEST(MotorPantographOf, SomethingElseThatTalksAtThePortIsToldInTime) {
    VirtualTime time;
    MotorPantograph driver(TypeParam::pair_over(std::make_unique<ChattyPort>(time)),
                           DriveTruth{}.profile, {});
    const auto opened = driver.open();
    ASSERT_FALSE(opened.has_value());
    EXPECT_NE(opened.error().line.find("does not answer"), std::string::npos)
        << opened.error().line;
    EXPECT_LE(time.now_s, 3.0);
    EXPECT_EQ(driver.report().state, DriveState::lost);
}

TYPED_TEST(MotorPantographOf, StopLetsGoIsConfirmedAndNothingFollows) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.05, press);
    EXPECT_TRUE(rig.driver->stop());
    rig.pass(0.001);
    EXPECT_EQ(rig.held(), JointTorques{});
    EXPECT_EQ(rig.bridges(), both_off);
    EXPECT_FALSE(rig.driver->read_angles(1.0).has_value());
    EXPECT_FALSE(rig.driver->write_torques(press));
}

TYPED_TEST(MotorPantographOf, StopIsNotConfirmedWithoutAnAnswer) {
    DriveRig<TypeParam> rig;
    open(rig);
    rig.tick_for(0.05, press);
    rig.line->spoil(LineFault::lost_reply, 10.0);
    EXPECT_FALSE(rig.driver->stop());
    rig.pass(0.03);
    EXPECT_EQ(rig.bridges(), both_off);
}

TYPED_TEST(MotorPantographOf, TheNudgeTestFindsWhatItFindsOfABoard) {
    for (const bool have_power : {true, false}) {
        DriveTruth truth;
        truth.hand = no_hand;
        truth.have_motors_power = have_power;
        DriveRig<TypeParam> rig(truth);
        open(rig);
        NudgeTest test(encoder_quantum(truth.profile));
        JointTorques torques;
        for (int k = 0; k < 5000 && test.verdict() == NudgeVerdict::running; ++k) {
            const auto angles = rig.tick(torques);
            torques = test.step(angles, drive_tick_s);
        }
        EXPECT_EQ(test.verdict(), have_power ? NudgeVerdict::works : NudgeVerdict::no_power);
    }
}

}  // namespace
}  // namespace touchline
