// Judges runs whose outcome is known.
#include "tests/lab/bench/collision/run.h"

#include "tests/lab/bench/collision/brute_force.h"
#include "tests/lab/bench/collision/tiled_spiral.h"
#include "tests/lab/bench/collision/touchline_rows.h"
#include "tests/lab/bench/workload.h"

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

/// A proxy that follows the hand, but stays where it was last put while the hand is at x > 0.
struct Sticky {
    void start(Position hand) { reset(hand); }

    void reset(Position hand) { proxy = hand; }

    Position step(Position hand) {
        if (hand.x <= 0.0) proxy = hand;
        return proxy;
    }

    Position proxy;
};

TEST(Runs, TakesUpAHandThatSlippedOffOnceItIsOutside) {
    const std::vector<Position> way{{0, 0}, {0.008, 0}, {0.011, 0}, {0.012, 0}, {0.013, 0}};
    const Hand hand{way, {false, true, true, true, false}};
    Sticky sticky;
    const HandRun done = run(sticky, hand, {});
    ASSERT_EQ(done.proxies.size(), way.size());
    EXPECT_EQ(done.is_reset, (std::vector<bool>{false, false, false, false, true}));
    EXPECT_EQ(done.proxies[3], (Position{0, 0}));
    EXPECT_EQ(done.proxies[4], way[4]);
    EXPECT_FALSE(done.is_stopped);
}

TEST(Runs, BehaviourCountsWhatTheHandFelt) {
    const std::vector<Position> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const std::vector<Position> way{{2, 0}, {0.9, 0}, {0.8, 0}, {2, 0}};
    HandRun done;
    done.proxies = {{2, 0}, {0.9, 0}, {0.808, 0}, {2, 0}};
    done.is_reset = {false, false, false, true};
    const Behaviour found = behaviour(done, {way, {}}, Inside(square));
    EXPECT_EQ(found.entered, 1U);
    EXPECT_EQ(found.slip_offs, 1U);
    EXPECT_DOUBLE_EQ(found.contact_share, 0.25);
    EXPECT_NEAR(found.largest_gap_m, 0.008, 1e-12);
    EXPECT_NEAR(found.mean_gap_m, 0.008, 1e-12);
    EXPECT_NEAR(found.largest_jump_N, 4.0, 1e-9);
}

TEST(Runs, TimesAreRanksOfTheSteps) {
    std::vector<std::uint64_t> ticks_of_steps;
    for (std::uint64_t i = 0; i < 1000; ++i) ticks_of_steps.push_back(1000 - i);
    const StepTimes times = step_times(ticks_of_steps);
    EXPECT_DOUBLE_EQ(times.median_ns, 501.0 * ns_per_tick());
    EXPECT_DOUBLE_EQ(times.p99_ns, 991.0 * ns_per_tick());
    EXPECT_DOUBLE_EQ(times.max_ns, 1000.0 * ns_per_tick());
}

TEST(Runs, DeviationIsOverTheStepsOfBothRuns) {
    HandRun a;
    HandRun b;
    a.proxies = {{0, 0}, {3, 4}, {100, 0}};
    b.proxies = {{0, 0}, {0, 0}};
    const Deviation found = deviation(a, b);
    EXPECT_DOUBLE_EQ(found.max_m, 5.0);
    EXPECT_DOUBLE_EQ(found.rms_m, 5.0 / std::sqrt(2.0));
}

TEST(Runs, JudgedStepsOfTouchlineLetNothingThroughOnASmallCurve) {
    const auto curve = workload::curve(workload::Kind::radial, 512);
    const auto way = workload::hand(workload::Kind::radial, 3000);
    const Inside is_inside(curve);
    Hand hand{way, {}};
    for (const Position p : way) hand.is_inside.push_back(is_inside(p));
    const Scene scene = build_scene(workload::map_of(curve), {}, 0.0).value();
    AutoLevel renderer(scene);
    RunLimits once;
    once.passes = 1;
    const HandRun done = run(renderer, hand, once);
    const Verdict verdict = judged(renderer, scene.curves, hand, done);
    EXPECT_EQ(verdict.let_through, 0U);
    EXPECT_EQ(verdict.levels.size(), way.size());
    EXPECT_GT(behaviour(done, hand, is_inside).contact_share, 0.3);
}

class TiledSpiral : public testing::TestWithParam<std::size_t> {};

TEST_P(TiledSpiral, HasItsOutlinesAndEdgesAndTheHandSlidesFromOneToTheNext) {
    const std::size_t outlines = GetParam();
    constexpr std::size_t edges = 20000;
    const TactileMap map = tiled_spiral(edges, outlines);
    ASSERT_EQ(map.outlines.size(), outlines);
    std::size_t found = 0;
    for (const Outline& outline : map.outlines) found += outline.points.size() - 1;
    EXPECT_GE(found, edges / outlines * outlines);
    EXPECT_LE(found, edges + 3 * outlines);

    // The tiles alone let nothing through, so the proxy is never left behind.
    const auto way = hand_on_spiral(4000);
    const Scene scene = build_scene(map, {}, 0.0).value();
    FixedLevel renderer(scene, {});
    renderer.start(way[0]);
    double largest_gap_m = 0.0;
    int contacts = 0;
    for (const Position hand : way) {
        const double gap_m = norm(renderer.step(hand) - hand);
        largest_gap_m = std::max(largest_gap_m, gap_m);
        contacts += gap_m > 1e-6 ? 1 : 0;
    }
    EXPECT_LT(largest_gap_m, 0.0015);
    EXPECT_GT(contacts, 2000);
}

INSTANTIATE_TEST_SUITE_P(Outlines, TiledSpiral, testing::Values(1, 10, 100, 1000));

}  // namespace

}  // namespace touchline::bench
