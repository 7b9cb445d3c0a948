// Homing: a hand that follows the words, and hands that do not.
#include "haptics/device/homing.h"

#include "haptics/pantograph/kinematics.h"
#include "haptics/pantograph/profile.h"
#include "tests/haptics/tick.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr JointAngles retracted{168.0 * degree, 12.0 * degree};
constexpr JointAngles extended{97.23 * degree, 82.77 * degree};
const HomingPlan gen31 = homing_plan(default_profile());
constexpr JointAngles unity{1.0, 1.0};

/// Where a hand goes and how long it stays.
struct Stay {
    JointAngles at;
    double rest_s = 0.0;
};

/// Encoders that start counting at home wherever the arms stand, as the board's do.
struct Unit {
    JointAngles scale = unity;  // true turn per turn read
    JointAngles told_home;      // angles at which the set-up was sent
    bool is_swapped = false;

    [[nodiscard]] JointAngles read(JointAngles angles) const {
        const auto count = [](double turn, double scale_of_joint, double quantum) {
            return quantum * std::trunc(turn / scale_of_joint / quantum);
        };
        const JointAngles turn{count(angles.x - told_home.x, scale.x, gen31.quantum.x),
                               count(angles.y - told_home.y, scale.y, gen31.quantum.y)};
        return retracted + (is_swapped ? JointAngles{turn.y, turn.x} : turn);
    }
};

/// Goes from stay to stay at 1 rad/s, trembling by a tenth of a degree.
HomingView lead(Homing& homing, const Unit& unit, const std::vector<Stay>& stays) {
    HomingView view;
    // Every way begins with a small motion to and fro, as the first words ask for.
    JointAngles at = stays.front().at + 0.1 * (extended - retracted);
    double t_s = 0.0;
    const auto tick = [&] {
        t_s += tick_s;
        const double tremble = 0.1 * degree * std::sin(60.0 * t_s);
        view = homing.step(unit.read(at + JointAngles{tremble, -tremble}), tick_s);
    };
    for (const Stay& stay : stays) {
        while (norm(stay.at - at) > tick_s) {
            at += tick_s / norm(stay.at - at) * (stay.at - at);
            tick();
        }
        at = stay.at;
        for (double s = 0.0; s < stay.rest_s; s += tick_s) tick();
    }
    return view;
}

JointAngles between(double share) {
    return retracted + share * (extended - retracted);
}

TEST(Homing, OneWayIsEnoughWhereTheScaleIsKnown) {
    Homing homing(gen31, Calibration{});
    EXPECT_EQ(lead(homing, {unity, retracted, false}, {{retracted, 4.5}}).step,
              HomingStep::to_check);
    const HomingView view =
        lead(homing, {unity, retracted, false}, {{retracted, 0.1}, {extended, 4.5}});
    EXPECT_EQ(view.step, HomingStep::done);
    EXPECT_EQ(view.remark, HomingRemark::none);
    EXPECT_LT(view.misfit_m, 1e-3);
}

TEST(Homing, ShiftsWhatTheBoardTellsToWhereTheArmsAre) {
    // The board was set up with the handle 20 degrees from home.
    const Unit unit{unity, between(0.3), false};
    Homing homing(gen31, Calibration{});
    ASSERT_EQ(lead(homing, unit, {{retracted, 4.5}, {extended, 4.5}}).step, HomingStep::done);
    const Calibration found = homing.calibration();
    const JointAngles middle = retracted + found.offset + (unit.read(between(0.5)) - retracted);
    EXPECT_NEAR(middle.x, between(0.5).x, 0.4 * degree);
    EXPECT_NEAR(middle.y, between(0.5).y, 0.4 * degree);
}

TEST(Homing, MeasuresTheScaleOfAUnitByTwoVisits) {
    const Unit unit{{1.06, 0.95}, retracted, false};
    Homing homing(gen31, std::nullopt);
    const HomingView half = lead(homing, unit, {{retracted, 4.5}, {extended, 4.5}});
    EXPECT_EQ(half.step, HomingStep::to_home_again);
    const HomingView view =
        lead(homing, unit, {{extended, 0.1}, {retracted, 4.5}, {extended, 4.5}});
    EXPECT_EQ(view.step, HomingStep::done);
    EXPECT_EQ(view.remark, HomingRemark::measured);
    EXPECT_NEAR(homing.calibration().scale.x, 1.06, 0.01);
    EXPECT_NEAR(homing.calibration().scale.y, 0.95, 0.01);
}

