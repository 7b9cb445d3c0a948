// Groove, ridge and stay: their laws, and how they change lines and levels.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/hold_rig.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using scenes::map_of;
using scenes::outline;

TEST(Groove, PullsToTheLineByItsProfileAndNotBeyondItsCapture) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0}, {0.05, 0}}, false)}));
    for (const Mode mode : {Mode::groove, Mode::ridge, Mode::stay}) {
        ContactSettings settings;
        settings.mode = mode;
        ContactMachine machine;
        machine.reset(scene, {0.0, 0.01}, 0.0);
        EXPECT_EQ(machine.step({0.0, 0.004}, 0.0, settings, {}).force, Force{});
        const double d = 0.001;
        const double share = d / settings.capture_m;
        const double expected = mode == Mode::stay ? 500.0 * d * (1.0 - std::pow(share, 8))
                                                   : 500.0 * d * std::pow(1.0 - share * share, 2);
        const ContactReport report = machine.step({0.0, d}, 0.0, settings, {});
        EXPECT_NEAR(report.force.y, mode == Mode::ridge ? expected : -expected, 1e-12);
        EXPECT_EQ(report.state, ContactState::edge);
        EXPECT_EQ(report.side, Side::left);
        EXPECT_EQ(machine.step({0.0, -d}, 0.0, settings, {}).side, Side::right);
        EXPECT_NEAR(report.p_WP.y, 0.0, 1e-15);
        ContactMachine unable;
        unable.reset(scene, {0.0, 0.01}, 0.0);
        const ContactReport cut = unable.step({0.0, d}, 0.0, settings, {.boxes = 0});
        EXPECT_EQ(cut.boxes, 0);
        EXPECT_EQ(cut.clear, 0.0);
        EXPECT_EQ(cut.force, Force{});
    }
}

TEST(Groove, ANearerLineTakesOverByAMarginAndGently) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0.001}, {0.05, 0.001}}, false),
                                         outline({{-0.05, -0.001}, {0.05, -0.001}}, false)}));
    const ContactSettings settings = settings_of(Mode::groove);
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.0008}, 0.0);
    Force force = machine.step({0.0, 0.0008}, 0.0, settings, {}).force;
    int taken_over = 0;
    for (int i = 0; i <= 1600; ++i) {  // 1 um a tick from line to line
        const double y = 0.0008 - 1e-6 * i;
        const ContactReport report = machine.step({0.0, y}, 0.0, settings, {});
        ASSERT_LE(norm(report.force - force), 0.031) << y;
        force = report.force;
        if (y > -0.0001) {
            ASSERT_EQ(report.outline, 0) << y;
        }
        if (y < -0.00015) {
            ASSERT_EQ(report.outline, 1) << y;
        }
        taken_over += report.outline;
    }
    EXPECT_GT(taken_over, 600);
    EXPECT_NEAR(force.y, -500.0 * 0.0002 * std::pow(1.0 - std::pow(0.2 / 3.0, 2), 2), 1e-6);
}

TEST(Groove, AHandBetweenTwoRidgesComesToRest) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0.0015}, {0.05, 0.0015}}, false),
                                         outline({{-0.05, -0.0015}, {0.05, -0.0015}}, false)}));
    const ContactSettings settings = settings_of(Mode::ridge);
    ContactMachine machine;
    Position hand{0.0, 0.0012};
    machine.reset(scene, hand, 0.0);
    double moved_m = 0.0;
    for (int i = 0; i < 3000; ++i) {
        const Force force = machine.step(hand, 0.0, settings, {}).force;
        const Position moved = along<Position>(force, tick_s / 3.0);  // 3 N s/m, no mass
        hand += moved;
        if (i >= 2000) moved_m = std::max(moved_m, norm(moved));
    }
    EXPECT_NEAR(hand.y, 0.0, 2e-4);
    EXPECT_LE(moved_m, 1e-7);
}

/// Returns how far a hand of 3 N s/m gets that pushes off a line for two seconds.
double way_off_m(Mode mode, double push_N) {
    const Scene scene = scene_of(map_of({outline({{-0.05, 0.0}, {0.05, 0.0}}, false)}));
    ContactMachine machine;
    Position hand{0.0, 1e-4};
    machine.reset(scene, hand, 0.0);
    for (int i = 0; i < 2000; ++i) {
        const Force line = machine.step(hand, 0.0, settings_of(mode), {}).force;
        hand += along<Position>(line + Force{0.0, push_N}, tick_s / 3.0);
    }
    return hand.y;
}

