// A wall gives way to a deliberate push, and to no other.
#include "haptics/contact/contact_machine.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

ContactSettings giving_way(double radius_m) {
    ContactSettings settings;
    settings.radius_m = radius_m;
    settings.pop_through_N = 1.5;
    settings.pop_through_s = 0.3;
    return settings;
}

Outline line_at(double y_m) {
    return scenes::outline({{-0.05, y_m}, {0.0, y_m}, {0.05, y_m}}, false);
}

Scene scene_of(std::vector<Outline> lines, double radius_m) {
    return build_scene(scenes::map_of(std::move(lines)), {}, radius_m).value();
}

struct Push {
    int pops = 0;
    int first_tick = -1;
    double jump_N = 0.0;  // beyond K |dh|
    ContactReport last;
};

/// Comes from above, goes in to `depth_m` at `x_m` within 50 ms and slides on at a speed.
Push push(ContactMachine& machine, const ContactSettings& settings, double x_m, double depth_m,
          double slide_m_per_s, int ticks) {
    Push done;
    Position before{x_m, 0.003};
    Force force = machine.step(before, 0.0, settings, {}).force;
    for (int i = 0; i < ticks; ++i) {
        const double share = std::min(1.0, i / 50.0);
        const Position hand{x_m + 1e-3 * slide_m_per_s * i, 0.003 - share * (0.003 + depth_m)};
        done.last = machine.step(hand, 0.0, settings, {});
        if (done.last.has_popped && done.pops++ == 0) done.first_tick = i;
        done.jump_N = std::max(done.jump_N, norm(done.last.force - force) -
                                                settings.stiffness_N_per_m * norm(hand - before));
        force = done.last.force;
        before = hand;
    }
    return done;
}

Push push_a_line(const ContactSettings& settings, double x_m, double depth_m,
                 double slide_m_per_s = 0.0, int ticks = 1000) {
    const Scene scene = scene_of({line_at(0.0)}, settings.radius_m);
    ContactMachine machine;
    machine.reset(scene, {x_m, 0.003}, 0.0);
    return push(machine, settings, x_m, depth_m, slide_m_per_s, ticks);
}

TEST(PopThrough, APushThatLastsPassesTheLineOnceAndTheForceFades) {
    for (const double radius_m : {0.0, 0.0014}) {
        for (const double x_m : {0.0, 0.013, -0.02}) {
            const Push done = push_a_line(giving_way(radius_m), x_m, 0.004);
            EXPECT_EQ(done.pops, 1) << x_m;
            EXPECT_GE(done.first_tick, 300);
            EXPECT_LE(done.first_tick, 360);
            EXPECT_LE(done.jump_N, 0.03);
            EXPECT_EQ(done.last.state, ContactState::free);
            EXPECT_NEAR(done.last.p_WP.y, -0.004, 1e-12);
            EXPECT_NEAR(done.last.p_WP.x, x_m, 1e-12);
            EXPECT_EQ(done.last.force, Force{});
        }
    }
}

TEST(PopThrough, NeitherALighterNorAShorterNorASlidingPushPasses) {
    EXPECT_EQ(push_a_line(giving_way(0.0), 0.0, 0.0029).pops, 0);
    EXPECT_EQ(push_a_line(giving_way(0.0), 0.0, 0.004, 0.0, 300).pops, 0);
    EXPECT_EQ(push_a_line(giving_way(0.0), -0.03, 0.004, 0.02).pops, 0);
    ContactSettings off = giving_way(0.0);
    off.pop_through_N = 0.0;
    EXPECT_EQ(push_a_line(off, 0.0, 0.02).pops, 0);
    EXPECT_EQ(push_a_line(ContactSettings{}, 0.0, 0.02).pops, 0);
}

TEST(PopThrough, NeverPassesASecondLine) {
    for (const double radius_m : {0.0, 0.0014}) {
        const ContactSettings settings = giving_way(radius_m);
        for (const double behind_m : {0.0, 1e-4, 1e-3}) {
            for (const int ticks : {500, 1000}) {
                const Scene scene = scene_of({line_at(0.0), line_at(-behind_m)}, radius_m);
                ContactMachine machine;
                machine.reset(scene, {0.01, 0.003}, 0.0);
                const Push done = push(machine, settings, 0.01, 0.006, 0.0, ticks);
                // The next line takes a push of its own, as long again; two lines in one place
                // hold.
                const int lines = ticks == 500 ? 1 : 2;
                EXPECT_EQ(done.pops, behind_m > 0.0 ? lines : 0);
                if (lines == 1) {
                    EXPECT_GE(done.last.p_WP.y, -behind_m);
                }
                EXPECT_LE(done.jump_N, 0.03);
            }
        }
    }
}

/// A push into the hollow of a smooth curve keeps finding vertices, one beside the other.
TEST(PopThrough, ACurveGivesWayFromWithinAndFromWithout) {
    for (const double radius_m : {0.0, 0.0014}) {
        for (const double bend : {-1.0, 1.0}) {
            Outline arc = scenes::outline({}, false);
            for (int i = -20; i <= 20; ++i) {
                const double turn = 0.02 * i;
                arc.points.push_back({0.03 * std::sin(turn), bend * 0.03 * (1.0 - std::cos(turn))});
            }
            for (const double x_m : {0.0, 0.0003, -0.0041}) {
                const Scene scene = scene_of({arc}, radius_m);
                ContactMachine machine;
                machine.reset(scene, {x_m, 0.003}, 0.0);
                const Push done = push(machine, giving_way(radius_m), x_m, 0.006, 0.0, 2000);
                EXPECT_EQ(done.pops, 1) << radius_m << ' ' << bend << ' ' << x_m;
                EXPECT_LE(done.jump_N, 0.03);
                EXPECT_EQ(done.last.force, Force{});
            }
        }
    }
}

TEST(PopThrough, ACornerHolds) {
    const Outline corner = scenes::outline({{-0.02, 0.02}, {0.0, 0.0}, {0.02, 0.02}}, false);
    const Scene scene = scene_of({corner}, 0.0);
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.003}, 0.0);
    EXPECT_EQ(push(machine, giving_way(0.0), 0.0, 0.006, 0.0, 2000).pops, 0);
}

TEST(PopThrough, TheLineHoldsAgainFromTheOtherSide) {
    const ContactSettings settings = giving_way(0.0014);
    const Scene scene = scene_of({line_at(0.0)}, settings.radius_m);
    ContactMachine machine;
    machine.reset(scene, {0.0, 0.003}, 0.0);
    (void)push(machine, settings, 0.0, 0.004, 0.0, 600);
    ContactReport report;
    for (int i = 0; i <= 50; ++i) {
        report = machine.step({0.0, -0.004 + 0.0001 * i}, 0.0, settings, {});
    }
    EXPECT_NEAR(report.p_WP.y, -0.0014, 1e-9);
    EXPECT_NEAR(report.force.y, -500.0 * 0.0024, 1e-6);
}

}  // namespace
}  // namespace touchline
