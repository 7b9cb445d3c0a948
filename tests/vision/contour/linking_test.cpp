#include "vision/contour/linking.h"

#include "config/types/angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr Reach linking_reach{
    .junction_px = 5.0, .gap_px = 10.0, .blur_px = 1.5, .shortest_px = 12.0};
const cv::Size small_picture(200, 150);

Chain straight(cv::Point2d from, cv::Point2d to) {
    Chain chain;
    const int n = static_cast<int>(distance(from, to));
    for (int i = 0; i <= n; ++i) {
        chain.points.push_back({from + (static_cast<double>(i) / n) * (to - from), 10.0});
    }
    return chain;
}

Chain circle(cv::Point2d centre, double radius, double from_deg, double to_deg) {
    Chain chain;
    const double sweep = (to_deg - from_deg) * std::numbers::pi / 180.0;
    const int n = static_cast<int>(radius * sweep);
    for (int i = 0; i <= n; ++i) {
        const double a = radians(from_deg) + sweep * i / n;
        chain.points.push_back({centre + radius * cv::Point2d(std::cos(a), std::sin(a)), 10.0});
    }
    return chain;
}

bool has_point(const Chain& chain, const cv::Point2d& p) {
    return std::ranges::any_of(chain.points,
                               [&](const EdgePoint& e) { return e.at == p && e.is_fixed; });
}

TEST(Linking, LinesInLineAreJoinedAcrossAGap) {
    const Linked result = linked({straight({30, 50}, {80, 50}), straight({88, 50.5}, {140, 51})},
                                 small_picture, linking_reach);
    ASSERT_EQ(result.chains.size(), 1U);
    EXPECT_EQ(result.gaps_closed, 1);
    EXPECT_NEAR(length_of(result.chains[0]), 110.0, 0.1);
}

TEST(Linking, LinesOutOfLineStayApart) {
    const Linked result = linked({straight({30, 50}, {80, 50}), straight({88, 50}, {88, 100})},
                                 small_picture, linking_reach);
    EXPECT_EQ(result.chains.size(), 2U);
    EXPECT_EQ(result.gaps_closed, 0);
}

TEST(Linking, TheNearerOfTwoContinuationsIsTaken) {
    const Linked result = linked({straight({30, 50}, {80, 50}), straight({84, 50}, {140, 50}),
                                  straight({92, 53}, {140, 70})},
                                 small_picture, linking_reach);
    ASSERT_EQ(result.chains.size(), 2U);
    EXPECT_EQ(result.gaps_closed, 1);
    EXPECT_NEAR(std::max(length_of(result.chains[0]), length_of(result.chains[1])), 110.0, 0.1);
}

TEST(Linking, ABrokenRingIsClosed) {
    const Linked result = linked({circle({100, 75}, 40, 5, 355)}, small_picture, linking_reach);
    ASSERT_EQ(result.chains.size(), 1U);
    EXPECT_TRUE(result.chains[0].is_closed);
}

TEST(Linking, AnEndBesideALineMeetsItInOnePoint) {
    const Linked result = linked({straight({20, 60}, {180, 60}), straight({100, 130}, {100, 63.5})},
                                 small_picture, linking_reach);
    ASSERT_EQ(result.chains.size(), 2U);
    EXPECT_EQ(result.junctions, 1);
    for (const Chain& chain : result.chains) {
        EXPECT_TRUE(has_point(chain, {100, 60}));
    }
    EXPECT_NEAR(std::max(length_of(result.chains[0]), length_of(result.chains[1])), 160.0, 1e-9);
}

TEST(Linking, AnEndBesideARingMeetsIt) {
    Chain ring = circle({100, 75}, 40, 0, 360);
    ring.points.pop_back();
    ring.is_closed = true;
    const Linked result =
        linked({ring, straight({190, 75}, {143, 75})}, small_picture, linking_reach);
    ASSERT_EQ(result.chains.size(), 2U);
    EXPECT_EQ(result.junctions, 1);
    EXPECT_TRUE(result.chains[0].is_closed || result.chains[1].is_closed);
    for (const Chain& chain : result.chains) {
        EXPECT_TRUE(has_point(chain, {140, 75}));
    }
}

