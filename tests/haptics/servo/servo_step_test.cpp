#include "haptics/servo/servo_step.h"

#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/servo/step_bench.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Places the same handle with arm 1 on the other side: a pose that the device cannot take.
JointAngles with_elbow_turned_in(const DeviceProfile& profile, Position p_W) {
    const Position p_D = device_from_picture(profile, p_W);
    const JointAngles out = angles_at(profile, p_W);
    return {2.0 * std::atan2(p_D.y, p_D.x) - out.x, out.y};
}

TEST(ServoStep, SeesTheHandleThroughTheKinematics) {
    Bench bench;
    bench.place({0.031, -0.022});
    EXPECT_NEAR(norm(bench.run(1).p_WH - Position{0.031, -0.022}), 0.0, 1e-12);
    EXPECT_EQ(bench.hand().p_WP, bench.hand().p_WH);
    EXPECT_EQ(bench.told.torques, JointTorques{});
}

TEST(ServoStep, WallPushesBackThroughTheMotors) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.001});
    const HandState& hand = bench.run(20);
    EXPECT_EQ(hand.state, ContactState::edge);
    EXPECT_EQ(hand.outline, 0);
    EXPECT_NEAR(hand.p_WP.y, 0.0, 1e-6);
    EXPECT_NEAR(hand.force.y, 500.0 * 0.001, 1e-3);
    EXPECT_NEAR(hand.force.x, 0.0, 1e-9);
    EXPECT_EQ(bench.force().limit, Limit::none);
    // The motors make that force, turned into the device's frame.
    const Pose pose = forward(bench.profile.geometry, bench.input.reading->joints).value();
    const JointTorques expected = joint_torques(pose.jacobian, turned(hand.force));
    EXPECT_NEAR(norm(bench.told.torques - expected), 0.0, 1e-12);
}

TEST(ServoStep, ReportsWhatItWasTold) {
    const auto scene = line_scene(0.0, 42);
    Bench bench;
    bench.input.scene = scene.get();
    bench.input.missed_ticks = 3;
    bench.input.commands.is_level_auto = false;
    bench.input.commands.contact.stiffness_N_per_m = 350.0;
    bench.input.commands.contact.mode = Mode::groove;
    const HandState& hand = bench.run(10);
    EXPECT_EQ(hand.ticks, 10U);
    EXPECT_EQ(hand.missed_ticks, 3U);
    EXPECT_EQ(hand.map_version, 42U);
    EXPECT_NEAR(hand.time_s, 9 * tick_s, 1e-12);
    EXPECT_FALSE(hand.is_level_auto);
    EXPECT_EQ(hand.stiffness_N_per_m, 350.0);
    EXPECT_EQ(hand.mode, Mode::groove);
}

TEST(ServoStep, ForceComesOnOnlyAfterArmingAndRamp) {
    const auto scene = line_scene(0.0);
    Bench bench;
    bench.input.scene = scene.get();
    bench.drag({0.0, 0.01}, {0.0, -0.002});
    bench.run(500);  // pressing from the start: never armed
    EXPECT_EQ(bench.force().state, ForceState::armed);
    EXPECT_EQ(bench.hand().force, Force{});
    EXPECT_EQ(bench.hand().state, ContactState::edge);
}

TEST(ServoStep, FasterHandFeelsACoarserLevel) {
    const auto scene = wave_scene(0.02);
    Bench bench;
    bench.input.scene = scene.get();
    bench.run(10);
    const double still = bench.hand().level;
    for (int i = 0; i < 60; ++i) {
        bench.place({-0.03 + i * 1e-3, -0.02});  // 1 m/s
        bench.run(1);
    }
    EXPECT_GT(bench.hand().level, still);
    EXPECT_EQ(bench.hand().level,
              std::min(bench.hand().level_terms.speed, bench.hand().level_terms.safe));
    EXPECT_GT(bench.hand().speed_m_per_s, 0.3);
}

TEST(ServoStep, LevelTermsAreThoseOfSceneDeviceAndProxy) {
    const auto scene = wave_scene(0.02);
    Bench bench;
    bench.input.scene = scene.get();
    bench.input.commands.contact.radius_m = 0.004;
    bench.run(300);
    const LevelTerms& terms = bench.hand().level_terms;
    const double spacing_m = scene->curves.finest_spacing_m();
    EXPECT_GE(spacing_m * std::exp2(terms.encoder), encoder_step_m(bench.profile));
    EXPECT_LT(spacing_m * std::exp2(terms.encoder - 1.0), encoder_step_m(bench.profile));
    EXPECT_GE(spacing_m * std::exp2(terms.radius), 0.0005);
    EXPECT_LT(spacing_m * std::exp2(terms.radius - 1.0), 0.0005);
    EXPECT_EQ(terms.percept, scene->percept_level);
    EXPECT_EQ(terms.safe, scene->curves.coarsest());
    EXPECT_EQ(terms.cost, 0.0);
    EXPECT_EQ(bench.hand().level, choose_level(terms).level);
}

