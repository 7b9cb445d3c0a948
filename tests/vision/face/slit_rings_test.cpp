#include "vision/face/face_map.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

const SpacingScale kScale{{116.0, 84.0}, 3.2, 0.25};

/// An eye between two corners, with sides this far apart in the middle.
Chain eye(double width_mm, double opening_mm) {
    constexpr int kParts = 40;
    Chain ring{{}, true};
    const auto add = [&](int i, double side) {
        const double x = static_cast<double>(i) / kParts;
        const double y = side * 2.0 * opening_mm * x * (1.0 - x);
        ring.points.push_back({{50.0 + x * width_mm, 40.0 + y}, 0.0, i == 0 || i == kParts});
    };
    for (int i = 0; i <= kParts; ++i) add(i, -1.0);
    for (int i = kParts - 1; i > 0; --i) add(i, 1.0);
    return ring;
}

double height_of(const Chain& line) {
    const auto [low, high] =
        std::ranges::minmax(line.points, {}, [](const EdgePoint& p) { return p.at.y; });
    return high.at.y - low.at.y;
}

TEST(SlitRings, ANarrowRingIsOpenedAndKeepsItsCorners) {
    for (const double opening_mm : {0.2, 1.0, 3.0}) {
        const Chain opened = opened_for_finger(eye(14.0, opening_mm), kScale);
        EXPECT_TRUE(opened.is_closed);
        EXPECT_GE(height_of(opened), 3.6 - 1e-6) << opening_mm;
        EXPECT_LE(height_of(opened), 6.0 + kScale.step_mm) << opening_mm;
        EXPECT_EQ(std::ranges::count(opened.points, true, &EdgePoint::is_fixed), 2);
        EXPECT_LT(distance(opened.points.front().at, {50.0, 40.0}), 1e-9);
    }
}

TEST(SlitRings, AWideRingStaysAsWideAsItIs) {
    EXPECT_NEAR(height_of(opened_for_finger(eye(30.0, 12.0), kScale)), 12.0, 0.1);
}

TEST(SlitRings, TheMiddleRunsFromCornerToCorner) {
    const Chain middle = middle_of(eye(14.0, 5.0));
    EXPECT_FALSE(middle.is_closed);
    EXPECT_LT(distance(middle.points.front().at, {50.0, 40.0}), 1e-9);
    EXPECT_LT(distance(middle.points.back().at, {64.0, 40.0}), 1e-9);
    EXPECT_LT(height_of(middle), 1e-6);
}

TEST(SlitRings, WhereTheRingBeginsDoesNotMatter) {
    Chain ring = eye(14.0, 2.0);
    std::ranges::rotate(ring.points, ring.points.begin() + 17);
    EXPECT_FALSE(middle_of(ring).is_closed);
    EXPECT_NEAR(height_of(opened_for_finger(ring, kScale)),
                height_of(opened_for_finger(eye(14.0, 2.0), kScale)), 1e-6);
}

TEST(SlitRings, WhatHasNoTwoCornersOrNoWidthStaysAsItIs) {
    Chain round = eye(14.0, 2.0);
    for (EdgePoint& p : round.points) p.is_fixed = false;
    Chain cornered = eye(14.0, 2.0);
    cornered.points[5].is_fixed = true;
    Chain open = eye(14.0, 2.0);
    open.is_closed = false;
    for (const Chain& line : {round, cornered, open, Chain{}, Chain{{}, true}}) {
        for (const Chain& same : {opened_for_finger(line, kScale), middle_of(line)}) {
            EXPECT_EQ(same.is_closed, line.is_closed);
            EXPECT_EQ(same.points.size(), line.points.size());
        }
    }
    EXPECT_LT(height_of(opened_for_finger(eye(14.0, 0.0), kScale)), 1e-9);
}

}  // namespace
}  // namespace touchline::testing
