#include "haptics/collision/scene.h"
#include "tests/haptics/scenes.h"

#include <numeric>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Scene scene_of(const TactileMap& map) {
    return build_scene(map, {}, 0.0).value();
}

TEST(Legs, RunFromCornerToCorner) {
    const Scene scene = scene_of(scenes::map_of({scenes::square(0.04, 20)}));
    ASSERT_EQ(scene.legs.size(), 4U);
    for (const Leg& leg : scene.legs) {
        EXPECT_NEAR(leg.run_m, 0.04, 1e-9);
        EXPECT_TRUE(leg.rests_at_end);
    }
    EXPECT_TRUE(scene.legs[0].starts_outline);
    EXPECT_FALSE(scene.legs[1].starts_outline);
}

TEST(Legs, ASmoothRingIsOneLegAndALabelCutsIt) {
    TactileMap map = scenes::map_of({scenes::circle(0.03, 200)});
    ASSERT_EQ(scene_of(map).legs.size(), 1U);
    map.labels.push_back({"left", {-0.033, 0.0}});
    map.labels.push_back({"far away", {0.0, 0.0}});  // no outline near
    const Scene scene = scene_of(map);
    ASSERT_EQ(scene.legs.size(), 2U);
    EXPECT_EQ(scene.legs[0].label, 0);
    EXPECT_EQ(scene.legs[1].label, -1);
    EXPECT_NEAR(scene.legs[0].run_m, 3.14159 * 0.03, 1e-3);
    const auto points = scene.curves.points(0, 0);
    EXPECT_NEAR(norm(points[static_cast<std::size_t>(scene.legs[0].last)] - Position{-0.03, 0.0}),
                0.0, 1e-3);
    EXPECT_EQ(scene.legs[1].last, static_cast<int>(points.size()));
}

TEST(Legs, CoverEveryOutlineOnceInTheMapsOrder) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        TactileMap map = scenes::random_map(seed, 12);
        for (int i = 0; i < 6; ++i) map.labels.push_back({"here", {0.01 * i - 0.03, 0.002 * i}});
        const Scene scene = scene_of(map);
        int outline = -1;
        std::vector<int> edges(scene.curves.pieces().size());
        for (std::size_t i = 0; i < scene.legs.size(); ++i) {
            const Leg& leg = scene.legs[i];
            ASSERT_GE(leg.outline, outline);
            ASSERT_EQ(leg.starts_outline, leg.outline != outline);
            outline = leg.outline;
            ASSERT_LT(leg.first, leg.last);
            ASSERT_EQ(leg.first, edges[static_cast<std::size_t>(leg.piece)]);
            edges[static_cast<std::size_t>(leg.piece)] = leg.last;
            ASSERT_GT(leg.run_m, 0.0);
        }
        for (std::size_t piece = 0; piece < edges.size(); ++piece)
            ASSERT_EQ(edges[piece], scene.curves.segment_count(static_cast<int>(piece), 0));
    }
}

}  // namespace
}  // namespace touchline
