// Short motions start at a grid, long ones at the top of the hierarchy: both give the same answer,
// and what is spared afterwards is true.
#include "haptics/collision/scene.h"
#include "haptics/collision/touch.h"
#include "tests/haptics/collision/hierarchy_hit.h"
#include "tests/haptics/collision/level_segments.h"
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/scenes.h"
#include "tests/lab/bench/workload.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Returns a motion of 1 um to 100 mm that begins near a curve; the shorter half of them fit the
/// grid.
Motion motion_near(trials::Random& random, const LevelSegments& segments, double level,
                   double radius_m) {
    const Segment& s = segments.all()[random.below(segments.all().size())].segment;
    const double off_m = random.decade(-6.0, -1.5);
    const Position from = s.a + off_m * random.direction();
    const double length_m = random.decade(-6.0, -1.0);
    const bool is_aimed = random.below(2) == 0;
    const Position way = is_aimed ? (length_m / std::max(norm(s.b - from), 1e-9)) * (s.b - from)
                                  : length_m * random.direction();
    return {from, from + way, radius_m, level, {}};
}

struct Tally {
    std::size_t asked = 0;
    std::size_t hits = 0;
    std::size_t started_elsewhere = 0;  // not as many boxes as the hierarchy: used the grid
    std::size_t spared = 0;
    std::size_t wrong = 0;
};

void ask(const Scene& scene, const LevelSegments& segments, const Motion& motion, Tally& tally) {
    const Hit found = scene.tree.first_hit(scene.curves, motion, {});
    HierarchyHit expected(motion);
    (void)expected.walk(scene);
    ++tally.asked;
    tally.hits += found.is_hit ? 1U : 0U;
    tally.started_elsewhere += found.boxes != expected.boxes() ? 1U : 0U;
    const double way_m = norm(motion.to - motion.from);
    const double apart_m = std::abs(found.clear - expected.share()) * way_m;
    bool is_right = found.is_hit == expected.is_hit() && apart_m <= approach_tolerance_m;
    if (!found.is_hit && found.spare_m > 0.0) {
        ++tally.spared;
        const double least_m = motion.radius_m + found.spare_m;
        is_right = is_right && segments.distance_m(motion.to) >= least_m;
    }
    if (is_right || ++tally.wrong > 5) return;
    ADD_FAILURE() << fmt::format(
        "from ({:a}, {:a}) to ({:a}, {:a}) radius {} at level {}: found {} at {:.17g}, spare "
        "{:.17g} "
        "m, distance of the end {:.17g} m; by the hierarchy {} at {:.17g}",
        motion.from.x, motion.from.y, motion.to.x, motion.to.y, motion.radius_m, motion.level,
        found.is_hit, found.clear, found.spare_m,
        static_cast<double>(segments.distance_m(motion.to)), expected.is_hit(), expected.share());
}

void ask_scene(const Scene& scene, std::size_t each_level, trials::Random& random, Tally& tally) {
    for (const double level : trials::levels_of(scene.curves)) {
        const LevelSegments segments(scene.curves, level);
        for (std::size_t i = 0; i < each_level; ++i) {
            const double radius_m =
                i % 3 == 0 ? 0.0 : (i % 3 == 1 ? contact_skin_m : random.decade(-5.0, -2.5));
            ask(scene, segments, motion_near(random, segments, level, radius_m), tally);
        }
    }
}

void report(const Tally& tally) {
    fmt::print(
        "  {} motions, {} hits, {} started at the grid, {} with something spared, {} wrong\n",
        tally.asked, tally.hits, tally.started_elsewhere, tally.spared, tally.wrong);
    EXPECT_EQ(tally.wrong, 0U);
    EXPECT_GT(tally.hits, tally.asked / 10);
    EXPECT_GT(tally.started_elsewhere, tally.asked / 20);
    EXPECT_GT(tally.spared, tally.asked / 20);
}

TEST(StartOfAWalk, GridAndHierarchyAgreeAndNothingIsWithinWhatIsSpared) {
    Tally tally;
    for (std::uint64_t seed = 0; seed < trials::count(200, 10000); ++seed) {
        trials::Random random(seed);
        const TactileMap map = seed % 2 == 0 ? scenes::random_map(static_cast<unsigned>(seed), 4)
                                             : trials::small_map(random);
        const Scene scene = trials::scene_of(map, seed);
        if (!scene.curves.pieces().empty()) ask_scene(scene, 30, random, tally);
    }
    report(tally);
}

