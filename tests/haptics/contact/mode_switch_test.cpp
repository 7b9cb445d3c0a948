// Switching the mode under the hand: the force goes on from its last value, and a wall begins on
// the handle's side.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/hold_rig.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Scene line_scene(double radius_m) {
    const Outline line = scenes::outline({{-0.05, 0.0}, {0.05, 0.0}}, false);
    return build_scene(scenes::map_of({line}), {}, radius_m).value();
}

TEST(ModeSwitch, NeverMakesTheForceJump) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const double radius_m : {0.0, 0.0014}) {
        const Scene scene = line_scene(radius_m);
        ContactSettings settings;
        settings.radius_m = radius_m;
        ContactMachine machine;
        Position hand{0.0, 0.003};
        machine.reset(scene, hand, 0.0);
        Force force;
        double largest_N = 0.0;
        Position aim = hand;
        for (int i = 0; i < 200000; ++i) {
            if (i % 40 == 0) settings.mode = all_modes[static_cast<std::size_t>(random() % 4)];
            if (i % 250 == 0) aim = {0.01 * unit(random), 0.003 * unit(random)};
            const Position moved = 0.02 * (aim - hand);
            hand += moved;
            const Force now = machine.step(hand, 0.0, settings, {}).force;
            const double steepest_N_per_m = 3.0 * CaptureLaw(settings).steepest_N_per_m();
            ASSERT_LE(norm(now - force), 0.03 + steepest_N_per_m * norm(moved)) << i;
            force = now;
            largest_N = std::max(largest_N, norm(now));
        }
        EXPECT_GT(largest_N, 1.0);
    }
}

TEST(ModeSwitch, FadesToTheNewForceInATenthOfASecond) {
    const Scene scene = line_scene(0.0);
    ContactSettings settings;
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.001}, 0.0);
    const Position hand{0.0, -0.002};
    const Force wall = machine.step(hand, 0.0, settings, {}).force;
    EXPECT_NEAR(wall.y, 1.0, 1e-6);
    settings.mode = Mode::ridge;
    Force force = machine.step(hand, 0.0, settings, {}).force;
    EXPECT_NEAR(norm(force - wall), 0.0, 1e-12);
    for (int i = 0; i < 100; ++i) force = machine.step(hand, 0.0, settings, {}).force;
    EXPECT_NEAR(force.y, -CaptureLaw({Mode::groove}).pull_N(0.002), 1e-12);
}

TEST(ModeSwitch, AWallBeginsOnTheHandlesSideWithoutPushing) {
    for (const double radius_m : {0.0, 0.0014}) {
        for (const double y : {-0.002, -0.0005, 0.0005, 0.002}) {
            const Scene scene = line_scene(radius_m);
            ContactSettings settings;
            settings.radius_m = radius_m;
            settings.mode = Mode::groove;
            ContactMachine machine;
            const Position hand{0.0, y};
            machine.reset(scene, hand, 0.0);
            for (int i = 0; i < 10; ++i) (void)machine.step(hand, 0.0, settings, {});
            settings.mode = Mode::wall;
            ContactReport report;
            for (int i = 0; i < 200; ++i) {
                report = machine.step(hand, 0.0, settings, {});
                ASSERT_NEAR(norm(report.p_WP - hand), 0.0, 1e-9) << y;
            }
            EXPECT_NEAR(norm(report.force), 0.0, 1e-6);
            // Crosses the line, and is held on that side.
            report = machine.step({0.0, -y}, 0.0, settings, {});
            EXPECT_EQ(report.state, ContactState::edge);
            EXPECT_GT(report.p_WP.y * y, 0.0);
        }
    }
}

TEST(ModeSwitch, ADiscHasItsWholeRadiusOnceThereIsRoom) {
    const Scene scene = line_scene(0.0014);
    ContactSettings settings;
    settings.radius_m = 0.0014;
    settings.mode = Mode::groove;
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.0005}, 0.0);
    (void)machine.step({0.0, 0.0005}, 0.0, settings, {});
    settings.mode = Mode::wall;
    EXPECT_NEAR(machine.step({0.0, 0.0005}, 0.0, settings, {}).p_WP.y, 0.0005, 1e-9);
    for (int i = 0; i < 100; ++i) {
        (void)machine.step({0.0, 0.0005 + 2e-5 * i}, 0.0, settings, {});
    }
    for (int i = 0; i < 100; ++i) {
        (void)machine.step({0.0, 0.0025 - 2e-5 * i}, 0.0, settings, {});
    }
    EXPECT_NEAR(machine.step({0.0, 0.0005}, 0.0, settings, {}).p_WP.y, 0.0014, 1e-9);
}

}  // namespace
}  // namespace touchline