TEST(ServoStep, OperatorsBoundsHoldTheAutomaticLevel) {
    const auto scene = wave_scene(0.02);
    Bench bench;
    bench.place({0.0, -0.02});
    bench.input.scene = scene.get();
    bench.input.commands.finest_level = 3.0;
    bench.run(300);
    EXPECT_EQ(bench.hand().level, 3.0);
    bench.input.commands.finest_level = 0.0;
    bench.input.commands.coarsest_level = 0.0;
    bench.run(300);
    EXPECT_EQ(bench.hand().level, bench.hand().level_terms.encoder);
    EXPECT_GT(bench.hand().level, 0.0);  // the device resolves no finer
}

TEST(ServoStep, AFixedLevelIsFeltWhateverTheSpeedUnlessTheDeviceTellsNoneSoFine) {
    const auto scene = wave_scene(0.02);
    Bench bench;
    bench.input.scene = scene.get();
    bench.input.commands.is_level_auto = false;
    bench.input.commands.level = 2.5;
    for (int i = 0; i < 60; ++i) {
        bench.place({-0.03 + i * 1e-3, -0.02});
        bench.run(1);
    }
    EXPECT_EQ(bench.hand().level, 2.5);
    EXPECT_EQ(choose_level(bench.hand().level_terms).by, LevelTerm::coarsest);
    bench.input.commands.level = 0.5;
    bench.run(1);
    EXPECT_EQ(bench.hand().level, bench.hand().level_terms.encoder);
    EXPECT_EQ(choose_level(bench.hand().level_terms).by, LevelTerm::encoder);
    bench.input.commands.level = 99.0;
    bench.run(1);
    EXPECT_EQ(bench.hand().level, scene->curves.coarsest());
}

/// Level, range and stiffness change while the hand presses on the line. The line holds, the force
/// never jumps, and off the line the level is the one that was set.
TEST(ServoStep, TheOperatorSetsLevelRangeAndStiffnessUnderAPressingHand) {
    const auto scene = wave_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.001});
    bench.run(20);
    ServoCommands& commands = bench.input.commands;
    Force last = bench.hand().force;
    for (int i = 0; i < 3000; ++i) {
        commands.is_level_auto = i / 300 % 2 == 0;
        commands.level = i / 250 % 4;
        commands.finest_level = i / 200 % 3;
        commands.coarsest_level = commands.finest_level + i / 350 % 3;
        commands.contact.stiffness_N_per_m = i / 400 % 2 == 0 ? 350.0 : 500.0;
        bench.place({0.003 * std::sin(0.004 * i), -0.001});
        bench.run(1);
        ASSERT_NE(bench.hand().state, ContactState::free) << i;
        ASSERT_GT(bench.hand().p_WP.y, bench.hand().p_WH.y) << i;
        ASSERT_LE(norm(bench.hand().force - last), 0.03 + 500.0 * 0.012 * tick_s) << i;
        last = bench.hand().force;
    }
    commands.is_level_auto = false;
    commands.level = 3.0;
    bench.drag({0.0, -0.001}, {0.0, 0.01});
    EXPECT_EQ(bench.hand().level, 3.0);
}

/// A device that resolves 1 um, so that level 0 of a circle of 1 um edges is not too fine for it.
DeviceProfile device_of_fine_counts() {
    DeviceProfile profile = default_profile();
    profile.counts_per_turn = 1000.0 * profile.counts_per_turn;
    return profile;
}

