// The paper's query: the answer at the finest level that the budget reaches.
#include "haptics/collision/scene.h"
#include "haptics/collision/touch.h"
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/scenes.h"

#include <algorithm>
#include <optional>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Returns the share of the motion at which it first touches any rendered segment.
std::optional<double> first_touch(const CurveSet& curves, const Motion& motion, double level) {
    std::optional<double> first;
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        const RenderedPiece rendered = curves.rendered(piece, level);
        for (int j = 0; j < rendered.segment_count(); ++j) {
            const auto found = touch(motion.from, motion.to, motion.radius_m, rendered.segment(j));
            if (found && (!first || found->fraction < *first)) first = found->fraction;
        }
    }
    return first;
}

Motion random_motion(std::mt19937& engine, double level) {
    std::uniform_real_distribution<double> place(-0.05, 0.05);
    const Position from{place(engine), place(engine)};
    const Position to{place(engine), place(engine)};
    return {from, to, contact_skin_m, level, {}};
}

TEST(LevelReached, AnswersExactlyForTheLevelItNamesWhichNeverCoarsensWithTheBudget) {
    constexpr std::array levels{0.0, 0.5, 1.0, 1.9, 3.0};
    int cut_short = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        const Scene scene = trials::every_level(scenes::random_map(seed, 6));
        std::mt19937 engine(seed);
        for (const double level : levels) {
            const Motion motion = random_motion(engine, level);
            double reached = scene.curves.coarsest();
            bool was_known = false;
            for (int boxes = 0; boxes < 400; boxes += 1 + boxes / 8) {
                const HitAtLevel found =
                    scene.tree.first_hit_at_level_reached(scene.curves, motion, {.boxes = boxes});
                ASSERT_LE(found.hit.boxes, boxes);
                ASSERT_LE(found.level, std::max(reached, level));
                ASSERT_TRUE(found.is_known || !was_known);
                reached = found.level;
                was_known = found.is_known;
                if (!found.is_known) {
                    ASSERT_EQ(found.hit.clear, 0.0);
                    continue;
                }
                cut_short += found.level > level ? 1 : 0;
                const auto expected = first_touch(scene.curves, motion, found.level);
                ASSERT_EQ(found.hit.is_hit, expected.has_value()) << seed << " " << boxes;
                const double way_m = norm(motion.to - motion.from);
                if (expected) {
                    ASSERT_LE(std::abs(found.hit.clear - *expected) * way_m, approach_tolerance_m);
                }
            }
            ASSERT_TRUE(was_known);
            ASSERT_EQ(reached, std::max(level, 0.0));
        }
    }
    EXPECT_GT(cut_short, 50);
}

TEST(LevelReached, WithoutABudgetItIsTheFirstHit) {
    const Scene scene = trials::every_level(scenes::random_map(7, 8));
    std::mt19937 engine(7);
    for (int i = 0; i < 500; ++i) {
        const Motion motion = random_motion(engine, i % 2 == 0 ? 0.0 : 1.5);
        const HitAtLevel found = scene.tree.first_hit_at_level_reached(scene.curves, motion, {});
        const Hit hit = scene.tree.first_hit(scene.curves, motion, {});
        ASSERT_EQ(found.level, motion.level);
        ASSERT_EQ(found.hit.is_hit, hit.is_hit);
        ASSERT_EQ(found.hit.clear, hit.clear);
        ASSERT_EQ(found.hit.segment, hit.segment);
    }
}

TEST(LevelReached, AnEmptyPictureIsKnownToBeClear) {
    const Scene scene = trials::every_level(scenes::map_of({}));
    const HitAtLevel found = scene.tree.first_hit_at_level_reached(
        scene.curves, {{0.0, 0.0}, {0.01, 0.0}, contact_skin_m, 0.0, {}}, {});
    EXPECT_TRUE(found.is_known);
    EXPECT_FALSE(found.hit.is_hit);
    EXPECT_EQ(found.hit.clear, 1.0);
}

}  // namespace
}  // namespace touchline
