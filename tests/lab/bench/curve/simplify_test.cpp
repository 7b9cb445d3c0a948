#include "tests/lab/bench/curve/simplify.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

std::vector<Position> wave(std::size_t count) {
    std::vector<Position> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double u = static_cast<double>(i);
        points.push_back({1e-3 * u, 2e-3 * std::sin(0.3 * u) + 5e-4 * std::sin(1.7 * u)});
    }
    return points;
}

TEST(Simplifiers, GiveTheCountAskedAndKeepTheEnds) {
    const auto points = wave(100);
    for (const auto& simplify : {douglas_peucker, visvalingam}) {
        for (const std::size_t count : {2U, 3U, 25U, 99U, 100U}) {
            const auto kept = simplify(points, count);
            ASSERT_EQ(kept.size(), count);
            EXPECT_EQ(kept.front(), 0U);
            EXPECT_EQ(kept.back(), 99U);
            for (std::size_t i = 1; i < kept.size(); ++i) EXPECT_LT(kept[i - 1], kept[i]);
        }
    }
}

TEST(Simplifiers, KeepTheCornerOfARoof) {
    const std::vector<Position> roof{{0, 0}, {1, 0.99}, {2, 2.02}, {3, 3}, {4, 2.01}, {5, 0}};
    EXPECT_EQ(douglas_peucker(roof, 3), (std::vector<std::size_t>{0, 3, 5}));
    EXPECT_EQ(visvalingam(roof, 3), (std::vector<std::size_t>{0, 3, 5}));
}

TEST(Simplifiers, DifferWhereASpikeIsFarButSmall) {
    // The spike is the farthest point of its chord, the low hump the larger triangle.
    const std::vector<Position> line{{0, 0},  {4.9, 0}, {5, 1}, {5.1, 0},
                                     {10, 0}, {15, .5}, {20, 0}};
    EXPECT_EQ(douglas_peucker(line, 3), (std::vector<std::size_t>{0, 2, 6}));
    EXPECT_EQ(visvalingam(line, 4), (std::vector<std::size_t>{0, 4, 5, 6}));
}

}  // namespace
}  // namespace touchline::bench
