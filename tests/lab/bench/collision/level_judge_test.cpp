#include "tests/lab/bench/collision/level_judge.h"

#include "tests/exact/orientation.h"
#include "tests/lab/bench/workload.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

class LevelJudgeOnACoast : public testing::TestWithParam<double> {};

TEST_P(LevelJudgeOnACoast, FindsTheWaysThatMeetAnySegmentAsRendered) {
    const double level = GetParam();
    const CurveSet curves =
        CurveSet::build(workload::map_of(workload::curve(workload::Kind::fractal, 2048)), {})
            .value();
    LevelJudge judge(curves);
    std::mt19937_64 random(7);  // NOLINT(cert-msc51-cpp): the same ways every day
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto all_free = [&](Position a, Position b) {
        for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
            for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
                const Segment s = curves.rendered_segment(piece, level, j);
                if (exact::meet(a, b, s.a, s.b)) return false;
            }
        }
        return true;
    };
    int met = 0;
    constexpr int ways = 1000;
    for (int i = 0; i < ways; ++i) {
        const Position near = curves.rendered_point(0, level, i % curves.rendered_count(0, level));
        const Position from = near + Position{5e-4 * unit(random), 5e-4 * unit(random)};
        const Position to = from + Position{5e-4 * unit(random), 5e-4 * unit(random)};
        const std::array way{from, to};
        const bool is_free = judge.is_free(way, level);
        ASSERT_EQ(is_free, all_free(from, to));
        met += is_free ? 0 : 1;
    }
    EXPECT_GT(met, ways / 20);
    EXPECT_LT(met, ways * 19 / 20);
}

INSTANTIATE_TEST_SUITE_P(Levels, LevelJudgeOnACoast, testing::Values(0.0, 0.5, 1.0, 2.75, 4.0),
                         [](const auto& test) {
                             return "Quarters" + std::to_string(static_cast<int>(4.0 * test.param));
                         });

TEST(LevelJudge, AWayThroughIsNotFreeAndOneBesideIs) {
    TactileMap map;
    map.outlines.push_back({{{0.0, 0.0}, {0.01, 0.0}}, false, "", "", 1.0, 1});
    const CurveSet curves = CurveSet::build(map, {}).value();
    LevelJudge judge(curves);
    const std::array through{Position{0.005, 0.001}, Position{0.006, 0.001},
                             Position{0.006, -0.001}};
    const std::array touching{Position{0.005, 0.001}, Position{0.005, 0.0}};
    const std::array beside{Position{0.005, 1e-11}, Position{0.009, 1e-11}};
    EXPECT_FALSE(judge.is_free(through, 0.0));
    EXPECT_FALSE(judge.is_free(touching, 0.0));
    EXPECT_TRUE(judge.is_free(beside, 0.0));
}

}  // namespace
}  // namespace touchline::bench
