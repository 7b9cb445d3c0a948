// No line passes through an edge of the shape, however the hand moves and turns it. A brute-force
// sweep of every step judges this. TOUCHLINE_EXHAUSTIVE=1: a million motions (tests/README.md).

#include "tests/haptics/probe/hands.h"
#include "tests/haptics/probe/swept_judge.h"
#include "tests/haptics/scenes.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

struct Count {
    std::size_t steps = 0;
    std::size_t let_through = 0;
    std::size_t in_contact = 0;
    std::size_t placed = 0;
};

Count run(const Scene& scene, const ProbeShape& shape, double level, std::uint64_t seed,
          std::size_t steps, const Budget& budget) {
    const SweptJudge judge(scene.curves, level, shape.edges());
    RestlessHand hand(seed);
    ProbeProxy proxy;
    std::vector<ProbePose> path;
    proxy.reset(shape, scene, hand.step(), level);
    proxy.record_path(&path);
    Count out;
    for (; out.steps < steps; ++out.steps) {
        const ProbeReport report = proxy.step(hand.step(), level, {}, budget);
        if (!report.is_placed) continue;
        ++out.placed;
        out.in_contact += report.contact_count > 0 ? 1 : 0;
        if (!judge.is_free(path) || !judge.is_clear(proxy.pose())) ++out.let_through;
    }
    return out;
}

TEST(Probe, LetsNothingThroughAtAnySpeed) {
    const std::size_t steps = trials::count(500, 25000);
    Count all;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const TactileMap map = seed % 4 == 3 ? scenes::rough_ring(static_cast<unsigned>(seed), 5e-4)
                                             : scenes::random_map(static_cast<unsigned>(seed), 5);
        const Scene scene = trials::scene_of(map, seed);
        const double coarsest = scene.curves.coarsest();
        const double level = std::min(coarsest, 0.5 * static_cast<double>(seed % 5));
        const ProbeShape shape = any_shape(seed % 6);
        const Count one = run(scene, shape, level, seed, steps, {});
        EXPECT_EQ(one.let_through, 0U) << "seed " << seed << " level " << level;
        all.steps += one.steps;
        all.placed += one.placed;
        all.in_contact += one.in_contact;
    }
    RecordProperty("steps", std::to_string(all.steps));
    EXPECT_GT(all.placed, all.steps * 9 / 10);
    EXPECT_GT(all.in_contact, all.steps / 8);
}

TEST(Probe, LetsNothingThroughWhenTheBudgetEnds) {
    const std::size_t steps = trials::count(500, 10000);
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const Scene scene =
            trials::scene_of(scenes::random_map(static_cast<unsigned>(seed), 5), seed);
        Budget budget;
        budget.boxes = 3 + 10 * static_cast<int>(seed);
        const ProbeShape shape = any_shape(seed);
        EXPECT_EQ(run(scene, shape, 0.0, seed, steps, budget).let_through, 0U) << "seed " << seed;
    }
}

}  // namespace
}  // namespace touchline
