// The structures that Touchline is measured against answer as brute force does: a wrong answer,
// however quick, is no yardstick.
#include "tests/exact/orientation.h"
#include "tests/lab/bench/collision/brute_force.h"
#include "tests/lab/bench/collision/crossing.h"
#include "tests/lab/bench/collision/grid.h"
#include "tests/lab/bench/collision/level_judge.h"
#include "tests/lab/bench/collision/motions.h"
#include "tests/lab/bench/workload.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

TEST(BruteForce, FindsTheFirstOfTwoCrossingsAndTheNearestPoint) {
    const std::vector<Position> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const BruteForce brute(square);
    const auto found = brute.first_crossing({-1, 0.5}, {3, 0.5});
    ASSERT_TRUE(found.has_value());
    EXPECT_DOUBLE_EQ(found->share, 0.25);
    EXPECT_EQ(found->edge, 3U);
    EXPECT_FALSE(brute.first_crossing({-1, 2}, {3, 2}).has_value());
    EXPECT_DOUBLE_EQ(brute.nearest({0.5, 1.25}).distance_m, 0.25);
    EXPECT_EQ(brute.nearest({3, 3}).point, (Position{1, 1}));
}

class GridOnCurves : public testing::TestWithParam<double> {};

TEST_P(GridOnCurves, FirstCrossingsAreThoseOfBruteForce) {
    for (const auto kind : {workload::Kind::radial, workload::Kind::fractal}) {
        const auto curve = workload::curve(kind, 4096);
        const BruteForce brute(curve);
        const Grid grid(curve, GetParam());
        int crossings = 0;
        for (const auto& [from, to] : test_motions(curve, 3000)) {
            const auto expected = brute.first_crossing(from, to);
            const auto found = grid.first_crossing(from, to);
            ASSERT_EQ(found.has_value(), expected.has_value());
            crossings += found ? 1 : 0;
            if (found) {
                ASSERT_EQ(found->share, expected->share);
            }
        }
        EXPECT_GT(crossings, 300);
    }
}

INSTANTIATE_TEST_SUITE_P(EdgesPerCell, GridOnCurves, testing::Values(0.25, 1.0, 4.0, 16.0, 200.0),
                         [](const auto& test) {
                             return "Times100Is" +
                                    std::to_string(static_cast<int>(100.0 * test.param));
                         });

TEST(Grid, FindsCrossingsOnBordersOfCellsAndOfMotionsAlongThem) {
    // Cells of 1 m, so that all edges lie on borders; the motions join their corners and middles,
    // also from outside the grid.
    const std::vector<Position> plus{{2, 0}, {4, 0}, {4, 2}, {6, 2}, {6, 4}, {4, 4},
                                     {4, 6}, {2, 6}, {2, 4}, {0, 4}, {0, 2}, {2, 2}};
    const Grid grid(plus, 0.5);
    ASSERT_DOUBLE_EQ(grid.cell_m(), 1.0);
    const BruteForce brute(plus);
    std::vector<Position> places;
    for (int i = -4; i <= 16; ++i) {
        for (int j = -4; j <= 16; ++j) places.push_back({0.5 * i, 0.5 * j});
    }
    for (const Position from : places) {
        for (const Position to : places) {
            const auto expected = brute.first_crossing(from, to);
            const auto found = grid.first_crossing(from, to);
            ASSERT_EQ(found.has_value(), expected.has_value())
                << from.x << " " << from.y << ", " << to.x << " " << to.y;
            if (found) {
                ASSERT_EQ(found->share, expected->share);
            }
        }
    }
}

TEST(Grid, FindsCrossingsOfMotionsFromFarAwayAndNoneOfThoseThatAreNotFinite) {
    const auto curve = workload::curve(workload::Kind::fractal, 512);
    const Grid grid(curve, 1.0);
    const BruteForce brute(curve);
    for (int i = 0; i < 32; ++i) {
        const Position far{10.0 * std::cos(0.2 * i), 10.0 * std::sin(0.2 * i)};
        const auto found = grid.first_crossing(far, {0.0, 0.0});
        ASSERT_TRUE(found.has_value());
        EXPECT_EQ(found->share, brute.first_crossing(far, {0.0, 0.0})->share);
        EXPECT_FALSE(grid.first_crossing(far, 2.0 * far));
    }
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {std::nan(""), infinity, -infinity, 1e300}) {
        for (const Position p : {Position{bad, 0.0}, Position{0.0, bad}, Position{bad, bad}}) {
            EXPECT_FALSE(grid.first_crossing(p, {0.0, 0.0}));
            EXPECT_FALSE(grid.first_crossing({0.0, 0.0}, p));
        }
    }
}

TEST(Inside, AgreesWithTheParityOfCrossings) {
    const auto curve = workload::curve(workload::Kind::fractal, 512);
    const Inside is_inside(curve);
    EXPECT_TRUE(is_inside({0.0, 0.0}));
    EXPECT_FALSE(is_inside({0.1, 0.0}));
    for (const auto& [from, to] : test_motions(curve, 1000)) {
        int crossings = 0;
        for (std::size_t i = 0; i < curve.size(); ++i) {
            crossings += crossing_share(from, to - from, edge_of(curve, i)) ? 1 : 0;
        }
        EXPECT_EQ(is_inside(from) != is_inside(to), crossings % 2 != 0);
    }
}

TEST(PlaneProxy, StopsOutsideAndSlidesToTheHandsFoot) {
    const std::vector<Position> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const BruteForce brute(square);
    PlaneProxy proxy(brute, square);
    proxy.start({0.5, 1.1});
    const Position held = proxy.step({0.5, 0.9});
    EXPECT_NEAR(held.x, 0.5, 1e-7);
    EXPECT_NEAR(held.y, 1.0 + 1e-8, 1e-12);
    const Position slid = proxy.step({0.7, 0.8});
    EXPECT_NEAR(slid.x, 0.7, 1e-7);
    EXPECT_GT(slid.y, 1.0);
}

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
