// The driver against the emulated board: how it copes with each habit of the firmware.
#include "haptics/device/board/pantograph_board.h"

#include "tests/machines/sim/board/board_rig.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr JointTorques push{0.03, -0.02};

BoardTruth truth_of(const char* profile, BoardType type = BoardType::m0) {
    BoardTruth truth;
    truth.profile = find_profile(profile).value();
    truth.type = type;
    return truth;
}

double far_apart(JointTorques a, JointTorques b) {
    return norm(a - b);
}

TEST(PantographBoard, OpensEveryKnownDeviceAndReadsItsHome) {
    for (const auto& [name, type] :
         {std::pair{"2diy-gen2", BoardType::m0}, std::pair{"2diy-gen3", BoardType::m0},
          std::pair{"2diy-gen3.1", BoardType::m0}, std::pair{"haplet", BoardType::due},
          std::pair{"mk2", BoardType::due}}) {
        BoardRig rig(truth_of(name, type));
        ASSERT_TRUE(rig.driver->open().has_value()) << name;
        EXPECT_EQ(rig.driver->report().state, BoardState::ready);
        const auto angles = rig.tick({});
        ASSERT_TRUE(angles.has_value()) << name;
        EXPECT_NEAR(norm(*angles - rig.board.truth().profile.home), 0.0, 1e-6) << name;
        EXPECT_FALSE(rig.driver->report().is_position_doubtful);
    }
}

TEST(PantographBoard, FirstBytesAreTheSetUpThenAZeroWrite) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    const auto& commands = rig.link->commands();
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_EQ(commands[0].size(), 26U);
    EXPECT_EQ(commands[0][0], 1);
    EXPECT_EQ(commands[1], (PacketBytes{2, 5, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(PantographBoard, OneWriteAndOneReplyATickWithoutEverWaiting) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    const std::size_t before = rig.link->commands().size();
    for (int k = 0; k < 1000; ++k) {
        const double due_s = rig.time.now_s + rig_tick_s;
        ASSERT_TRUE(rig.tick(push).has_value()) << k;
        ASSERT_TRUE(rig.is_written);
        ASSERT_EQ(rig.time.now_s, due_s);  // whoever waits moves the clock
    }
    EXPECT_EQ(rig.link->commands().size(), before + 1000);
    EXPECT_EQ(rig.driver->report().late, 0U);
    EXPECT_EQ(rig.driver->report().resyncs, 1U);  // to open
}

TEST(PantographBoard, TorquesAndAnglesBelongToTheirJoints) {
    for (const char* name : {"2diy-gen2", "2diy-gen3.1", "haplet"}) {
        for (const bool are_swapped : {false, true}) {
            BoardTruth truth =
                truth_of(name, std::string(name) == "haplet" ? BoardType::due : BoardType::m0);
            truth.motors.are_swapped = truth.encoders.are_swapped = are_swapped;
            Calibration calibration;
            calibration.motors.are_swapped = calibration.encoders.are_swapped = are_swapped;
            // The direction of a joint's own turn on the other port depends on what that port is
            // told.
            const bool is_turned = are_swapped && std::string(name) == "2diy-gen2";
            calibration.motors.is_1_reversed = calibration.motors.is_2_reversed = is_turned;
            calibration.encoders = calibration.motors;
            BoardRig rig(truth, {}, calibration);
            ASSERT_TRUE(rig.driver->open().has_value());
            (void)rig.tick({});
            rig.tick_for(0.1, push);
            EXPECT_LT(far_apart(rig.held(), push), 1e-3) << name;
            const auto angles = rig.tick(push);
            ASSERT_TRUE(angles.has_value());
            // A tick of motion and a count apart; the arm moves farther than that.
            EXPECT_NEAR(angles->x, rig.board.true_angles().x, 0.02) << name;
            EXPECT_NEAR(angles->y, rig.board.true_angles().y, 0.02) << name;
            EXPECT_GT(norm(*angles - truth.profile.home), 0.05) << name;
        }
    }
}

TEST(PantographBoard, SwappedPlugsThatNobodySetMirrorTheMotion) {
    BoardTruth truth = truth_of("2diy-gen3.1");
    truth.motors.are_swapped = truth.encoders.are_swapped = true;
    BoardRig rig(truth);
    ASSERT_TRUE(rig.driver->open().has_value());
    (void)rig.tick({});
    rig.tick_for(0.02, push);
    EXPECT_LT(far_apart(rig.held(), {push.y, push.x}), 1e-3);
}

TEST(PantographBoard, LastTorqueIsHeldForEverWhenTheHostFallsSilent) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.1, push);
    rig.time.now_s += 60.0;
    EXPECT_LT(far_apart(rig.held(), push), 1e-3);
}