TEST(Linking, ThreeEndsTogetherMeetWhereTheirLinesCross) {
    const cv::Point2d centre(100, 75);
    std::vector<Chain> arms;
    for (const double deg : {10.0, 130.0, 250.0}) {
        const double a = radians(deg);
        const cv::Point2d out(std::cos(a), std::sin(a));
        arms.push_back(straight(centre + 50.0 * out, centre + 2.0 * out));
    }
    const Linked result = linked(arms, small_picture, linking_reach);
    ASSERT_EQ(result.chains.size(), 3U);
    const cv::Point2d at = result.chains[0].points.front().is_fixed
                               ? result.chains[0].points.front().at
                               : result.chains[0].points.back().at;
    EXPECT_LT(distance(at, centre), 1e-6);
    for (const Chain& chain : result.chains) {
        EXPECT_TRUE(has_point(chain, at));
    }
}

TEST(Linking, ACrossingFromBothSidesIsOneJunctionAndRunsThrough) {
    const Linked result = linked({straight({20, 60}, {180, 60}), straight({100, 130}, {100, 63}),
                                  straight({101, 10}, {101, 57})},
                                 small_picture, linking_reach);
    EXPECT_EQ(result.chains.size(), 2U);
    EXPECT_EQ(result.junctions, 1);
}

TEST(Linking, AnEndAtTheFrameReachesIt) {
    const Linked result = linked({straight({0, 60}, {120, 60})}, small_picture, linking_reach);
    ASSERT_EQ(result.chains.size(), 1U);
    EXPECT_EQ(result.chains[0].points.front().at, cv::Point2d(-0.5, 60));
}

TEST(Linking, WhatOneSideOfTheFrameCutsIsClosed) {
    const Linked closed = linked({circle({100, 149}, 40, 180, 360)}, small_picture, linking_reach);
    ASSERT_EQ(closed.chains.size(), 1U);
    EXPECT_TRUE(closed.chains[0].is_closed);
    const Linked across = linked({straight({0, 60}, {199, 60})}, small_picture, linking_reach);
    EXPECT_FALSE(across.chains[0].is_closed);
}

TEST(Linking, WhatACornerOfTheFrameCutsIsClosedThroughIt) {
    const std::vector<std::pair<cv::Point2d, double>> corners{{{-0.5, -0.5}, 0.0},
                                                              {{199.5, -0.5}, 90.0},
                                                              {{199.5, 149.5}, 180.0},
                                                              {{-0.5, 149.5}, 270.0}};
    for (const auto& [corner, from_deg] : corners) {
        for (const bool is_turned : {false, true}) {
            Chain arc = circle(corner, 60, from_deg + 1.0, from_deg + 89.0);
            if (is_turned) {
                std::ranges::reverse(arc.points);
            }
            const Linked result = linked({arc}, small_picture, linking_reach);
            ASSERT_EQ(result.chains.size(), 1U);
            EXPECT_TRUE(result.chains[0].is_closed);
            EXPECT_EQ(result.chains[0].points.back().at, corner);
            EXPECT_TRUE(result.chains[0].points.back().is_fixed);
        }
    }
}

TEST(Linking, WhatOnlyRunsFromSideToSideStaysOpen) {
    for (const auto& [from, to] : std::vector<std::pair<cv::Point2d, cv::Point2d>>{
             {{0, 100}, {50, 149}}, {{0, 140}, {190, 149}}, {{0, 60}, {199, 40}}}) {
        const Linked result = linked({straight(from, to)}, small_picture, linking_reach);
        ASSERT_EQ(result.chains.size(), 1U);
        EXPECT_FALSE(result.chains[0].is_closed) << from;
    }
}

TEST(Linking, NothingComesOfNothing) {
    EXPECT_TRUE(linked({}, small_picture, linking_reach).chains.empty());
}

}  // namespace
}  // namespace touchline
