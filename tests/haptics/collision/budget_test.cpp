// A query with a budget: unopened boxes are obstacles, and the answer is still true.
#include "haptics/collision/scene.h"
#include "haptics/collision/touch.h"
#include "tests/haptics/collision/hierarchy_hit.h"
#include "tests/haptics/collision/level_segments.h"
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr unsigned scenes_asked = 80;
constexpr int motions_each_level = 4;

/// Calls check(scene, segments, motion) for ways of all kinds: a third each as a point, with the
/// skin alone, and with a radius.
template <class Check>
void for_each_motion(const Check& check) {
    for (unsigned seed = 0; seed < scenes_asked; ++seed) {
        trials::Random random(seed);
        const TactileMap map =
            seed % 2 == 0 ? scenes::random_map(seed, 6) : trials::small_map(random);
        const Scene scene = trials::scene_of(map, seed);
        if (scene.curves.pieces().empty()) continue;
        for (const double level : trials::levels_of(scene.curves)) {
            const LevelSegments segments(scene.curves, level);
            for (int i = 0; i < motions_each_level; ++i) {
                const auto [from, to] = trials::way(random, segments);
                const double radii_m[] = {0.0, contact_skin_m, 5e-4};
                check(scene, segments, Motion{from, to, radii_m[random.below(3)], level, {}});
            }
        }
    }
}

TEST(Budget, ClearNeverFallsAndNoAnswerIsWrong) {
    std::size_t cut_short = 0;
    for_each_motion([&](const Scene& scene, const LevelSegments& segments, const Motion& motion) {
        const Hit whole = scene.tree.first_hit(scene.curves, motion, {});
        const bool is_met =
            motion.radius_m == 0.0 && segments.first_meeting(motion.from, motion.to).has_value();
        double clear = 0.0;
        for (int boxes = 0; boxes <= whole.boxes; ++boxes) {
            const Hit cut = scene.tree.first_hit(scene.curves, motion, {.boxes = boxes});
            ASSERT_LE(cut.boxes, boxes);
            ASSERT_GE(cut.clear, clear);
            ASSERT_LE(cut.clear, whole.clear);
            clear = cut.clear;
            cut_short += boxes < whole.boxes ? 1U : 0U;
            if (cut.is_hit) {
                ASSERT_TRUE(whole.is_hit);
                ASSERT_EQ(cut.segment, whole.segment);
                ASSERT_EQ(cut.clear, whole.clear);
            } else if (cut.clear == 1.0) {
                ASSERT_FALSE(whole.is_hit || is_met);
            }
        }
        ASSERT_EQ(clear, whole.clear);
    });
    EXPECT_GT(cut_short, 10000U);
}

TEST(Budget, OfNBoxesLooksAtNoMoreThanNPlusOneSegments) {
    std::size_t looked = 0;
    for_each_motion([&](const Scene& scene, const LevelSegments&, const Motion& motion) {
        HierarchyHit whole(motion);
        (void)whole.walk(scene);
        looked += static_cast<std::size_t>(whole.leaves());
        ASSERT_LE(whole.leaves(), whole.boxes() + 1);
        for (int boxes = 0; boxes < whole.boxes(); ++boxes) {
            HierarchyHit cut(motion, boxes);
            (void)cut.walk(scene);
            ASSERT_LE(cut.boxes(), boxes);
            ASSERT_LE(cut.leaves(), boxes + 1);
        }
    });
    EXPECT_GT(looked, 1000U);
}

}  // namespace
}  // namespace touchline