TEST(PantographBoard, DueAnswersBecauseTheLinesAreUp) {
    BoardRig rig(truth_of("haplet", BoardType::due));
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.board.set_lines(false, false);
    rig.tick_for(0.03, {});
    EXPECT_EQ(rig.driver->report().state, BoardState::resyncing);
    rig.board.set_lines(true, true);
    rig.tick_for(3.0, {});
    EXPECT_EQ(rig.driver->report().state, BoardState::ready);
}

TEST(PantographBoard, NeverKillsTheFirmwareWith1200Baud) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.01, {});
    rig.driver.reset();
    EXPECT_FALSE(rig.board.is_boot_loader());
    // The emulator would notice.
    rig.board.set_line_coding(1200);
    rig.board.set_lines(false, false);
    EXPECT_TRUE(rig.board.is_boot_loader());
    EXPECT_EQ(rig.board.product(), 0x004d);
    rig.connect();
    EXPECT_FALSE(rig.driver->open().has_value());
}

TEST(PantographBoard, WithoutMotorPowerAnglesAreFineAndTorqueDoesNothing) {
    BoardTruth truth;
    truth.have_motors_power = false;
    BoardRig rig(truth);
    ASSERT_TRUE(rig.driver->open().has_value());
    const auto before = rig.tick({});
    rig.tick_for(0.2, {0.02, 0.02});
    const auto after = rig.tick({});
    ASSERT_TRUE(before && after);
    EXPECT_LE(norm(*after - *before), 1.5 * encoder_quantum(truth.profile).x);
    rig.board.switch_motors(true);
    rig.tick_for(0.2, {0.02, 0.02});
    EXPECT_GT(norm(rig.tick({}).value() - *before), 4.0 * encoder_quantum(truth.profile).x);
}

TEST(PantographBoard, SlowDriftShowsAsAShiftThatNobodySignals) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    const JointAngles before = rig.tick({}).value();
    for (int i = 0; i < 10; ++i) {
        rig.board.lose_counts(1, 1);
        rig.tick_for(0.05, {});
    }
    const JointAngles after = rig.tick({}).value();
    const double quantum_rad = encoder_quantum(rig.board.truth().profile).x;
    EXPECT_NEAR(after.x - before.x, -10.0 * quantum_rad, 0.501 * quantum_rad);
    EXPECT_EQ(rig.driver->report().state, BoardState::ready);
    EXPECT_EQ(rig.driver->report().jumps, 0U);
}

TEST(PantographBoard, SetUpAwayFromHomeShiftsEveryAngleAndAnOffsetMendsIt) {
    const DeviceProfile profile = default_profile();
    const auto path =
        std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{{0.0, {0.01, 0.01}}});
    BoardRig rig({}, {}, {}, path);
    ASSERT_TRUE(rig.driver->open().has_value());
    const JointAngles said = rig.tick({}).value();
    EXPECT_NEAR(norm(said - profile.home), 0.0, 1e-6);
    Calibration calibration;
    calibration.offset = rig.board.true_angles() - said;
    rig.driver->set_calibration(calibration);
    EXPECT_NEAR(norm(rig.tick({}).value() - rig.board.true_angles()), 0.0, 1e-6);
}

TEST(PantographBoard, NewCalibrationHoldsFromTheNextTickOn) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    const JointAngles before = rig.tick({}).value();
    Calibration swapped;
    swapped.motors.are_swapped = true;
    swapped.torque_limit_Nm = 0.01;
    rig.driver->set_calibration(swapped);
    EXPECT_EQ(rig.tick({}).value(), before);
    rig.tick_for(0.01, {0.1, -0.05});
    EXPECT_LT(far_apart(rig.held(), {-0.005, 0.01}), 2e-4);
    rig.driver->set_calibration({});
    rig.tick_for(0.01, push);
    EXPECT_LT(far_apart(rig.held(), push), 1e-3);
}

TEST(PantographBoard, TorqueThatIsNotANumberIsZeroAtOnceAndReported) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const JointTorques bad : {JointTorques{nan, 0.02}, JointTorques{0.02, -1.0 / 0.0}}) {
        BoardRig rig;
        ASSERT_TRUE(rig.driver->open().has_value());
        rig.tick_for(0.05, push);
        EXPECT_FALSE(rig.driver->report().was_torque_not_finite);
        (void)rig.tick(bad);
        rig.time.now_s += 0.5 * rig_tick_s;
        EXPECT_EQ(rig.held(), JointTorques{});
        EXPECT_TRUE(rig.driver->report().was_torque_not_finite);
    }
}

TEST(PantographBoard, TimeThatStandsStillOrIsNotANumberHarmsNothing) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    rig.tick_for(0.05, push);
    (void)rig.driver->read_angles(std::numeric_limits<double>::quiet_NaN());
    (void)rig.driver->read_angles(-5.0);
    rig.tick_for(0.05, push);
    EXPECT_TRUE(rig.tick(push).has_value());
}

}  // namespace
}  // namespace touchline
