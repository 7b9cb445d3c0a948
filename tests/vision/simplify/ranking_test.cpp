#include "config/types/map_limits.h"
#include "vision/simplify/selection.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

Chain line(double length_mm, double strength, bool is_closed) {
    Chain chain{{}, is_closed};
    const double turn = is_closed ? 0.5 : 1.0;  // there and back
    for (int i = 0; i <= 20; ++i) {
        chain.points.push_back({{turn * length_mm * i / 20.0, 0.0}, strength});
    }
    return chain;
}

TEST(Ranking, LongStrongClosedAndOuterComeFirst) {
    const auto order = ranked({line(20, 10, false), line(80, 10, false), line(80, 10, true),
                               line(80, 5, false), line(80, 10, true)},
                              {1.0, 1.0, 0.0, 1.0, 1.0}, 8.0);
    ASSERT_EQ(order.size(), 5U);
    EXPECT_TRUE(order[0].line.is_closed);
    EXPECT_EQ(order[0].outer_share, 1.0);
    EXPECT_TRUE(order[1].line.is_closed);
    EXPECT_EQ(order[1].outer_share, 0.0);
    EXPECT_NEAR(length_of(order[2].line), 80.0, 1e-9);
    EXPECT_EQ(order[2].line.points[0].strength, 10.0);
    EXPECT_EQ(order[3].line.points[0].strength, 5.0);
    EXPECT_GT(order[3].salience, order[4].salience);
    EXPECT_LE(order[0].salience, 1.0);
}

TEST(Ranking, ALineWithoutStrengthIsTheLastAndNotNothing) {
    const auto order = ranked({line(30, 0, false), line(10, 1, false)}, {1.0, 1.0}, 8.0);
    EXPECT_EQ(order[1].line.points[0].strength, 0.0);
    EXPECT_GT(order[1].salience, 0.0);  // the weight of an outline
    EXPECT_GT(order[0].salience, order[1].salience);
}

TEST(Ranking, NoLineWeighsLessThanAMapMayHold) {
    for (const double length_mm : {1e-6, 0.18, 10.0}) {
        for (const bool is_closed : {false, true}) {
            const auto order = ranked({line(length_mm, 0, is_closed)}, {0.0}, 8.0);
            EXPECT_GE(order[0].salience, MapLimits::least_weight) << length_mm;
        }
    }
}

TEST(Ranking, TiesKeepTheirOrder) {
    const auto order = ranked({line(30, 10, false), line(30, 10, false)}, {1.0, 0.999}, 8.0);
    EXPECT_EQ(order[0].outer_share, 1.0);
}

}  // namespace
}  // namespace touchline