TEST(Homing, DoesNotTakeAPauseOnTheWayForTheStop) {
    // 92 % of the way: within what a scale may be off. The second visit gives it away.
    const Unit unit{unity, retracted, false};
    Homing homing(gen31, std::nullopt);
    const HomingView view = lead(
        homing, unit, {{retracted, 4.5}, {between(0.92), 4.5}, {retracted, 4.5}, {extended, 4.5}});
    EXPECT_EQ(view.step, HomingStep::to_check_again);
    EXPECT_EQ(view.remark, HomingRemark::misfit);
}

TEST(Homing, AMisfitIsToldAndTheHandMayGoOn) {
    const Unit unit{unity, retracted, false};
    Homing homing(gen31, Calibration{});
    const HomingView pause = lead(homing, unit, {{retracted, 4.5}, {between(0.5), 4.5}});
    EXPECT_EQ(pause.step, HomingStep::to_check);
    EXPECT_EQ(pause.remark, HomingRemark::misfit);
    EXPECT_NEAR(pause.misfit_m, 0.5 * 70.77 * degree * 0.070, 1e-3);
    EXPECT_EQ(lead(homing, unit, {{between(0.5), 0.1}, {extended, 4.5}}).step, HomingStep::done);
}

TEST(Homing, AScaleThatIsOffByMoreThanThreeMillimetresGivesNoForce) {
    Homing homing(gen31, Calibration{});
    // 5 % of 70.8 degrees on 70 mm are 4.3 mm; 3 % are 2.6 mm.
    EXPECT_EQ(
        lead(homing, {{1.05, 1.05}, retracted, false}, {{retracted, 4.5}, {extended, 4.5}}).step,
        HomingStep::to_check);
    Homing other(gen31, Calibration{});
    EXPECT_EQ(
        lead(other, {{1.03, 1.03}, retracted, false}, {{retracted, 4.5}, {extended, 4.5}}).step,
        HomingStep::done);
}

TEST(Homing, ThreeMisfitsStartOver) {
    Homing homing(gen31, Calibration{});
    const HomingView view =
        lead(homing, {unity, retracted, false},
             {{retracted, 4.5}, {between(0.4), 4.5}, {between(0.5), 4.5}, {between(0.6), 2.0}});
    EXPECT_EQ(view.step, HomingStep::to_home);
    EXPECT_EQ(view.remark, HomingRemark::starting_over);
}

TEST(Homing, KnowsSwappedPlugsWhenTheyShowAgain) {
    for (const auto& stored : {std::optional<Calibration>{Calibration{}}, {}}) {
        Homing homing(gen31, stored);
        const Unit unit{unity, retracted, true};
        const int rounds = stored ? 3 : 2;
        for (int round = 1; round < rounds; ++round) {
            EXPECT_EQ(lead(homing, unit, {{retracted, 4.5}, {extended, 4.5}}).remark,
                      HomingRemark::reversed);
        }
        const HomingView view = lead(homing, unit, {{retracted, 4.5}, {extended, 4.5}});
        EXPECT_EQ(view.step, HomingStep::to_home);
        EXPECT_EQ(view.remark, HomingRemark::swapped);
        EXPECT_TRUE(homing.bare().are_motors_swapped);
        const Unit set_up_anew{unity, retracted, false};
        EXPECT_NE(lead(homing, set_up_anew, {{retracted, 4.5}, {extended, 4.5}}).step,
                  HomingStep::to_home);
    }
}

TEST(Homing, AHandThatDoesNotMoveIsAskedAgainAndAgain) {
    Homing homing(gen31, Calibration{});
    const Unit unit{unity, retracted, false};
    HomingView view;
    for (int k = 0; k < 95000; ++k) view = homing.step(unit.read(retracted), tick_s);
    EXPECT_EQ(view.step, HomingStep::to_home);
    EXPECT_EQ(view.remark, HomingRemark::not_moved);
    EXPECT_EQ(view.prompts, 3);
}

