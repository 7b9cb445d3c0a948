// Everything that may change under a hand changes, at random and at once: level, stiffness, mode.
// The hand hardly feels what it does not do itself.
#include "haptics/contact/contact_machine.h"
#include "haptics/safety/stability_monitor.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double radius_m = 2e-3;     // of the proxy
constexpr double deepest_m = 1.4e-3;  // so the radius is 1.4 F / K
constexpr double ring_m = 0.03;
constexpr double smooth_level =
    3.0;  // 64 edges: coarser ones would move the line by more than the hand presses

struct Changes {
    int steps = 0;
    int levels = 0;
    int stiffnesses = 0;
    int modes = 0;
    double worst = 0.0;  // largest step of force, as a share of the allowed one
};

/// Returns the slope of a mode's force over the hand's way; for a wall at a rounded convex vertex.
double slope(Mode mode) {
    if (mode == Mode::wall) return 2.5;
    return mode == Mode::stay ? 8.0 : 1.0;
}

Changes wander(const Scene& scene, unsigned seed, int steps) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    ContactMachine machine;
    StiffnessRamp stiffness(500.0);
    ContactSettings settings;
    settings.radius_m = radius_m;
    Position handle{ring_m + 0.005, 0.0};
    machine.reset(scene, handle, 0.0);
    ContactReport report = machine.step(handle, 0.0, settings, {}, tick_s);
    double wanted_N_per_m = 500.0;
    double wanted_level = 0.0;
    double angle = 0.0;
    double speed_m_per_s = 0.1;
    Changes changes;
    for (int i = 0; i < steps; ++i) {
        const bool is_new_level = unit(random) < 0.05;
        if (is_new_level) wanted_level = unit(random) * (smooth_level + 1);
        if (is_new_level && unit(random) < 0.5) wanted_level = std::floor(wanted_level);
        wanted_level = std::min(wanted_level, smooth_level);
        if (unit(random) < 0.01) wanted_N_per_m = 200.0 + 500.0 * unit(random);
        if (unit(random) < 0.005) {
            settings.mode = static_cast<Mode>(static_cast<int>(4.0 * unit(random)) % 4);
            ++changes.modes;
        }
        if (unit(random) < 0.01) speed_m_per_s = 0.3 * (unit(random) - 0.5);
        angle += speed_m_per_s * tick_s / ring_m;
        const double depth_m = deepest_m * std::sin(2.0 * std::numbers::pi * 0.7 * tick_s * i);
        const Position before = handle;
        handle = (ring_m + depth_m) * Position{std::cos(angle), std::sin(angle)};
        const double last_N_per_m = settings.stiffness_N_per_m;
        settings.stiffness_N_per_m =
            stiffness.step(wanted_N_per_m, norm(report.p_WP - handle), tick_s);
        const double level = machine.rendered_level();
        const Force force = report.force;
        report = machine.step(handle, wanted_level, settings, {}, tick_s);
        changes.levels += machine.rendered_level() != level ? 1 : 0;
        changes.stiffnesses += settings.stiffness_N_per_m != last_N_per_m ? 1 : 0;
        const double K = std::max(settings.stiffness_N_per_m, last_N_per_m);
        const double allowed_N = 0.03 + slope(settings.mode) * K * norm(handle - before);
        changes.worst = std::max(changes.worst, norm(report.force - force) / allowed_N);
        ++changes.steps;
    }
    return changes;
}

TEST(Upheaval, IsHardlyFeltOnSmoothLines) {
    Changes all;
    for (unsigned seed = 0; seed < 10; ++seed) {
        std::vector<Position> points;
        const double wave_m = 2e-4 * (seed % 3);
        for (int i = 0; i < 512; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 512.0;
            points.push_back((ring_m + wave_m * std::sin(3.0 * angle)) *
                             Position{std::cos(angle), std::sin(angle)});
        }
        const Scene scene =
            build_scene(scenes::map_of({scenes::outline(points, true)}), {}, radius_m).value();
        const Changes changes = wander(scene, seed, 50000);
        EXPECT_LE(changes.worst, 1.0) << seed;
        all.steps += changes.steps;
        all.levels += changes.levels;
        all.stiffnesses += changes.stiffnesses;
        all.modes += changes.modes;
        all.worst = std::max(all.worst, changes.worst);
    }
    std::cout << "  " << all.steps << " steps, " << all.levels << " changes of the rendered level, "
              << all.stiffnesses << " of stiffness, " << all.modes
              << " of mode; largest step of the force " << all.worst << " of what is allowed\n";
    EXPECT_GT(all.levels, 50000);
    EXPECT_GT(all.modes, 1000);
}

}  // namespace
}  // namespace touchline
