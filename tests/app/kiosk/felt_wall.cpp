#include "tests/app/kiosk/felt_wall.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double felt_frame_s = 1.0 / 60.0;
constexpr double hand_m_per_s = 0.04;

Position meant(KioskWorld& world) {
    return world.servo().hand().at(0.0).position;
}

/// Averages while the hand slides.
struct Push {
    double force_N = 0.0;
    double depth_m = 0.0;
};

Push push(KioskWorld& world, Position meant_W, Position along) {
    constexpr double settle_s = 0.5;
    constexpr int samples = 60;
    lead_hand(world, meant_W);
    world.run(settle_s);
    Push felt;
    for (int i = 1; i <= samples; ++i) {
        world.servo().hand().move_to(meant_W + (static_cast<double>(i) / samples) * along);
        world.run(felt_frame_s);
        felt.force_N += norm(world.servo().force_on_handle_W()) / samples;
        felt.depth_m += norm(world.kiosk().hand().p_WP - world.servo().handle_W()) / samples;
    }
    return felt;
}

}  // namespace

void open_walls(KioskWorld& world, const std::string& picture) {
    std::ofstream(world.site_files().settings.site) << "[feel]\nmode = \"wall\"\n";
    world.run(2.0);
    BlindVisitor visitor(world, 0.2);
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("What to feel")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Gallery")) << visitor.heard();
    while (!visitor.find(picture)) {
        ASSERT_TRUE(visitor.choose("The next ten")) << visitor.heard();
    }
    ASSERT_TRUE(visitor.choose(picture)) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Guide me round the")) << visitor.heard();
    world.run(1.0);
}

void lead_hand(KioskWorld& world, Position place_W) {
    const Position from = meant(world);
    const double way_m = norm(place_W - from);
    const int frames = static_cast<int>(std::ceil(way_m / (hand_m_per_s * felt_frame_s)));
    for (int i = 1; i <= frames; ++i) {
        world.servo().hand().move_to(from + (static_cast<double>(i) / frames) * (place_W - from));
        world.run(felt_frame_s);
    }
}

FeltWall feel_wall(KioskWorld& world, Position deep, Position along) {
    constexpr double light_share = 0.56;  // share of the way to `deep`: just behind the wall
    const Position before = meant(world);
    const Push light = push(world, before + light_share * (deep - before), along);
    const Push hard = push(world, deep, along);
    lead_hand(world, before);
    return {(hard.force_N - light.force_N) / (hard.depth_m - light.depth_m), hard.force_N};
}

}  // namespace touchline
