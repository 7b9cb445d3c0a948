#include "vision/contour/ranking.h"

#include <numbers>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double kMetresPerPx = 0.0002;

Chain line(double length_px, double strength, bool is_closed) {
    Chain chain{{}, is_closed};
    const double turn = is_closed ? 0.5 : 1.0;  // there and back again
    for (int i = 0; i <= 20; ++i) {
        chain.points.push_back({{turn * length_px * i / 20.0, 0.0}, strength});
    }
    return chain;
}

TEST(Ranking, LongStrongAndClosedComeFirst) {
    const auto order = ranked(
        {line(100, 10, false), line(400, 10, false), line(400, 10, true), line(400, 5, false)}, 8.0,
        kMetresPerPx);
    ASSERT_EQ(order.size(), 4U);
    EXPECT_TRUE(order[0].chain.is_closed);
    EXPECT_NEAR(length_of(order[1].chain), 400.0, 1e-9);
    EXPECT_EQ(order[1].chain.points[0].strength, 10.0);
    EXPECT_EQ(order[2].chain.points[0].strength, 5.0);
    EXPECT_GT(order[0].salience, order[1].salience);
    EXPECT_LE(order[0].salience, 1.0);
}

TEST(Ranking, EveryDetailKeepsItsBudget) {
    std::vector<Chain> chains;
    for (int i = 0; i < 600; ++i) {
        chains.push_back(line(50.0, 10.0, false));
    }
    const auto order = ranked(std::move(chains), 8.0, kMetresPerPx);
    for (int detail = 1; detail <= 5; ++detail) {
        int count = 0;
        double length_m = 0.0;
        for (const RankedOutline& outline : order) {
            if (outline.detail <= detail) {
                ++count;
                length_m += length_of(outline.chain) * kMetresPerPx;
            }
        }
        const DetailBudget& budget = kDetailBudgets[static_cast<std::size_t>(detail) - 1];
        EXPECT_LE(count, budget.outlines);
        EXPECT_LE(length_m, budget.line_m + 1e-9);
    }
    EXPECT_EQ(order.back().detail, 6);
}

TEST(Ranking, TheFirstIsAlwaysShown) {
    const auto order = ranked({line(1e5, 10, false), line(10, 10, false)}, 8.0, kMetresPerPx);
    EXPECT_EQ(order[0].detail, 1);
    EXPECT_GT(order[1].detail, 5);
}

}  // namespace
}  // namespace touchline
