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

}  // namespace
}  // namespace touchline
