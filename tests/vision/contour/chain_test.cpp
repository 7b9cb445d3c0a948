#include "vision/contour/chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::vector<EdgePoint> drawn_walk() {
    std::vector<EdgePoint> walk{{{0.0, 0.0}, 1.0}};
    const auto steps =
        *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 628)));
    for (const int step : steps) {
        const double angle = step / 100.0;
        walk.push_back({walk.back().at + cv::Point2d(std::cos(angle), std::sin(angle)), 2.0});
    }
    return walk;
}

RC_GTEST_PROP(Sampling, PartsHaveEqualArcLength, ()) {
    const std::vector<EdgePoint> walk = drawn_walk();
    const int n = *rc::gen::inRange(1, 50);
    const std::vector<EdgePoint> even = evenly_spaced(walk, n);
    RC_ASSERT(even.size() == static_cast<std::size_t>(n) + 1);
    RC_ASSERT(even.front().at == walk.front().at);
    RC_ASSERT(even.back().at == walk.back().at);
    const double step = length_of({walk, false}) / n;
    for (std::size_t i = 1; i < even.size(); ++i) {  // a chord is no longer than its arc
        RC_ASSERT(distance(even[i - 1].at, even[i].at) <= step * (1.0 + 1e-9));
    }
}

RC_GTEST_PROP(Sampling, FixedPointsAndEndsStay, ()) {
    std::vector<EdgePoint> walk = drawn_walk();
    const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(walk.size())));
    walk[at].is_fixed = true;
    const Chain open = resampled({walk, false}, 1.5);
    RC_ASSERT(open.points.front().at == walk.front().at);
    RC_ASSERT(open.points.back().at == walk.back().at);
    for (const bool is_closed : {false, true}) {
        const Chain even = resampled({walk, is_closed}, 1.5);
        RC_ASSERT(even.is_closed == is_closed);
        RC_ASSERT(std::ranges::any_of(even.points,
                                      [&](const EdgePoint& p) { return p.at == walk[at].at; }));
    }
}

TEST(Sampling, NothingStaysNothing) {
    EXPECT_TRUE(evenly_spaced({}, 4).empty());
    for (const bool is_closed : {false, true}) {
        const Chain even = resampled({{}, is_closed}, 1.0);
        EXPECT_TRUE(even.points.empty());
        EXPECT_EQ(even.is_closed, is_closed);
    }
}

TEST(Sampling, WhatHasNoLengthStaysInItsPlace) {
    const EdgePoint p{{3.0, 4.0}, 2.0};
    for (const std::size_t count : {1U, 2U, 5U}) {
        const std::vector<EdgePoint> line(count, p);
        const std::vector<EdgePoint> even = evenly_spaced(line, 3);
        ASSERT_EQ(even.size(), 4U);
        for (const bool is_closed : {false, true}) {
            const Chain chain = resampled({line, is_closed}, 1.0);
            EXPECT_GE(chain.points.size(), is_closed ? 4U : 1U);
            for (const EdgePoint& q : chain.points) {
                EXPECT_EQ(q.at, p.at);
            }
        }
        for (const EdgePoint& q : even) {
            EXPECT_EQ(q.at, p.at);
        }
    }
}

TEST(Sampling, ACircleStaysACircle) {
    Chain circle{{}, true};
    for (int i = 0; i < 300; ++i) {
        const double a = 2.0 * std::numbers::pi * i / 300.0;
        circle.points.push_back({{30.0 * std::cos(a), 30.0 * std::sin(a)}, 1.0});
    }
    const Chain even = resampled(circle, 1.0);
    EXPECT_TRUE(even.is_closed);
    EXPECT_NEAR(static_cast<double>(even.points.size()), 188.0, 1.0);
    for (const EdgePoint& p : even.points) {
        EXPECT_NEAR(cv::norm(p.at), 30.0, 0.05);
    }
}

}  // namespace
}  // namespace touchline