TEST(Homing, AHiccupOfTheBoardIsNotSaidAndASilenceIsUntilItIsOver) {
    Homing homing(gen31, Calibration{});
    for (int k = 0; k < 400; ++k)
        EXPECT_EQ(homing.step(std::nullopt, tick_s).remark, HomingRemark::none);
    EXPECT_EQ(homing.step(retracted, tick_s).remark, HomingRemark::none);
    HomingView view;
    for (int k = 0; k < 600; ++k) view = homing.step(std::nullopt, tick_s);
    EXPECT_EQ(view.remark, HomingRemark::silent);
    EXPECT_EQ(homing.step(retracted, tick_s).remark, HomingRemark::none);
}

/// The order of the stops is all that tells swapped plugs from stops in the wrong order.
TEST(Homing, StopsInTheWrongOrderAreNotSwappedPlugs) {
    for (const auto& stored : {std::optional<Calibration>{Calibration{}}, {}}) {
        Homing homing(gen31, stored);
        const Unit unit{unity, retracted, false};
        HomingView view = lead(homing, unit, {{extended, 4.5}, {retracted, 4.5}});
        EXPECT_EQ(view.step, HomingStep::to_home);
        EXPECT_EQ(view.remark, HomingRemark::reversed);
        EXPECT_FALSE(homing.bare().are_motors_swapped);
        view = lead(homing, unit, {{retracted, 4.5}, {extended, 4.5}});
        EXPECT_NE(view.step, HomingStep::to_home);
        EXPECT_FALSE(homing.bare().are_motors_swapped);
    }
}

TEST(Homing, ASilentBoardOrNoNumberIsNoRest) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const std::optional<JointAngles>& read :
         {std::optional<JointAngles>{}, std::optional<JointAngles>{{nan, 0.0}}}) {
        Homing homing(gen31, Calibration{});
        HomingView view;
        for (int k = 0; k < 20000; ++k) view = homing.step(read, tick_s);
        EXPECT_EQ(view.step, HomingStep::to_home);
        EXPECT_EQ(view.remark, HomingRemark::silent);
    }
}

TEST(HomingPlan, StretchesBothArmsOfEveryProfileOrRetractsThem) {
    for (const DeviceProfile& profile : device_profiles()) {
        const HomingPlan plan = homing_plan(profile);
        const auto home = forward(profile.geometry, plan.home);
        ASSERT_TRUE(home.has_value()) << profile.name;
        EXPECT_GT(plan.arm_m * norm(plan.check - plan.home), 0.05) << profile.name;
        if (profile.check.place != StopPlace::towards) continue;
        // Both links of each arm in one line, or nearly so: the tip as far out as it goes.
        const Geometry& arms = profile.geometry;
        const double reach_m = arms.proximal_m + arms.distal_m;
        const Position elbow{arms.proximal_m * std::cos(plan.check.x),
                             arms.proximal_m * std::sin(plan.check.x)};
        const double distal_x_m = 0.5 * arms.base_m - elbow.x;
        const double tip_y_m =
            elbow.y + std::sqrt(arms.distal_m * arms.distal_m - distal_x_m * distal_x_m);
        EXPECT_GT(std::hypot(0.5 * arms.base_m, tip_y_m), 0.97 * reach_m) << profile.name;
    }
}

TEST(DriftWatch, NeedsATimeBeyondAStop) {
    const JointAngles past_home = retracted - 0.1 * (extended - retracted);
    const JointAngles past_check = extended + 0.1 * (extended - retracted);
    for (const JointAngles& past : {past_home, past_check}) {
        DriftWatch watch(gen31);
        for (int k = 0; k < 290; ++k) EXPECT_FALSE(watch.step(past, tick_s));
        EXPECT_FALSE(watch.step(retracted, tick_s));
        bool has_drifted = false;
        for (int k = 0; k < 310; ++k) has_drifted = watch.step(past, tick_s);
        EXPECT_TRUE(has_drifted);
        EXPECT_TRUE(watch.step(retracted, tick_s));
    }
}

TEST(DriftWatch, IsQuietOverTheWholeDrawingArea) {
    const DeviceProfile& profile = default_profile();
    DriftWatch watch(gen31);
    for (int x = -58; x <= 58; ++x) {
        for (int y = -42; y <= 42; ++y) {
            const Position p_D = device_from_picture(profile, {x * 1e-3, y * 1e-3});
            EXPECT_FALSE(watch.step(inverse(profile.geometry, p_D).value(), 1.0));
        }
    }
}

}  // namespace
}  // namespace touchline
