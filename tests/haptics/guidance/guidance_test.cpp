#include "haptics/guidance/guidance.h"

#include "tests/haptics/scenes.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A hand of 0.2 kg that the force moves against 4 N s/m, or that somebody holds.
struct Rig {
    explicit Rig(const TactileMap& map) : scene(build_scene(map, {}, 0.0).value()) {
        (void)tick();  // the first number begins nothing
    }

    Force tick() {
        const Force force = guidance.step({&scene, handle, velocity, is_live, command}, tick_s);
        if (!is_held) {
            velocity += tick_s / 0.2 * (along<Velocity>(force, 1.0) - 4.0 * velocity);
            handle += along<Position>(velocity, tick_s);
        } else {
            velocity = {};
        }
        most_N = std::max(most_N, norm(force));
        jump_N = std::max(jump_N, norm(force - last));
        fastest_m_per_s = std::max(fastest_m_per_s, norm(velocity));
        last = force;
        return force;
    }

    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) (void)tick();
    }

    int run_until(GuidancePhase phase, int most) {
        int ticks = 0;
        while (guidance.status().phase != phase && ticks < most) {
            (void)tick();
            ++ticks;
        }
        return ticks;
    }

    void ask(const GuidanceCommand& wanted) {
        const std::uint32_t serial = command.serial + 1;
        command = wanted;
        command.serial = serial;
    }

    Scene scene;
    Guidance guidance;
    GuidanceCommand command;
    Position handle{0.0, 0.0};
    Velocity velocity;
    bool is_live = true;
    bool is_held = false;
    Force last;
    double most_N = 0.0;
    double jump_N = 0.0;
    double fastest_m_per_s = 0.0;
};

TactileMap ring_and_line() {
    TactileMap map = scenes::map_of(
        {scenes::circle(0.02, 120), scenes::outline({{-0.03, 0.03}, {0.03, 0.03}}, false)});
    map.labels.push_back({"left", {-0.02, 0.0}});
    return map;
}

TEST(Guidance, ATourGoesAllAlongTheOutlineAndArrives) {
    Rig rig(ring_and_line());
    rig.ask({GuidanceKind::tour, false, 0, 0, {}, 0.035});
    double reached = 0.0;  // share of the ring, by angle
    Position before;
    double furthest_m = 0.0;
    bool was_at_label = false;
    for (int i = 0; i < 20'000 && rig.guidance.status().phase != GuidancePhase::arrived; ++i) {
        (void)rig.tick();
        const GuidanceStatus& status = rig.guidance.status();
        was_at_label =
            was_at_label || (status.phase == GuidancePhase::pausing && status.label == 0);
        if (!status.is_on_line) continue;
        furthest_m = std::max(furthest_m, std::abs(norm(rig.handle) - 0.02));
        if (before != Position{})
            reached += cross(before, rig.handle) / (norm(before) * norm(rig.handle));
        before = rig.handle;
    }
    EXPECT_EQ(rig.guidance.status().phase, GuidancePhase::arrived);
    EXPECT_EQ(rig.guidance.status().outline, 0);
    EXPECT_NEAR(reached, 2.0 * 3.14159, 0.15);
    EXPECT_LT(furthest_m, 0.001);
    EXPECT_TRUE(was_at_label);
    EXPECT_LE(rig.most_N, most_guide_N);
    EXPECT_LT(rig.jump_N, 0.03);
    EXPECT_LT(rig.fastest_m_per_s, 0.045);
}

