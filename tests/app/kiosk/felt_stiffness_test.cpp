// Tests the operator's stiffness through the whole kiosk, from the key to the force on the handle.
#include "tests/app/kiosk/blind_visitor.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double tolerance = 0.02;       // share of a stiffness; what the encoders' steps leave
constexpr double late_tolerance = 0.03;  // the same on a loop that hears of the hand 3 ms late
constexpr double tick_s = 0.001;

// In "A house": a corridor between the right window and the right wall, which is at x = 38 mm.
constexpr Position corridor{0.0345, -0.005};
constexpr Position behind_wall{0.0406, -0.005};
constexpr Position along_wall{0.0, -0.012};

double felt_N_per_m(KioskWorld& world) {
    return feel_wall(world, behind_wall, along_wall).stiffness_N_per_m;
}

/// Waits until the stiffness no longer changes; the hand pushes and moves as hands do.
void wait_for_ramp(KioskWorld& world) {
    for (int i = 0; i < 60; ++i) {
        const double before = world.kiosk().hand().stiffness_N_per_m;
        world.run(1.0);
        if (world.kiosk().hand().stiffness_N_per_m == before) return;
    }
    ADD_FAILURE() << "the stiffness never comes to rest";
}

void hold_stiffness(KioskWorld& world, BlindVisitor& staff) {
    ASSERT_NO_FATAL_FAILURE(open_walls(world, "A house"));
    lead_hand(world, corridor);
    ASSERT_NO_FATAL_FAILURE(hold_setting(staff, {"How it feels", "Lines and force", "Firmness"}));
}

