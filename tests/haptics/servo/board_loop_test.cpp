// The servo's loop with the driver and an emulated board instead of the simulated pantograph.
#include "haptics/servo/servo_loop.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/machines/sim/board/board_rig.h"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// The calibration of a hand that starts at a known place in the area, as after homing.
Calibration known_start(const DeviceProfile& profile, Position p_W) {
    Calibration calibration;
    calibration.offset = angles_at(profile, p_W) - profile.home;
    return calibration;
}

std::shared_ptr<const IntendedPath> into_the_line() {
    return std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{
        {0.0, {0.0, -0.015}}, {1.5, {0.0, -0.015}}, {2.5, {0.0, 0.01}}, {4.0, {0.01, 0.01}}});
}

class BoardLoop : public testing::Test {
  protected:
    void feel_line() {
        exchange.feel(line_scene(0.0));
        ServoCommands commands;
        commands.contact.mode = Mode::wall;
        exchange.set(commands);
    }

    void tick_to(double end_s) {
        for (; now_s < end_s; now_s += 1e-3) {
            rig.time.now_s += 1e-3;
            loop.tick(now_s, 0);
        }
    }

    DeviceProfile profile = default_profile();
    BoardRig rig{{}, {}, known_start(profile, {0.0, -0.015}), into_the_line()};
    ServoExchange exchange;
    Recorder recorder{0};
    ServoLoop loop{*rig.driver, profile, 1e-3, exchange, recorder};
    double now_s = 0.0;
};

TEST_F(BoardLoop, AWallIsFeltThroughTheWholeWay) {
    ASSERT_TRUE(rig.driver->open().has_value());
    feel_line();
    tick_to(3.5);
    const HandState hand = exchange.report().hand;
    EXPECT_NE(hand.state, ContactState::free);
    EXPECT_LT(hand.force.y, -0.3);  // back down, out of the wall
    EXPECT_GT(norm(rig.held()), 0.005);
    EXPECT_LT(rig.board.plant().tip().position.y, 0.006);  // the hand means to be at 10 mm
    EXPECT_NEAR(hand.p_WH.y, rig.board.plant().tip().position.y, 0.001);
    EXPECT_EQ(rig.driver->report().resyncs, 1U);
}

/// Returns the root mean square of the tip's speed across a line that a light hand follows and
/// presses.
double shake_m_per_s(bool do_counts_step_back, int& faults) {
    const DeviceProfile& profile = default_profile();
    BoardTruth truth;
    truth.do_counts_step_back = do_counts_step_back;
    truth.hand = light_hand;
    const auto along = std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{
        {0.0, {0.0, -0.015}}, {1.5, {0.0, -0.015}}, {2.5, {0.0, 0.008}}, {8.0, {0.02, 0.008}}});
    BoardRig rig(truth, {}, known_start(profile, {0.0, -0.015}), along);
    if (!rig.driver->open()) return 1.0;
    ServoExchange exchange;
    Recorder recorder{0};
    ServoLoop loop{*rig.driver, profile, 1e-3, exchange, recorder};
    exchange.feel(line_scene(0.0));
    ServoCommands commands;
    commands.contact.mode = Mode::wall;
    exchange.set(commands);
    double squares = 0.0;
    int ticks = 0;
    for (double now_s = 0.0; now_s < 7.5; now_s += 1e-3) {
        rig.time.now_s += 1e-3;
        loop.tick(now_s, 0);
        faults += exchange.report().force.fault != Fault::none ? 1 : 0;
        if (now_s < 3.0) continue;
        const double across = rig.board.plant().tip().velocity.y;
        squares += across * across;
        ++ticks;
    }
    return std::sqrt(squares / ticks);
}

// 1.9 mm/s against 1.1 is accepted; without the play of half a count it was 3.7 against 1.2.
TEST(BoardLoopCounts, ACounterThatStepsBackShakesLittleMoreAndDoesNotTrip) {
    int faults = 0;
    EXPECT_LT(shake_m_per_s(false, faults), 0.00125);
    EXPECT_LT(shake_m_per_s(true, faults), 0.0021);
    EXPECT_EQ(faults, 0);
}

TEST_F(BoardLoop, UnpluggedInTheWallIsAFaultAndTheLoopGoesOn) {
    ASSERT_TRUE(rig.driver->open().has_value());
    feel_line();
    tick_to(3.5);
    rig.board.unplug();
    tick_to(3.6);
    EXPECT_EQ(exchange.report().force.state, ForceState::fault);
    EXPECT_EQ(exchange.report().force.fault, Fault::device_lost);
    EXPECT_EQ(rig.held(), JointTorques{});
    tick_to(3.8);
    EXPECT_EQ(exchange.report().hand.force, Force{});
}

}  // namespace
}  // namespace touchline