/// At 0.5 m/s the hand passes more edges in a tick than a step follows.
TEST(ServoStep, AFinestLevelThatTheTickCannotAffordIsNotReached) {
    constexpr double radius_m = 0.03;
    TactileMap map;
    map.outlines.push_back(scenes::circle(radius_m, 188000));
    const Scene scene = build_scene(map, {}, 0.0).value();
    Bench bench(device_of_fine_counts());
    bench.input.scene = &scene;
    bench.input.commands.is_level_auto = false;
    double turn_rad = 0.0;
    const auto slide = [&](double depth_m, double speed_m_per_s) -> const LevelTerms& {
        turn_rad += speed_m_per_s * tick_s / radius_m;
        const double r = radius_m - depth_m;
        bench.place({r * std::sin(turn_rad), r * std::cos(turn_rad)});
        bench.run(1);
        return bench.hand().level_terms;
    };
    for (int i = 0; i < 800; ++i) (void)slide(-0.002, 0.0);
    for (int i = 0; i < 300; ++i) (void)slide(-0.002 + 1e-5 * i, 0.0);
    EXPECT_EQ(slide(0.001, 0.01).cost, 0.0);
    EXPECT_EQ(bench.hand().level, 0.0);
    for (int i = 0; i < 100; ++i) (void)slide(0.001, 0.5);
    EXPECT_GT(slide(0.001, 0.5).cost, 0.0);
    EXPECT_EQ(choose_level(slide(0.001, 0.5)).by, LevelTerm::cost);
    for (int i = 0; i < 100; ++i) (void)slide(-0.002, 0.0);  // off the line the level follows
    EXPECT_EQ(bench.hand().level, bench.hand().level_terms.cost);
    for (int i = 0; i < 2000; ++i) (void)slide(-0.002, 0.01);
    EXPECT_EQ(bench.hand().level, 0.0);  // affordable again
}

TEST(ServoStep, NewSceneIsSwappedAtZeroForceWithinFadeTime) {
    const auto first = line_scene(0.0, 1);
    const auto second = line_scene(0.005, 2);
    Bench bench = bench_above_a_line(first);
    bench.drag({0.0, 0.01}, {0.0, -0.002});
    bench.run(20);
    ASSERT_NEAR(norm(bench.hand().force), 1.0, 1e-2);

    bench.input.scene = second.get();
    Force last = bench.hand().force;
    int ticks = 0;
    for (; bench.hand().map_version == 1 && ticks < 100; ++ticks) {
        bench.run(1);
        EXPECT_LE(norm(bench.hand().force - last), 1500.0 * tick_s + 1e-12);
        last = bench.hand().force;
    }
    EXPECT_LE(ticks, 52);
    EXPECT_EQ(bench.hand().force, Force{});
    EXPECT_EQ(bench.hand().state, ContactState::free);
    EXPECT_EQ(bench.hand().p_WP, bench.hand().p_WH);  // 7 mm past the new line, and free
    EXPECT_EQ(bench.step->scene(), second.get());

    bench.run(295);
    EXPECT_EQ(bench.force().state, ForceState::ramp);  // comes on in no less than 0.3 s
    bench.run(10);
    EXPECT_EQ(bench.force().state, ForceState::live);
    bench.drag({0.0, -0.002}, {0.0, 0.006});  // the new line holds from below
    bench.run(20);
    EXPECT_NEAR(bench.hand().force.y, -0.5, 1e-2);
}

TEST(ServoStep, SwapTakenBackMidwayComesBackToTheOldScene) {
    const auto first = line_scene(0.0, 1);
    const auto second = line_scene(0.005, 2);
    Bench bench = bench_above_a_line(first);
    bench.drag({0.0, 0.01}, {0.0, -0.002});
    bench.input.scene = second.get();
    bench.run(20);
    bench.input.scene = first.get();
    bench.run(300);
    EXPECT_EQ(bench.hand().map_version, 1U);
    EXPECT_NEAR(bench.hand().force.y, 1.0, 1e-2);
    EXPECT_EQ(bench.hand().state, ContactState::edge);
}

TEST(ServoStep, SceneCanBeTakenAway) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.002});
    bench.input.scene = nullptr;
    bench.run(60);
    EXPECT_EQ(bench.step->scene(), nullptr);
    EXPECT_EQ(bench.hand().force, Force{});
    EXPECT_EQ(bench.hand().state, ContactState::free);
    EXPECT_EQ(bench.hand().map_version, 0U);
}

TEST(ServoStep, ChangeOfRadiusGoesThroughZeroForce) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.002});
    bench.run(20);
    EXPECT_NEAR(bench.hand().force.y, 1.0, 1e-2);
    bench.input.commands.contact.radius_m = 0.002;
    bench.run(52);
    EXPECT_NEAR(norm(bench.hand().force), 0.0, 0.05);
    EXPECT_EQ(bench.hand().state, ContactState::free);
}