/// The visit goes on; each value is felt as soon as the operator turns to it.
TEST(FeltStiffness, IsEveryValueThatTheOperatorCanSet) {
    WallWorld world;
    BlindVisitor staff(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(hold_stiffness(world, staff));
    ASSERT_NO_FATAL_FAILURE(turn_to_least(staff));
    for (double set_N_per_m = 100.0; set_N_per_m <= 700.0; set_N_per_m += 50.0) {
        SCOPED_TRACE(set_N_per_m);
        wait_for_ramp(world);
        EXPECT_NEAR(felt_N_per_m(world), set_N_per_m, tolerance * set_N_per_m);
        EXPECT_EQ(staff.heard().find("possible"), std::string::npos) << staff.heard();
        staff.press(KeyRole::up);
    }
    EXPECT_NE(staff.heard().find("It goes no further."), std::string::npos);
    EXPECT_TRUE(is_visit_on(world.kiosk().visit()));
    EXPECT_EQ(world.kiosk().force().fault, Fault::none);
}

/// The largest changes in one tick. A ramp may rise by 5 % a second and fall by 15 N a second.
struct Ramp {
    double most_rise = 0.0;    // share in a tick
    double most_fall_N = 0.0;  // in a tick
    double most_force_step_N = 0.0;
    double last_N_per_m = 0.0;
    Force last_force;

    void watch(const HandState& hand) {
        const double now_N_per_m = hand.stiffness_N_per_m;
        if (last_N_per_m > 0.0) {
            const double depth_m = norm(hand.p_WP - hand.p_WH);
            most_rise = std::max(most_rise, now_N_per_m / last_N_per_m - 1.0);
            most_fall_N = std::max(most_fall_N, (last_N_per_m - now_N_per_m) * depth_m);
            most_force_step_N = std::max(most_force_step_N, norm(hand.force - last_force));
        }
        last_N_per_m = now_N_per_m;
        last_force = hand.force;
    }
};

TEST(FeltStiffness, IsRampedUnderAHandThatPushes) {
    WallWorld world;
    BlindVisitor staff(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(hold_stiffness(world, staff));
    ASSERT_NO_FATAL_FAILURE(turn_to_least(staff));
    wait_for_ramp(world);
    lead_hand(world, behind_wall);
    world.run(0.5);
    Ramp ramp;
    world.servo().on_tick = [&ramp](const HandState& hand) { ramp.watch(hand); };
    for (const KeyRole role : {KeyRole::up, KeyRole::down}) {
        for (int i = 0; i < 12; ++i) staff.press(role);
        for (int i = 0; i < 45; ++i) {  // a hand that stands still for long has let go
            lead_hand(world, behind_wall + (i % 2 == 0 ? 0.1 : 0.0) * along_wall);
            world.run(1.0);
        }
        const double set_N_per_m = role == KeyRole::up ? 700.0 : 100.0;
        EXPECT_DOUBLE_EQ(world.kiosk().hand().stiffness_N_per_m, set_N_per_m);
    }
    world.servo().on_tick = {};
    EXPECT_LE(ramp.most_rise, 1.0001 * 0.05 * tick_s);
    EXPECT_GT(ramp.most_rise, 0.0);
    EXPECT_LE(ramp.most_fall_N, 1.1 * 15.0 * tick_s);
    EXPECT_GT(ramp.most_fall_N, 0.0);
    // Encoder steps make up most of it: 0.1 mm at 700 N/m, on two encoders.
    EXPECT_LE(ramp.most_force_step_N, 0.15);
}

TEST(FeltStiffness, IsWhatTheLoopAllowsAndTheScreenSaysSo) {
    WallWorld world;
    BlindVisitor staff(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(hold_stiffness(world, staff));
    world.servo().delay_s = 0.003;
    world.run(10.0);
    wait_for_ramp(world);
    const double most_N_per_m = world.kiosk().hand().stiffness_bound.most_N_per_m;
    ASSERT_NEAR(most_N_per_m, 440.0, 4.0);
    staff.press(KeyRole::up);
    EXPECT_NE(staff.heard().find("550 newtons per metre set, 440 possible on this loop"),
              std::string::npos)
        << staff.heard();
    EXPECT_NEAR(felt_N_per_m(world), most_N_per_m, late_tolerance * most_N_per_m);
    for (int i = 0; i < 3; ++i) staff.press(KeyRole::down);
    EXPECT_NE(staff.heard().find("400 newtons per metre"), std::string::npos) << staff.heard();
    wait_for_ramp(world);
    EXPECT_NEAR(felt_N_per_m(world), 400.0, late_tolerance * 400.0);
}

/// Without real-time priority a device gets half of what is set.
TEST(FeltStiffness, IsTheShareThatTheTierLeavesAndTheScreenSaysSo) {
    WallWorld world;
    world.servo().set_tier(limits_of(RealTimeTier::best_effort));
    BlindVisitor staff(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(hold_stiffness(world, staff));
    EXPECT_EQ(world.kiosk().hand().stiffness_bound.share, 0.5);
    for (const int set_N_per_m : {600, 700}) {
        for (int i = 0; i < 2; ++i) staff.press(KeyRole::up);
        const std::string told = std::to_string(set_N_per_m) + " newtons per metre set, " +
                                 std::to_string(set_N_per_m / 2) + " possible on this loop";
        EXPECT_NE(staff.heard().find(told), std::string::npos) << staff.heard();
        wait_for_ramp(world);
        EXPECT_NEAR(felt_N_per_m(world), 0.5 * set_N_per_m, tolerance * 0.5 * set_N_per_m);
    }
    EXPECT_EQ(world.kiosk().force().fault, Fault::none);
}

/// The visitor's named steps follow the operator's stiffness, also while it changes.
TEST(FeltStiffness, OfAVisitorsStepsIsAShareOfTheOperators) {
    WallWorld world;
    BlindVisitor visitor(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(open_walls(world, "A house"));
    lead_hand(world, corridor);
    const double most_N_per_m = world.kiosk().hand().stiffness_bound.most_N_per_m;
    for (const StiffnessStep& step : stiffness_steps) {
        ASSERT_TRUE(visitor.choose("Firmness")) << visitor.heard();
        ASSERT_TRUE(visitor.choose(std::string(step.name))) << visitor.heard();
        for (const double set_N_per_m : {100.0, 500.0, 700.0}) {
            SCOPED_TRACE(std::string(step.name) + " of " + std::to_string(set_N_per_m));
            Settings settings;
            settings.stiffness_N_per_m = set_N_per_m;
            settings.mode = Mode::wall;
            world.kiosk().set(settings);
            wait_for_ramp(world);
            const double meant_N_per_m = std::min(step.share * set_N_per_m, most_N_per_m);
            EXPECT_NEAR(felt_N_per_m(world), meant_N_per_m, tolerance * meant_N_per_m);
        }
    }
}

/// Tested before any visitor comes. A file with an impossible value changes nothing.
TEST(FeltStiffness, OfTheSitesFileHoldsAtOnceAndBadOnesDoNot) {
    WallWorld world;
    const auto write = [&world](const std::string& value) {
        std::ofstream(world.site_files().settings.site)
            << "[feel]\nstiffness_N_per_m = " << value << "\n";
        world.run(2.0);
        return world.servo().commands().contact.stiffness_N_per_m;
    };
    EXPECT_EQ(write("130"), 130.0);
    for (const char* bad : {"nan", "inf", "-500", "0", "99.9", "700.1", "1e300", "\"firm\""}) {
        EXPECT_EQ(write(bad), 130.0) << bad;
        const std::string report = world.kiosk().take_report();
        EXPECT_NE(report.find("stiffness_N_per_m"), std::string::npos) << bad << ": " << report;
        EXPECT_EQ(std::count(report.begin(), report.end(), '\n'), 1) << report;
        EXPECT_EQ(write("130"), 130.0);
        (void)world.kiosk().take_report();
    }
}

}  // namespace
}  // namespace touchline
