#include "tests/lab/bench/collision/tiled_spiral.h"

#include "tests/lab/bench/collision/touchline_rows.h"

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

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
