// Changes of level under the hand: the wall moves, and the proxy follows and keeps its side.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/collision/crossings.h"
#include "tests/haptics/contact/hold_rig.h"
#include "tests/haptics/scenes.h"
#include "tests/lab/bench/workload.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double stiffness_N_per_m = 500.0;
constexpr Position far_off{0.5, 0.313};

bool is_inside(const Scene& scene, Position p, double level) {
    return crossings(scene.tree, scene.curves, p, far_off, level) % 2 != 0;
}

struct Outcome {
    int steps = 0;
    int in_contact = 0;
    int levels = 0;  // steps that changed the level
    int sides_flipped = 0;
};

/// Presses in and out along the ring while the wanted level changes now and then.
Outcome wander(const Scene& scene, unsigned seed, const ContactSettings& settings, int steps) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    ContactMachine machine;
    Position handle{0.045, 0.0};
    machine.reset(scene, handle, 0.0);
    bool is_in = is_inside(scene, machine.proxy().centre, 0.0);
    double wanted = 0.0;
    double angle = 0.0;
    double speed_m_per_s = 0.1;
    Outcome outcome;
    double level = 0.0;
    for (int i = 0; i < steps; ++i) {
        if (unit(random) < 0.05) wanted = std::floor(unit(random) * (scene.curves.coarsest() + 2));
        if (unit(random) < 0.02) wanted = unit(random) * scene.curves.coarsest();
        if (unit(random) < 0.01) speed_m_per_s = 0.3 * (unit(random) - 0.5);
        angle += speed_m_per_s * 1e-3 / 0.03;
        const double depth_m = 0.004 * std::sin(2.0 * std::numbers::pi * 0.7e-3 * i) - 0.001;
        handle = (0.03 + depth_m) * Position{std::cos(angle), std::sin(angle)};
        const ContactReport report = machine.step(handle, wanted, settings, {});
        const double rendered = machine.rendered_level();
        const bool is_now_in = is_inside(scene, report.p_WP, rendered);
        outcome.sides_flipped += is_now_in != is_in ? 1 : 0;
        is_in = is_now_in;
        outcome.levels += rendered != level ? 1 : 0;
        level = rendered;
        outcome.in_contact += report.state != ContactState::free ? 1 : 0;
        ++outcome.steps;
    }
    return outcome;
}

TEST(LevelChange, NeverFlipsASideOnRoughRings) {
    int levels = 0;
    int in_contact = 0;
    int steps = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const double radius_m = seed % 4 == 3 ? 1e-3 : 0.0;
        const Scene scene = scene_of(scenes::rough_ring(seed, 2e-4 * (seed % 3)), radius_m);
        ContactSettings settings;
        settings.radius_m = radius_m;
        settings.friction = seed % 5 == 4 ? 0.15 : 0.0;
        const Outcome outcome = wander(scene, seed, settings, 50000);
        EXPECT_EQ(outcome.sides_flipped, 0) << seed;
        levels += outcome.levels;
        in_contact += outcome.in_contact;
        steps += outcome.steps;
    }
    std::cout << "  " << steps << " steps, " << in_contact << " in contact, " << levels
              << " changes of the rendered level\n";
    EXPECT_GT(levels, 100000);
    EXPECT_GT(in_contact, 300000);
}

TEST(LevelChange, PushesARestingHandByAFewHundredthsOfANewtonATick) {
    const Scene scene = scene_of(scenes::map_of({scenes::circle(0.03, 512)}));
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    double largest_N = 0.0;
    int levels = 0;
    for (int place = 0; place < 200; ++place) {
        const double angle = 2.0 * std::numbers::pi * unit(random);
        const Direction out{std::cos(angle), std::sin(angle)};
        const bool is_outside = unit(random) < 0.5;
        const double rest_m = 0.03 + (is_outside ? -1.0 : 1.0) * 0.003 * unit(random);
        ContactMachine machine;
        machine.reset(scene, along<Position>(out, is_outside ? 0.034 : 0.026), 0.0);
        Force force = machine.step(along<Position>(out, rest_m), 0.0, {}, {}).force;
        for (int i = 0; i < 2000; ++i) {
            const double wanted = (i / 400) % 2 == 0 ? scene.curves.coarsest() - 2.0 : 0.0;
            const double before = machine.rendered_level();
            const Force now = machine.step(along<Position>(out, rest_m), wanted, {}, {}).force;
            levels += machine.rendered_level() != before ? 1 : 0;
            largest_N = std::max(largest_N, norm(now - force));
            force = now;
        }
    }
    std::cout << "  " << levels << " changes of the rendered level, largest step of the force "
              << largest_N << " N\n";
    EXPECT_GT(levels, 2000);
    EXPECT_LE(largest_N, 0.03);
}

TEST(LevelChange, IsSeenThroughUnderAHandThatPressesAndRests) {
    const Scene scene = scene_of(scenes::map_of({scenes::circle(0.03, 512)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.0}, 0.0);
    ContactReport report = machine.step({0.0, 0.032}, 0.0, {}, {});
    for (int i = 0; i < 1000; ++i) report = machine.step({0.0, 0.032}, 4.0, {}, {});
    EXPECT_EQ(machine.rendered_level(), 4.0);
    EXPECT_NEAR(report.level, 4.0, 0.0);
    for (int i = 0; i < 5000; ++i) report = machine.step({0.0, 0.032}, 0.0, {}, {});
    EXPECT_EQ(machine.rendered_level(), 0.0);
    EXPECT_NEAR(report.p_WP.y, 0.03, 1e-5);
    EXPECT_NE(report.state, ContactState::free);
}

TEST(LevelChange, IsAtOnceWhereTheProxyIsFarFromEveryBox) {
    const Scene scene = scene_of(scenes::map_of({scenes::circle(0.03, 512)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.0}, 0.0);
    static_cast<void>(machine.step({0.0, 0.001}, 4.0, {}, {}));
    EXPECT_EQ(machine.rendered_level(), 4.0);
    static_cast<void>(machine.step({0.0, 0.002}, 0.0, {}, {}));
    EXPECT_EQ(machine.rendered_level(), 0.0);
}

TEST(LevelChange, DoesNoMoreWorkOnTheHandThanTheHandDid) {
    // The hand presses at the middle of a coarse chord; the level changes every 50 ms.
    const Scene scene = scene_of(scenes::map_of({scenes::circle(0.03, 512)}));
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.035}, 0.0);
    const double coarse = scene.curves.coarsest();
    double work_J = 0.0;
    double stored_J = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const Position handle{0.0003 * std::sin(1e-3 * i), 0.028};
        const double wanted = (i / 50) % 2 == 0 ? coarse : 0.0;
        const ContactReport report = machine.step(handle, wanted, {}, {});
        const double now_J = 0.5 * stiffness_N_per_m * std::pow(norm(report.p_WP - handle), 2);
        if (i > 0) work_J += now_J - stored_J;  // the hand hardly moves, so this is the wall's work
        stored_J = now_J;
    }
    EXPECT_LE(work_J, 20.0 * 1e-4 + 1e-4);
}

}  // namespace
}  // namespace touchline