TEST(Groove, LeavingTakesAPushAndLeavingStayADeliberateOne) {
    EXPECT_LT(way_off_m(Mode::groove, 0.3), 0.001);
    EXPECT_GT(way_off_m(Mode::groove, 0.5), 0.01);
    EXPECT_LT(way_off_m(Mode::stay, 0.9), 0.0023);
    EXPECT_GT(way_off_m(Mode::stay, 1.1), 0.01);
    EXPECT_GT(way_off_m(Mode::ridge, 0.0), 0.002);
}

TEST(Groove, AChangeOfLevelMovesTheLineUnderARestingHandGently) {
    std::vector<Position> points;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 512; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 512.0;
        const double r = 0.03 + 0.002 * std::sin(9.0 * angle) + 2e-4 * unit(random);
        points.push_back(r * Position{std::cos(angle), std::sin(angle)});
    }
    const Scene scene = scene_of(map_of({outline(points, true)}));
    const double coarsest = scene.curves.coarsest();
    ASSERT_GE(coarsest, 4.0);
    for (const Mode mode : hold_modes) {
        for (int place = 0; place < 20; ++place) {
            const double angle = 3.0 * unit(random);
            const Position hand =
                (0.03 + 0.0015 * unit(random)) * Position{std::cos(angle), std::sin(angle)};
            ContactMachine machine;
            machine.reset(scene, hand, 0.0);
            Force force = machine.step(hand, 0.0, settings_of(mode), {}).force;
            for (int i = 0; i < 6000; ++i) {
                const double wanted = (i / 1500) % 2 == 0 ? coarsest - 0.5 : 0.0;
                const ContactReport report = machine.step(hand, wanted, settings_of(mode), {});
                // The level may change 0.015 N; a strand that came nearer takes over as gently.
                ASSERT_LE(norm(report.force - force), 0.03) << static_cast<int>(mode) << " " << i;
                force = report.force;
                if (i % 1500 == 1499) {
                    ASSERT_EQ(machine.rendered_level(), wanted);
                }
            }
        }
    }
}

TEST(Groove, AChangeOfLevelKeepsTheParameter) {
    std::vector<Position> points;
    for (int i = 0; i <= 64; ++i) {
        const double x = -0.05 + 0.1 * i / 64.0;
        points.push_back({x, 0.004 * std::sin(60.0 * x)});
    }
    const Scene scene = scene_of(map_of({outline(points, false)}));
    for (const double from : {0.0, 1.0, 1.75, 2.0}) {
        for (const double to : {0.0, 0.5, 1.0, 2.0, 2.25}) {
            const int count = scene.curves.rendered_count(0, from);
            for (int j = 0; j < count; ++j) {
                const Attachment at{{0, j}, 0.3};
                const Attachment moved = at_level(scene.curves, at, from, to);
                EXPECT_NEAR(
                    scene.curves.outline_parameter(0, to, moved.segment.index, moved.parameter),
                    scene.curves.outline_parameter(0, from, j, 0.3), 1e-12);
            }
        }
    }
}

TEST(Groove, WhatIsNoNumberHasNoForce) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Scene scene = scene_of(map_of({outline({{-0.05, 0}, {0.05, 0}}, false)}));
    for (const Mode mode : hold_modes) {
        for (const double capture_m : {nan, 0.0, -1.0}) {
            ContactSettings settings = settings_of(mode);
            settings.capture_m = capture_m;
            ContactMachine machine;
            machine.reset(scene, {0.0, 0.001}, 0.0);
            for (int i = 0; i < 5; ++i) {
                EXPECT_EQ(machine.step({0.0, 0.001}, 0.0, settings, {}).force, Force{});
            }
        }
        ContactMachine machine;
        machine.reset(scene, {0.0, 0.001}, 0.0);
        const Force before = machine.step({0.0, 0.001}, 0.0, settings_of(mode), {}).force;
        EXPECT_EQ(machine.step({nan, 0.001}, 0.0, settings_of(mode), {}).force, Force{});
        EXPECT_EQ(machine.step({0.0, 0.001}, 0.0, settings_of(mode), {}).force, before);
    }
}

}  // namespace
}  // namespace touchline
