// Groove, ridge and stay: no closed loop of the hand gains more energy than its bound.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/contact/hold_rig.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using scenes::map_of;
using scenes::outline;

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
        // The energy of the deepest point is 1e-3 J; the rest is the trapezoid rule's error, and in
        // stay what the hops inside the bend take.
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

/// Goes along a smooth closed path about `centre`, once to begin with and then `rounds` times.
/// Changes the level from `level` to `other` or back every 0.2 s.
Loops go_round(const Scene& scene, Mode mode, double level, double other, Position centre,
               double size_m, std::mt19937& random) {
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
        const double wanted = i / 200 % 2 == 0 ? level : other;
        const ContactReport report = machine.step(at(i), wanted, settings, {});
        loops.jump_N = std::max(
            loops.jump_N, norm(report.force - force) - steepest_N_per_m(settings) * norm(moved));
        loops.handovers +=
            outline_felt >= 0 && report.outline >= 0 && report.outline != outline_felt ? 1 : 0;
        outline_felt = report.outline;
        force = report.force;
    }
    return loops;
}

/// Returns the most energy that a line may hold when the rounds begin.
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
                const double other = trial % 4 == 0 ? level + 2.0 : level;
                const Position centre = 0.004 * Position{unit(random), unit(random)};
                const Loops loops = go_round(scene, mode, level, other, centre, size_m, random);
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

}  // namespace
}  // namespace touchline
