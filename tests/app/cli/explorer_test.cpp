#include "app/cli/tour.h"
#include "haptics/collision/scene.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double dt_s = 1e-3;

Outline circle(Position centre, double radius_m, bool is_clockwise = false) {
    Outline outline;
    outline.is_closed = true;
    for (int i = 0; i < 128; ++i) {
        const double angle_rad = (is_clockwise ? -2.0 : 2.0) * std::numbers::pi * i / 128;
        outline.points.push_back(
            centre + Position{radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad)});
    }
    return outline;
}

TactileMap map_of(std::vector<Outline> outlines) {
    TactileMap map;
    map.outlines = std::move(outlines);
    map.version = 1;
    return map;
}

Scene scene_of(const TactileMap& map) {
    auto scene = build_scene(map, CurveOptions{}, 0.0014);
    EXPECT_TRUE(scene.has_value());
    return std::move(*scene);
}

/// A servo that renders at once, and a hand that never touches anything.
Felt nothing_felt(const Explorer& explorer) {
    return {explorer.intention().position,
            {},
            false,
            explorer.is_lifted() ? MapForce::off : MapForce::on};
}

/// Ticks until the explorer is done and returns the time; -1 if that takes longer than `limit_s`.
double run_without_contact(Explorer& explorer, double limit_s) {
    for (int tick = 0; tick * dt_s < limit_s; ++tick) {
        if (explorer.is_done()) return tick * dt_s;
        explorer.step(nothing_felt(explorer), dt_s);
    }
    return -1.0;
}

TEST(Route, AroundAClosedOutlineOutwardIsOutside) {
    for (const bool is_clockwise : {false, true}) {
        const auto route = route_along(circle({0.01, 0.0}, 0.02, is_clockwise));
        for (const RoutePoint& point : route) {
            const Direction from_centre = direction_of(point.on - Position{0.01, 0.0});
            EXPECT_GT(dot(from_centre, point.outward), 0.95);
        }
    }
}

TEST(Route, AClosedOutlineIsWalkedALittleMoreThanOnce) {
    const auto route = route_along(circle({0.0, 0.0}, 0.02));
    const double length_m = 2.0 * std::numbers::pi * 0.02;
    EXPECT_GT(static_cast<double>(route.size()) * 0.0005, length_m);
    EXPECT_LT(static_cast<double>(route.size()) * 0.0005, 1.1 * length_m);
}

TEST(Route, AnOpenOutlineHasItsLeftOutward) {
    Outline line;
    line.points = {{-0.02, 0.0}, {0.02, 0.0}};
    const auto route = route_along(line);
    EXPECT_EQ(route.front().on, (Position{-0.02, 0.0}));
    EXPECT_EQ(route.back().on, (Position{0.02, 0.0}));
    for (const RoutePoint& point : route) EXPECT_NEAR(point.outward.y, 1.0, 1e-12);
}

TEST(Explorer, StartsBesideTheFirstOutline) {
    const TactileMap map = map_of({circle({0.0, 0.0}, 0.02)});
    const Scene scene = scene_of(map);
    const Explorer explorer(map, scene, ExplorerOptions{});
    EXPECT_NEAR(norm(explorer.start()), 0.023, 1e-4);
    EXPECT_TRUE(explorer.is_lifted());
}

TEST(Explorer, AnEmptyMapIsDoneAtOnce) {
    const TactileMap map = map_of({});
    const Scene scene = scene_of(map);
    EXPECT_TRUE(Explorer(map, scene, ExplorerOptions{}).is_done());
}

TEST(Explorer, WhatCannotBeReachedIsLeftOut) {
    const TactileMap map = map_of({circle({0.2, 0.0}, 0.02), circle({0.0, 0.0}, 0.01)});
    const Scene scene = scene_of(map);
    Explorer explorer(map, scene, ExplorerOptions{});
    EXPECT_NEAR(norm(explorer.start()), 0.013, 1e-4);
    EXPECT_GE(run_without_contact(explorer, 600.0), 0.0);
    EXPECT_EQ(explorer.visited(), 1);
}

TEST(Explorer, EndsThoughItNeverTouchesAnything) {
    const TactileMap map = map_of({circle({-0.03, 0.0}, 0.01), circle({0.03, 0.0}, 0.01)});
    const Scene scene = scene_of(map);
    Explorer explorer(map, scene, ExplorerOptions{});
    EXPECT_GE(run_without_contact(explorer, 600.0), 0.0);
    EXPECT_EQ(explorer.visited(), 2);
}

TEST(Explorer, GivesUpWhereNoForceComesOn) {
    const TactileMap map = map_of({circle({0.0, 0.0}, 0.02)});
    const Scene scene = scene_of(map);
    Explorer explorer(map, scene, ExplorerOptions{});
    for (int tick = 0; tick < 5000 && !explorer.is_done(); ++tick) {
        Felt felt = nothing_felt(explorer);
        if (felt.map_force == MapForce::on) felt.map_force = MapForce::changing;
        explorer.step(felt, dt_s);
    }
    EXPECT_TRUE(explorer.is_done());
    EXPECT_EQ(explorer.visited(), 0);
}

TEST(Explorer, NeverMovesFasterThanItTravels) {
    const TactileMap map = map_of({circle({-0.03, 0.0}, 0.01), circle({0.03, 0.0}, 0.01)});
    const Scene scene = scene_of(map);
    const ExplorerOptions options;
    Explorer explorer(map, scene, options);
    Position last = explorer.start();
    while (!explorer.is_done()) {
        explorer.step(nothing_felt(explorer), dt_s);
        const Position now = explorer.intention().position;
        EXPECT_LE(norm(now - last), options.travel_m_per_s * dt_s + 1e-12);
        last = now;
    }
}

}  // namespace
}  // namespace touchline
