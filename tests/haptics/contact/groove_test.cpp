// Groove, ridge and stay: their laws, what they may do to the hand, and how they change lines and
// levels.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using scenes::map_of;
using scenes::outline;

constexpr double tick_s = 1e-3;
constexpr std::array hold_modes{Mode::groove, Mode::ridge, Mode::stay};

Scene scene_of(const TactileMap& map) {
    return build_scene(map, {}, 0.0).value();
}

ContactSettings settings_of(Mode mode) {
    ContactSettings settings;
    settings.mode = mode;
    return settings;
}

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
        const ContactReport cut = unable.step({0.0, d}, 0.0, settings, {0, 0});
        EXPECT_EQ(cut.boxes, 0);
        EXPECT_EQ(cut.clear, 0.0);
        EXPECT_EQ(cut.force, Force{});
    }
}

TEST(Groove, NoClosedLoopOfTheHandGainsEnergy) {
    const Scene scene = scene_of(map_of({scenes::circle(0.02, 200)}));
    for (const Mode mode : {Mode::groove, Mode::ridge, Mode::stay}) {
        ContactSettings settings;
        settings.mode = mode;
        ContactMachine machine;
        machine.reset(scene, {0.022, 0.0}, 0.0);
        double work_J = 0.0;
        Position before{0.022, 0.0};
        Force force = machine.step(before, 0.0, settings, {}).force;
        constexpr int steps = 20000;
        for (int i = 1; i <= steps; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / steps;
            const double r = 0.0205 + 0.0015 * std::cos(7.0 * angle);
            const Position handle = r * Position{std::cos(angle), std::sin(angle)};
            const Force next = machine.step(handle, 0.0, settings, {}).force;
            work_J += 0.5 * dot(force + next, handle - before);
            force = next;
            before = handle;
        }
        // The energy of the deepest point is 1e-3 J; the rest is the trapezoid rule's, and in stay
        // what the hops inside the bend take.
        EXPECT_LE(work_J, 1e-7) << static_cast<int>(mode);
        EXPECT_GE(work_J, mode == Mode::stay ? -2e-5 : -1e-7) << static_cast<int>(mode);
    }
}

struct Loops {
    double gained_J = 0.0;   // work on the hand
    double allowed_J = 0.0;  // 1/2 K |dh|^2 of every tick and 0.1 mW (haptics/contact/groove.h)
    double jump_N = 0.0;     // largest change of force in a tick beyond what the laws give
    int handovers = 0;
};

/// The attachment slides up to twice as far as the hand moves.
double steepest_N_per_m(const ContactSettings& settings) {
    return 3.0 * CaptureLaw(settings).steepest_N_per_m();
}

constexpr int rounds = 4;

/// A smooth closed path about `centre`, gone round once to begin with and then `rounds` times.
Loops go_round(const Scene& scene, Mode mode, double level, Position centre, double size_m,
               std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::array<Position, 4> waves;
    for (Position& wave : waves) wave = size_m * Position{unit(random), unit(random)};
    const ContactSettings settings = settings_of(mode);
    const auto ticks = static_cast<int>(400.0 + 1500.0 * std::abs(unit(random)));
    const auto at = [&](int i) {
        Position p = centre;
        for (std::size_t k = 0; k < waves.size(); ++k) {
            const double angle =
                2.0 * std::numbers::pi * static_cast<double>(k / 2 + 1) * i / ticks;
            const double share = k % 2 == 0 ? std::cos(angle) : std::sin(angle);
            p += share * waves[k];
        }
        return p;
    };
    ContactMachine machine;
    machine.reset(scene, at(0), level);
    Loops loops;
    Force force = machine.step(at(0), level, settings, {}).force;
    int outline_felt = -1;
    for (int i = 1; i <= (1 + rounds) * ticks; ++i) {
        const Position moved = at(i) - at(i - 1);
        if (i > ticks) {
            loops.gained_J += dot(force, moved);
            loops.allowed_J += 0.5 * settings.stiffness_N_per_m * dot(moved, moved) + 1e-4 * tick_s;
        }
        const ContactReport report = machine.step(at(i), level, settings, {});
        loops.jump_N = std::max(
            loops.jump_N, norm(report.force - force) - steepest_N_per_m(settings) * norm(moved));
        loops.handovers +=
            outline_felt >= 0 && report.outline >= 0 && report.outline != outline_felt ? 1 : 0;
        outline_felt = report.outline;
        force = report.force;
    }
    return loops;
}

/// What a line may hold when the rounds begin.
double most_stored_J(const ContactSettings& settings) {
    const CaptureLaw law(settings);
    return std::max(law.energy_J(0.0), law.energy_J(settings.capture_m));
}

/// Two lines side by side, two that cross, a sharp corner, and random curves.
std::vector<Scene> busy_scenes() {
    std::vector<Scene> made;
    made.push_back(scene_of(map_of({outline({{-0.05, 0.001}, {0.05, 0.001}}, false),
                                    outline({{-0.05, -0.001}, {0.05, -0.001}}, false)})));
    made.push_back(scene_of(map_of({outline({{-0.05, 0.0}, {0.05, 0.0}}, false),
                                    outline({{-0.03, -0.05}, {0.03, 0.05}}, false)})));
    made.push_back(scene_of(map_of({outline({{-0.02, -0.05}, {0.0, 0.0}, {0.02, -0.05}}, false)})));
    for (unsigned seed = 0; seed < 4; ++seed)
        made.push_back(scene_of(scenes::random_map(seed, 12)));
    return made;
}

TEST(Groove, NoClosedLoopAmongLinesGainsMoreThanItsBound) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int handovers = 0;
    double jump_N = 0.0;
    double worst = -1e9;
    for (const Scene& scene : busy_scenes()) {
        for (const Mode mode : hold_modes) {
            for (int trial = 0; trial < 20; ++trial) {
                const double size_m = trial % 2 == 0 ? 0.001 : 0.004;
                const double level = trial % 3 == 0 ? 0.0 : 1.5 * std::abs(unit(random));
                const Position centre = 0.004 * Position{unit(random), unit(random)};
                const Loops loops = go_round(scene, mode, level, centre, size_m, random);
                const double stored_J = most_stored_J(settings_of(mode));
                ASSERT_LE(loops.gained_J, loops.allowed_J + stored_J) << static_cast<int>(mode);
                worst = std::max(worst, loops.gained_J / (loops.allowed_J + stored_J));
                jump_N = std::max(jump_N, loops.jump_N);
                handovers += loops.handovers;
            }
        }
    }
    std::cout << "  " << handovers << " handovers, gained at most " << worst
              << " of the bound, largest jump of the force " << jump_N << " N\n";
    EXPECT_GT(handovers, 500);
    EXPECT_LE(jump_N, 0.07);
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

/// How far a hand of 3 N s/m gets that pushes off a line for two seconds.
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
                // 0.015 N by the level; a strand that came nearer takes over as gently.
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