TEST(StartOfAWalk, TheSameOnLongCurvesAtEveryLevel) {
    Tally tally;
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        trials::Random random(5);
        const TactileMap map = workload::map_of(workload::curve(kind, 4096));
        ask_scene(trials::every_level(map), trials::count(100, 5000), random, tally);
    }
    report(tally);
}

/// A motion as long as was spared is free in any direction, by the tree's own answer too.
TEST(StartOfAWalk, AfterAFreeMotionOneAsLongAsIsSparedIsFreeToo) {
    trials::Random random(6);
    const Scene scene = trials::every_level(scenes::random_map(6, 6));
    std::size_t spared = 0;
    for (const double level : trials::levels_of(scene.curves)) {
        const LevelSegments segments(scene.curves, level);
        for (int i = 0; i < 300; ++i) {
            const Motion motion = motion_near(random, segments, level, 1e-4);
            const Hit found = scene.tree.first_hit(scene.curves, motion, {});
            if (found.is_hit || !std::isfinite(found.spare_m)) continue;
            const Position next = motion.to + found.spare_m * random.direction();
            spared += found.spare_m > 0.0 ? 1U : 0U;
            const Motion on{motion.to, next, motion.radius_m, level, {}};
            EXPECT_TRUE(found.spare_m == 0.0 || !scene.tree.first_hit(scene.curves, on, {}).is_hit);
        }
    }
    EXPECT_GT(spared, 500U);
}

/// A motion that starts where a disc touches a segment, and goes anywhere or to a place nearby on
/// the curve.
Motion lift_off(trials::Random& random, const LevelSegments& segments, std::size_t start,
                double level, double radius_m) {
    const auto& all = segments.all();
    const Segment& s = all[start].segment;
    const double side = random.below(2) == 0 ? 1.0 : -1.0;
    const Direction normal = side * left_of(direction_of(s.b - s.a));
    const Position from = s.a + random.unit() * (s.b - s.a) + along<Position>(normal, radius_m);
    const std::size_t near = (start + 1 + random.below(40)) % all.size();
    const Position way = random.below(2) == 0 ? random.decade(-6.0, -1.5) * random.direction()
                                              : 2.0 * (all[near].segment.b - from);
    return {from, from + way, radius_m, level, {}};
}

/// A search along the outline first finds what the search from the grid or the top finds.
TEST(StartOfAWalk, AMotionThatLiftsOffMeetsTheSameAlongItsOutline) {
    std::size_t hits = 0;
    std::size_t fewer_boxes = 0;
    const auto compare = [&](const Scene& scene, double radius_m, int each_level,
                             trials::Random& random) {
        for (const double level : trials::levels_of(scene.curves)) {
            const LevelSegments segments(scene.curves, level);
            for (int i = 0; i < each_level; ++i) {
                const std::size_t start = random.below(segments.all().size());
                const Segment& s = segments.all()[start].segment;
                if (is_point(s)) continue;
                const Motion motion = lift_off(random, segments, start, level, radius_m);
                const Hit found =
                    scene.tree.first_hit_from(scene.curves, motion, segments.all()[start].ref, {});
                const Hit expected = scene.tree.first_hit(scene.curves, motion, {});
                hits += found.is_hit ? 1U : 0U;
                fewer_boxes += found.boxes < expected.boxes ? 1U : 0U;
                ASSERT_EQ(found.is_hit, expected.is_hit) << level << " " << i;
                ASSERT_NEAR(found.clear, expected.clear, 1e-12) << level << " " << i;
                ASSERT_LE(found.spare_m, expected.spare_m) << level << " " << i;
            }
        }
    };
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        for (const double radius_m : {contact_skin_m, 2e-4}) {
            trials::Random random(7);
            const TactileMap map = workload::map_of(workload::curve(kind, 4096));
            compare(trials::every_level(map, radius_m), radius_m, 500, random);
        }
    }
    for (std::uint64_t seed = 0; seed < trials::count(60, 3000); ++seed) {
        trials::Random random(seed);
        const Scene scene = trials::every_level(scenes::random_map(static_cast<unsigned>(seed), 4));
        compare(scene, contact_skin_m, 20, random);
    }
    EXPECT_GT(hits, 5000U);
    EXPECT_GT(fewer_boxes, 1000U);
}

}  // namespace
}  // namespace touchline