TEST(ServoStep, SwitchingTheModeFadesUnderTheHand) {
    const auto scene = line_scene(0.0);
    Bench bench(find_profile("mk2").value());
    bench.input.scene = scene.get();
    bench.run(800);
    bench.drag({0.0, 0.01}, {0.0, -0.002});
    bench.run(20);
    double largest_N = 0.0;
    for (const Mode mode : {Mode::groove, Mode::wall, Mode::stay, Mode::ridge, Mode::groove}) {
        bench.input.commands.contact.mode = mode;
        for (int i = 0; i < 150; ++i) {
            const Force before = bench.hand().force;
            bench.run(1);
            ASSERT_LE(norm(bench.hand().force - before), 0.03) << i;
            largest_N = std::max(largest_N, norm(bench.hand().force));
        }
        EXPECT_EQ(bench.hand().mode, mode);
    }
    EXPECT_GT(largest_N, 0.9);
    EXPECT_NEAR(bench.hand().force.y, 1.0 * std::pow(1.0 - 4.0 / 9.0, 2), 1e-3);
}

std::vector<ContactEventKind> kinds_of(Bench& bench, Position from, Position to) {
    std::vector<ContactEventKind> kinds;
    for (int i = 1; i <= 300; ++i) {
        bench.place(from + i / 300.0 * (to - from));
        bench.run(1);
        for (const ContactEvent& event : bench.step->events()) {
            EXPECT_EQ(event.time_s, bench.hand().time_s);
            kinds.push_back(event.kind);
        }
    }
    return kinds;
}

TEST(ServoStep, TellsWhatHappens) {
    using enum ContactEventKind;
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    EXPECT_EQ(kinds_of(bench, {0.0, 0.01}, {0.0, -0.002}), std::vector{contact_made});
    EXPECT_EQ(kinds_of(bench, {0.0, -0.002}, {0.0, 0.01}), std::vector{contact_lost});
    bench.input.commands.contact.mode = Mode::groove;
    EXPECT_EQ(kinds_of(bench, {0.0, 0.01}, {0.0, -0.01}),
              (std::vector{contact_made, line_crossed, contact_lost}));
}

TEST(ServoStep, AWallLetsAPushThroughThatIsMeant) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.input.commands.contact.pop_through_N = 1.5;
    bench.drag({0.0, 0.01}, {0.0, -0.004});
    int pops = 0;
    for (int i = 0; i < 600; ++i) {
        bench.run(1);
        for (const ContactEvent& event : bench.step->events()) {
            pops += event.kind == ContactEventKind::popped_through ? 1 : 0;
        }
    }
    EXPECT_EQ(pops, 1);
    EXPECT_EQ(bench.hand().state, ContactState::free);
    EXPECT_EQ(bench.hand().force, Force{});
}

/// A light hand presses on a line through a late device. Returns the final gain of the spring.
double gain_after_pressing(double delay_s) {
    DeviceProfile profile = default_profile();
    profile.mechanics.delay_s = delay_s;
    const auto scene = line_scene(0.0);
    const auto path = std::make_shared<WaypointPath>(std::vector<WaypointPath::Waypoint>{
        {0.0, {0.0, 0.01}}, {1.0, {0.0, 0.01}}, {1.2, {0.0, -0.015}}, {4.0, {0.0, -0.015}}});
    SimulationOptions options;
    options.hand = light_hand;
    SimulatedPantograph device(profile, options, path);
    ServoStep step(profile, tick_s);
    ServoCommands commands;
    commands.contact.stiffness_N_per_m = 900.0;
    for (int i = 0; i < 4000; ++i) {
        const StepInput input{tick_s * i, 0, device.read(tick_s * i), commands, scene.get()};
        EXPECT_TRUE(device.write(step.step(input)));
    }
    return step.report().hand.spring_gain;
}

TEST(ServoStep, ALoopThatRingsIsSoftenedAndASoundOneIsNot) {
    EXPECT_EQ(gain_after_pressing(0.001), 1.0);
    EXPECT_LT(gain_after_pressing(0.003), 0.8);
}

/// What the loop measures of itself limits the stiffness, whatever the operator asks for.
TEST(ServoStep, ALateLoopRendersSofterWalls) {
    Bench bench;
    bench.input.commands.contact.stiffness_N_per_m = 900.0;
    EXPECT_EQ(bench.run(1).stiffness_N_per_m, 900.0);
    bench.input.delay_s = 0.004;
    bench.run(8000);
    const double lag_s = 0.5 * tick_s + 0.004;
    EXPECT_NEAR(bench.hand().stiffness_N_per_m,
                0.9 * (default_profile().mechanics.viscous_Ns_per_m + 1.5) / lag_s, 1.0);
    EXPECT_NEAR(bench.hand().stiffness_N_per_m, bench.hand().stiffness_bound.most_N_per_m, 0.1);
    EXPECT_EQ(bench.hand().stiffness_bound.share, 1.0);
}