TEST(Guidance, ATourOfAllGoesOverToTheNextOutline) {
    Rig rig(ring_and_line());
    rig.ask({GuidanceKind::tour, false, 0, -1, {}, 0.04});
    ASSERT_LT(rig.run_until(GuidancePhase::arrived, 40'000), 40'000);
    EXPECT_EQ(rig.guidance.status().outline, 1);
    EXPECT_LT(norm(rig.handle - Position{0.03, 0.03}), 0.003);
}

TEST(Guidance, WaitsForAHandThatIsHeldAndGoesOnWithIt) {
    Rig rig(ring_and_line());
    rig.ask({GuidanceKind::tour, false, 0, 0, {}, 0.035});
    rig.run(2'500);
    rig.is_held = true;
    rig.run(2'000);
    EXPECT_EQ(rig.guidance.status().phase, GuidancePhase::waiting);
    const Position waits_at = rig.guidance.status().leading;
    EXPECT_LT(norm(waits_at - rig.handle), 0.0045);
    rig.run(3'000);
    EXPECT_LT(norm(rig.guidance.status().leading - waits_at), 1e-4);
    EXPECT_LE(rig.most_N, most_guide_N);
    rig.is_held = false;
    EXPECT_LT(rig.run_until(GuidancePhase::running, 1'000), 1'000);
    ASSERT_LT(rig.run_until(GuidancePhase::arrived, 20'000), 20'000);
}

TEST(Guidance, TheKioskMayHoldIt) {
    Rig rig(ring_and_line());
    rig.ask({GuidanceKind::tour, false, 0, 0, {}, 0.035});
    rig.run(2'500);
    rig.command.is_held = true;
    rig.run(300);
    const Position at = rig.guidance.status().leading;
    rig.run(2'000);
    EXPECT_EQ(rig.guidance.status().leading, at);
    EXPECT_EQ(rig.guidance.status().phase, GuidancePhase::waiting);
    rig.command.is_held = false;
    ASSERT_LT(rig.run_until(GuidancePhase::arrived, 20'000), 20'000);
}

TEST(Guidance, EndsWithin50msOfAnyNewCommand) {
    for (const GuidanceKind next : {GuidanceKind::none, GuidanceKind::to_place}) {
        Rig rig(ring_and_line());
        rig.ask({GuidanceKind::tour, false, 0, 0, {}, 0.035});
        rig.run(2'000);
        rig.is_held = true;
        rig.run(1'000);
        ASSERT_GT(norm(rig.last), 0.5);
        rig.jump_N = 0.0;
        rig.ask({next, false, 0, -1, rig.handle, 0.035});
        rig.run(1);
        EXPECT_EQ(rig.guidance.status().serial, 2U);
        rig.run(48);
        EXPECT_LT(norm(rig.last), 0.02);
        EXPECT_LT(rig.jump_N, 0.06);
    }
}

TEST(Guidance, HA2_ForceComesOnIn300ms) {
    Rig rig(ring_and_line());
    rig.is_held = true;
    rig.ask({GuidanceKind::to_place, false, 0, -1, {0.05, 0.0}, 0.1});
    for (int i = 1; i < 300; ++i) EXPECT_LE(norm(rig.tick()), most_guide_N * (i + 1) / 300.0);
    rig.run(300);
    EXPECT_GT(norm(rig.last), 0.8);
}

TEST(Guidance, LeadsToAPlaceWithinTheArea) {
    Rig rig(ring_and_line());
    rig.ask({GuidanceKind::to_place, false, 0, -1, {0.2, 0.01}, 0.035});
    ASSERT_LT(rig.run_until(GuidancePhase::arrived, 5'000), 5'000);
    EXPECT_LT(norm(rig.handle - within(rig.scene.area, {0.2, 0.01})), 0.003);
    rig.run(60);
    EXPECT_EQ(rig.last, Force{});
}

TEST(Guidance, BringsBackToTheNearestLine) {
    Rig rig(ring_and_line());
    rig.handle = {0.005, 0.05};
    rig.ask({GuidanceKind::to_line, false, 0, -1, {}, 0.035});
    ASSERT_LT(rig.run_until(GuidancePhase::arrived, 5'000), 5'000);
    EXPECT_EQ(rig.guidance.status().outline, 1);
    EXPECT_LT(norm(rig.handle - Position{0.005, 0.03}), 0.003);
}

TEST(Guidance, NeverMovesTheHandleUnasked) {
    Rig rig(ring_and_line());
    rig.run(2'000);
    EXPECT_EQ(rig.most_N, 0.0);
    // A new servo is told an old command first.
    Guidance anew;
    const GuidanceCommand old{GuidanceKind::tour, false, 9, 0, {}, 0.035};
    double most_N = 0.0;
    for (int i = 0; i < 2'000; ++i)
        most_N = std::max(most_N, norm(anew.step({&rig.scene, {0.0, 0.0}, {}, true, old}, tick_s)));
    EXPECT_EQ(most_N, 0.0);
    EXPECT_EQ(anew.status().phase, GuidancePhase::stopped);
    EXPECT_EQ(anew.status().serial, 9U);
}

TEST(Guidance, ForceThatIsNotLiveStopsItForGood) {
    Rig rig(ring_and_line());
    rig.ask({GuidanceKind::tour, false, 0, 0, {}, 0.035});
    rig.run(2'000);
    ASSERT_GT(norm(rig.last), 0.05);
    rig.is_live = false;
    rig.run(45);
    EXPECT_EQ(rig.last, Force{});
    rig.is_live = true;
    rig.run(1'000);
    EXPECT_EQ(rig.last, Force{});
    EXPECT_EQ(rig.guidance.status().phase, GuidancePhase::stopped);
}

TEST(Guidance, WhatIsAskedBeforeForceIsLiveWaitsForIt) {
    Rig rig(ring_and_line());
    rig.is_live = false;
    rig.ask({GuidanceKind::to_line, false, 0, -1, {}, 0.035});
    rig.run(500);
    EXPECT_EQ(rig.most_N, 0.0);
    EXPECT_EQ(rig.guidance.status().phase, GuidancePhase::waiting);
    rig.is_live = true;
    EXPECT_LT(rig.run_until(GuidancePhase::arrived, 5'000), 5'000);
}

TEST(Guidance, AnotherSceneStopsIt) {
    Rig rig(ring_and_line());
    rig.ask({GuidanceKind::tour, false, 0, 1, {}, 0.035});
    rig.run(2'000);
    rig.guidance.leave_scene();
    rig.scene = build_scene(scenes::map_of({scenes::square(0.01, 1)}), {}, 0.0).value();
    EXPECT_TRUE(rig.guidance.fits(&rig.scene));
    rig.run(45);
    EXPECT_EQ(rig.last, Force{});
    EXPECT_EQ(rig.guidance.status().phase, GuidancePhase::stopped);
}

TEST(Guidance, AnOutlineThatThereIsNotIsNoTour) {
    Rig rig(ring_and_line());
    rig.ask({GuidanceKind::tour, false, 0, 5, {}, 0.035});
    rig.run(100);
    EXPECT_EQ(rig.guidance.status().phase, GuidancePhase::stopped);
    EXPECT_EQ(rig.most_N, 0.0);
}

}  // namespace
}  // namespace touchline
