// Tests every way to plug in and reverse motors and encoders, up to a wall that a hand presses
// against: each ends right or is refused, and none pushes the hand on through the wall.
#include "haptics/servo/servo_loop.h"
#include "tests/app/force/device/device_visit.h"
#include "tests/haptics/servo/rigs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double nudge_Nm = 0.0305;  // the most that the motor test may tell, to a step of the duty

/// The motors' force on the hand, across the line, in the picture: up pushes on through the wall.
double made_force_y_N(const BoardEmulator& board) {
    const auto pose = forward(board.truth().profile.geometry, board.true_angles());
    const auto force_D = pose ? tip_force(pose->jacobian, board.plant().torques()) : std::nullopt;
    return force_D ? turned(*force_D).y : 0.0;
}

struct Pressed {
    double most_on_N = 0.0;  // through the wall, at most
    double at_last_N = 0.0;  // at the end, while the hand presses
    double tip_off_m = 0.0;  // between the true tip and the loop's tip
};

/// Presses from below against a line through the middle of the picture.
Pressed press(DeviceVisit& visit) {
    constexpr Position below{0.0, -0.015}, beyond{0.0, 0.008};
    Pressed pressed;
    visit.rig.board.grip(normal_hand);
    visit.person->go(below, visit.rig.time.now_s);
    visit.rig.tick_for(1.0, {});
    ServoExchange exchange;
    Recorder recorder{0};
    ServoLoop loop{*visit.rig.driver, visit.rig.driver->frame().calibrated_profile(), 1e-3,
                   exchange, recorder};
    exchange.feel(line_scene(0.0));
    ServoCommands commands;
    commands.contact.mode = Mode::wall;
    exchange.set(commands);
    for (double now_s = 0.0; now_s < 2.5; now_s += 1e-3) {
        if (std::abs(now_s - 1.0) < 5e-4) visit.person->go(beyond, visit.rig.time.now_s);
        visit.rig.time.now_s += 1e-3;
        loop.tick(now_s, 0);
        visit.rig.board.advance_to(visit.rig.time.now_s);
        pressed.at_last_N = made_force_y_N(visit.rig.board);
        pressed.most_on_N = std::max(pressed.most_on_N, pressed.at_last_N);
    }
    const Position tip = visit.rig.board.plant().tip().position;
    pressed.tip_off_m = norm(exchange.report().hand.p_WH - tip);
    return pressed;
}

double most_told_Nm(const BoardEmulator& board) {
    double most = 0.0;
    for (const TorqueChange& change : board.told_torques())
        most = std::max({most, std::abs(change.torques.x), std::abs(change.torques.y)});
    return most;
}

struct Wires {
    std::uint32_t motors = 0, encoders = 0;  // as number_of() counts them
};

void PrintTo(const Wires& wires, std::ostream* out) {
    *out << "motors " << wires.motors << ", encoders " << wires.encoders;
}

std::vector<Wires> wires_of(const std::vector<std::uint32_t>& numbers) {
    std::vector<Wires> all;
    for (const std::uint32_t motors : numbers)
        for (const std::uint32_t encoders : numbers) all.push_back({motors, encoders});
    return all;
}

BoardTruth plugged(const Wires& wires) {
    BoardTruth truth;
    truth.hand = stiff_arm;
    truth.motors = plugs_of(wires.motors);
    truth.encoders = plugs_of(wires.encoders);
    return truth;
}

/// Motors by encoders: each on its own port or the other's, each joint in either direction.
class Plugged : public testing::TestWithParam<Wires> {
  protected:
    /// Returns the calibration once the unit became ready. Until then only nudges are told.
    static std::optional<Calibration> made_ready(DeviceVisit& visit, const Calibration& stored) {
        visit.end_s = visit.rig.time.now_s + 250.0;
        EXPECT_TRUE(visit.rig.driver->open().has_value());
        const auto ready = make_ready(visit.procedure(), stored);
        EXPECT_LE(most_told_Nm(visit.rig.board), nudge_Nm);
        EXPECT_EQ(visit.rig.held(), JointTorques{});
        return ready ? std::optional(*ready) : std::nullopt;
    }

    static void expect_a_wall(DeviceVisit& visit) {
        const Pressed pressed = press(visit);
        EXPECT_LT(pressed.most_on_N, 0.1);
        EXPECT_LT(pressed.at_last_N, -0.3);
        EXPECT_LT(pressed.tip_off_m, 1e-3);
    }
};

class NewlyPlugged : public Plugged {};

class Replugged : public Plugged {};

TEST_P(NewlyPlugged, AUnitEndsRight) {
    DeviceVisit visit(plugged(GetParam()));
    const auto unit = made_ready(visit, {});
    ASSERT_TRUE(unit.has_value()) << visit.person->heard.back();
    // From now on the unit is known.
    visit.rig.connect({}, *unit);
    visit.person->go({}, visit.rig.time.now_s);
    visit.person->heard.clear();
    ASSERT_TRUE(made_ready(visit, *unit).has_value()) << visit.person->heard.back();
    EXPECT_FALSE(visit.was_heard("wrong order"));
    EXPECT_FALSE(visit.was_heard("measured"));
    expect_a_wall(visit);
}

/// Everything was as usual when the unit was measured; somebody has plugged it differently since.
/// Homing notices encoders, and the unit is measured anew; motors alone are refused.
TEST_P(Replugged, AKnownUnitEndsRightOrIsRefused) {
    Calibration stored;
    stored.is_measured = true;
    DeviceVisit visit(plugged(GetParam()), stored);
    const bool is_ready = made_ready(visit, stored).has_value();
    if (is_ready) expect_a_wall(visit);
    // With everything exchanged and reversed it is the mirror image, which two stops cannot tell
    // apart.
    const bool is_unseen = GetParam().encoders == 0 || GetParam().encoders == 7;
    const bool is_refused = is_unseen && GetParam().motors != GetParam().encoders;
    EXPECT_EQ(is_ready, !is_refused) << visit.person->heard.back();
    EXPECT_EQ(visit.was_heard("There is no force."), is_refused);
}

INSTANTIATE_TEST_SUITE_P(Every, NewlyPlugged,
                         testing::ValuesIn(wires_of({0, 1, 2, 3, 4, 5, 6, 7})));
// Ports as usual or exchanged; both motors in either direction, and both encoders too.
INSTANTIATE_TEST_SUITE_P(Sixteen, Replugged, testing::ValuesIn(wires_of({0, 1, 6, 7})));

/// A person who confuses right and left both times gets a mirrored picture, but the force is right.
TEST(PluggedAsUsual, WhoTakesRightForLeftIsNotPushedOn) {
    DeviceVisit visit(plugged({}));
    visit.person->mistake_left();
    visit.end_s = 250.0;
    ASSERT_TRUE(visit.rig.driver->open().has_value());
    const auto ready = make_ready(visit.procedure(), {});
    EXPECT_TRUE(visit.was_heard("wrong order"));
    ASSERT_TRUE(ready.has_value()) << visit.person->heard.back();
    EXPECT_EQ(number_of(ready->encoders), 7U);
    const Pressed pressed = press(visit);
    EXPECT_LT(pressed.most_on_N, 0.1);
}

}  // namespace
}  // namespace touchline