TEST(ServoStep, ATierLeavesItsShareOfTheStiffnessAndTellsIt) {
    const TierLimits tier = limits_of(RealTimeTier::best_effort);
    ServoStep step(default_profile(), tick_s, tier);
    StepInput input;
    input.reading = reading_of(default_profile().geometry, default_profile().home);
    (void)step.step(input);
    const HandState& hand = step.report().hand;
    EXPECT_EQ(hand.stiffness_bound.share, tier.stiffness_share);
    EXPECT_EQ(hand.stiffness_N_per_m,
              possible_N_per_m(hand.stiffness_bound, input.commands.contact.stiffness_N_per_m));
}

TEST(ServoStep, StiffnessUnderTheHandRisesSlowlyAndFreelyAtZeroForce) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.001});
    bench.input.commands.contact.stiffness_N_per_m = 900.0;
    bench.run(1000);
    EXPECT_NEAR(bench.hand().stiffness_N_per_m, 525.6, 0.1);
    bench.input.commands.contact.stiffness_N_per_m = 200.0;
    bench.run(1);
    EXPECT_NEAR(bench.hand().stiffness_N_per_m, 510.6, 0.1);  // 15 N/s at 1 mm
    bench.run(50);
    EXPECT_EQ(bench.hand().stiffness_N_per_m, 200.0);

    Bench fresh;
    fresh.input.commands.contact.stiffness_N_per_m = 900.0;
    EXPECT_EQ(fresh.run(1).stiffness_N_per_m, 900.0);
}

TEST(ServoStep, OutOfReachIsZeroForceAndKeepsTheSideOfTheWall) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.001});
    bench.run(20);
    bench.input.reading =
        reading_of(bench.profile.geometry, with_elbow_turned_in(bench.profile, {0.0, -0.001}));
    const Position before = bench.hand().p_WH;
    bench.run(1);
    EXPECT_EQ(bench.told.torques, JointTorques{});
    EXPECT_EQ(bench.force().limit, Limit::unreachable);
    EXPECT_EQ(bench.hand().p_WH, before);
    bench.place({0.0, -0.001});
    bench.run(20);
    EXPECT_NEAR(bench.hand().force.y, 0.5, 1e-2);
}

TEST(ServoStep, SilentDeviceIsZeroAtOnceAndAFaultAfter20Milliseconds) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.001});
    bench.input.reading.reset();
    bench.run(1);
    EXPECT_EQ(bench.told.torques, JointTorques{});
    EXPECT_EQ(bench.force().state, ForceState::live);
    bench.run(21);
    EXPECT_EQ(bench.force().state, ForceState::fault);
    EXPECT_EQ(bench.force().fault, Fault::device_lost);
    bench.place({0.0, -0.001});
    bench.run(2000);
    EXPECT_EQ(bench.told.torques, JointTorques{});
}

TEST(ServoStep, AnglesThatAreNotFiniteGiveZeroTorque) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.001});
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e308,
                             std::numeric_limits<double>::infinity()}) {
        bench.input.reading = reading_of(bench.profile.geometry, JointAngles{bad, 0.2});
        bench.run(1);
        EXPECT_EQ(bench.told.torques, JointTorques{});
        EXPECT_TRUE(is_finite(bench.hand().p_WH));
    }
}

TEST(ServoStep, CommandsThatAreNotFiniteGiveZeroForce) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int kind = 0; kind < 4; ++kind) {
        const auto scene = line_scene(0.0);
        Bench bench = bench_above_a_line(scene);
        bench.drag({0.0, 0.01}, {0.0, -0.001});
        ServoCommands& commands = bench.input.commands;
        if (kind == 0) commands.contact.friction = nan;
        if (kind == 1) commands.contact.radius_m = nan;
        if (kind == 2) commands.contact.capture_m = nan;
        if (kind == 3) {
            commands.is_level_auto = false;
            commands.level = nan;
        }
        for (int i = 0; i < 200; ++i) {
            bench.run(1);
            EXPECT_TRUE(is_finite(bench.told.torques)) << kind;
        }
    }
}

TEST(ServoStep, FadesOutForGood) {
    const auto scene = line_scene(0.0);
    Bench bench = bench_above_a_line(scene);
    bench.drag({0.0, 0.01}, {0.0, -0.001});
    bench.step->fade_out();
    int ticks = 0;
    for (; !bench.step->is_silent() && ticks < 100; ++ticks) bench.run(1);
    EXPECT_LE(ticks, 51);
    const auto other = line_scene(0.005);
    bench.input.scene = other.get();
    bench.run(500);
    EXPECT_EQ(bench.told.torques, JointTorques{});
}

}  // namespace
}  // namespace touchline
