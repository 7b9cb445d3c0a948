// A handle that turns: the third motor on the wire, through the driver and in the simulation.
#include "haptics/device/board/hapi.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/machines/sim/board/board_rig.h"

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

DeviceProfile turning() {
    return find_profile("gen3.1-turning").value();
}

double count_rad() {
    return encoder_quantum_rad(*turning().handle);
}

/// Turns from one angle to another within a second, with the tip at home.
std::shared_ptr<const IntendedPath> turning_hand(double from_rad, double to_rad) {
    const Position home = forward(turning().geometry, turning().home).value().p_DH;
    const Position place = picture_from_device(turning(), home);
    return std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.2, place, from_rad}, {1.2, place, to_rad}});
}

BoardTruth board_with_handle() {
    BoardTruth truth;
    truth.profile = turning();
    truth.type = BoardType::due;
    return truth;
}

BoardRig opened_rig(std::shared_ptr<const IntendedPath> hand = turning_hand(0.0, 0.0)) {
    BoardRig rig(board_with_handle(), {}, {}, std::move(hand));
    EXPECT_TRUE(rig.driver->open().has_value());
    (void)rig.tick({});
    return rig;
}

double told_handle_Nm(BoardRig& rig) {
    (void)rig.held();
    return rig.board.told_torques().back().handle_Nm;
}

TEST(TurningHandle, ThreeMotorsOnTheWire) {
    const BoardFrame frame(turning(), {});
    const auto set_up = set_up_command(frame.set_up_at_home());
    ASSERT_EQ(set_up.bytes().size(), 36U);
    EXPECT_EQ(set_up.bytes()[2], 0b111);  // motors
    EXPECT_EQ(set_up.bytes()[6], 0b111);  // encoders
    const auto write = write_command({0.05, -0.05}, 0.05);
    EXPECT_EQ(PacketBytes(write.bytes().begin(), write.bytes().end()),
              (PacketBytes{2, 5, 0xcd, 0xcc, 0x4c, 0x3d, 0xcd, 0xcc, 0x4c, 0xbd, 0xcd, 0xcc, 0x4c,
                           0x3d}));
    EXPECT_EQ(write_command({}, nan_value).bytes().back(), 0);
    const PacketBytes reply{5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x34, 0x43};
    const Reply decoded = decode_reply(reply, 0, true);
    EXPECT_EQ(decoded.kind, ReplyKind::angles);
    EXPECT_EQ(decoded.handle_deg, 180.0);
    EXPECT_EQ(decode_reply(reply).kind, ReplyKind::wrong);
}

TEST(TurningHandle, ADeviceWithoutOneSaysNothingOfIt) {
    BoardRig rig;
    ASSERT_TRUE(rig.driver->open().has_value());
    (void)rig.tick({});
    EXPECT_FALSE(rig.driver->handle_angle_rad().has_value());
    rig.driver->turn_handle(0.05);
    (void)rig.tick({});
    EXPECT_EQ(rig.link->commands().back().size(), write_bytes);
}

TEST(TurningHandle, TheDriverReadsHowFarItIsTurned) {
    BoardRig rig = opened_rig(turning_hand(0.0, 2.0));
    EXPECT_EQ(rig.driver->handle_angle_rad(), 0.0);
    rig.tick_for(2.0, {});
    ASSERT_TRUE(rig.driver->handle_angle_rad().has_value());
    const double truth_rad = rig.board.plant().handle()->angle_rad();
    EXPECT_NEAR(*rig.driver->handle_angle_rad(), truth_rad, 1.01 * count_rad());
    EXPECT_NEAR(truth_rad, 2.0, 0.1);
    EXPECT_EQ(rig.driver->report().jumps, 0U);
}

TEST(TurningHandle, ItsTorqueGoesOutWithTheNextWriteOnly) {
    BoardRig rig = opened_rig();
    rig.driver->turn_handle(0.05);
    rig.tick_for(0.003, {});
    double most_Nm = 0.0;
    for (const TorqueChange& change : rig.board.told_torques())
        most_Nm = std::max(most_Nm, change.handle_Nm);
    EXPECT_NEAR(most_Nm, 0.05, 1e-3);
    EXPECT_EQ(told_handle_Nm(rig), 0.0);
}

TEST(TurningHandle, ItsTorqueIsHeldToItsLimitAndNoNumberIsZero) {
    BoardRig rig = opened_rig();
    const auto told_after = [&rig](double torque_Nm) {
        rig.driver->turn_handle(torque_Nm);
        (void)rig.tick({});
        rig.time.now_s += 5e-4;
        return told_handle_Nm(rig);
    };
    EXPECT_NEAR(told_after(-1.0), -turning().handle->torque_limit_Nm, 1e-3);
    EXPECT_EQ(told_after(nan_value), 0.0);
    EXPECT_TRUE(rig.driver->report().was_torque_not_finite);
}

TEST(TurningHandle, AResyncKeepsItsAngleAndStopsItsMotor) {
    BoardRig rig = opened_rig(turning_hand(0.0, 1.0));
    rig.tick_for(2.0, {});
    rig.driver->turn_handle(0.02);
    (void)rig.tick({});
    rig.board.host_sends(reset_command().bytes());  // the board forgets its set-up
    rig.tick_for(0.1, {});
    EXPECT_EQ(rig.driver->report().state, BoardState::ready);
    ASSERT_TRUE(rig.driver->handle_angle_rad().has_value());
    const double truth_rad = rig.board.plant().handle()->angle_rad();
    EXPECT_NEAR(*rig.driver->handle_angle_rad(), truth_rad, 3.0 * count_rad());
    EXPECT_EQ(told_handle_Nm(rig), 0.0);
}

TEST(TurningHandle, StoppingStopsItsMotorToo) {
    BoardRig rig = opened_rig();
    rig.driver->turn_handle(0.05);
    (void)rig.tick({});
    EXPECT_TRUE(rig.driver->stop());
    EXPECT_EQ(told_handle_Nm(rig), 0.0);
}

TEST(TurningHandle, WhoeverKnowsItsProfileIsToldThatItIsZero) {
    BoardRig rig = opened_rig();
    rig.driver->turn_handle(0.05);
    (void)rig.tick({});
    EXPECT_TRUE(zero_torque(std::make_unique<EmulatedLink>(rig.board, rig.time), turning()));
    EXPECT_EQ(told_handle_Nm(rig), 0.0);
}

TEST(TurningHandle, AProgramThatKnowsOfNoHandleStopsItsMotorToo) {
    BoardRig rig = opened_rig();
    rig.driver->turn_handle(0.05);
    (void)rig.tick({});
    // With another profile's counts it cannot tell whether the answers are good.
    (void)zero_torque(std::make_unique<EmulatedLink>(rig.board, rig.time));
    EXPECT_EQ(told_handle_Nm(rig), 0.0);
}

TEST(TurningHandle, InTheSimulationItFollowsTheFingersAndItsMotor) {
    SimulatedPantograph device(turning(), {}, turning_hand(0.0, 0.5));
    const auto run_to = [&device](double from_s, double to_s, double torque_Nm) {
        for (double t_s = from_s; t_s < to_s; t_s += 1e-3) {
            (void)device.read_angles(t_s);
            device.turn_handle(torque_Nm);
            ASSERT_TRUE(device.write_torques({}));
        }
    };
    run_to(0.0, 3.0, 0.0);
    const double free_rad = device.handle_angle_rad().value();
    EXPECT_NEAR(free_rad, 0.5, 0.05);  // friction over the fingers' spring
    run_to(3.0, 5.0, 0.006);
    // The fingers' spring: 300 N/m at 10 mm.
    EXPECT_NEAR(device.handle_angle_rad().value() - free_rad, 0.006 / 0.03, 0.07);
    SimulatedPantograph plain(default_profile(), {}, turning_hand(0.0, 0.5));
    (void)plain.read_angles(1.0);
    EXPECT_FALSE(plain.handle_angle_rad().has_value());
}

}  // namespace
}  // namespace touchline
