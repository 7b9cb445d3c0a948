#include "vision/contour/corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

/// Two straight sides of 40 px with a circular bend of the given radius between them.
Chain bent(double turn, double radius_px) {
    Chain chain;
    const double tangent_px = radius_px * std::tan(turn / 2.0);
    for (double s = -40.0; s < -tangent_px; s += 0.7) {
        chain.points.push_back({{s, 0.0}, 1.0});
    }
    for (double a = 0.0; a < turn; a += 0.3 / radius_px) {
        chain.points.push_back(
            {{-tangent_px + radius_px * std::sin(a), radius_px * (1.0 - std::cos(a))}, 1.0});
    }
    for (double s = tangent_px; s < 40.0; s += 0.7) {
        chain.points.push_back({s * cv::Point2d(std::cos(turn), std::sin(turn)), 1.0});
    }
    return chain;
}

long fixed_points(const Chain& chain) {
    return std::ranges::count_if(chain.points, &EdgePoint::is_fixed);
}

RC_GTEST_PROP(Corners, ABendThatTheBlurExplainsBecomesItsVertex, ()) {
    const double turn = (50 + *rc::gen::inRange(0, 90)) * std::numbers::pi / 180.0;
    const Chain sharp = with_sharp_corners(bent(turn, 1.5 / std::tan(turn / 2.0)), 1.3);
    RC_ASSERT(fixed_points(sharp) == 1);
    const auto vertex = std::ranges::find_if(sharp.points, &EdgePoint::is_fixed);
    RC_ASSERT(cv::norm(vertex->at) < 0.1);
    for (const EdgePoint& p : sharp.points) {  // all on one of the two sides
        const cv::Point2d out(std::cos(turn), std::sin(turn));
        RC_ASSERT(std::min(std::abs(p.at.y), std::abs(out.cross(p.at))) < 0.15);
    }
}

TEST(Corners, ARoundBendStaysRound) {
    const Chain round = with_sharp_corners(bent(std::numbers::pi / 2.0, 12.0), 1.3);
    EXPECT_EQ(fixed_points(round), 0);
}

TEST(Corners, WhatHasNoLengthStaysInItsPlace) {
    const EdgePoint p{{3.0, 4.0}, 2.0};
    EdgePoint hair = p;
    hair.at.x += 1e-12;
    for (const bool is_closed : {false, true}) {
        EXPECT_TRUE(with_sharp_corners({{}, is_closed}, 1.3).points.empty());
        for (const std::vector<EdgePoint>& points :
             {std::vector{p}, std::vector{p, p, p}, std::vector{p, hair}}) {
            const Chain sharp = with_sharp_corners({points, is_closed}, 1.3);
            EXPECT_FALSE(sharp.points.empty());
            for (const EdgePoint& q : sharp.points) {
                EXPECT_LE(distance(q.at, p.at), 1.1e-12);
            }
        }
    }
}

TEST(Corners, ACircleHasNone) {
    for (const double radius : {4.0, 10.0, 60.0}) {
        Chain circle{{}, true};
        for (double a = 0.0; a < 2.0 * std::numbers::pi; a += 0.7 / radius) {
            circle.points.push_back({{radius * std::cos(a), radius * std::sin(a)}, 1.0});
        }
        EXPECT_EQ(fixed_points(with_sharp_corners(circle, 1.3)), 0) << radius;
    }
}

TEST(Corners, FixedPointsStay) {
    Chain chain = bent(1.2, 2.0);
    const std::size_t at = chain.points.size() / 2;
    chain.points[at].is_fixed = true;
    const cv::Point2d kept = chain.points[at].at;
    const Chain sharp = with_sharp_corners(chain, 1.3);
    EXPECT_TRUE(
        std::ranges::any_of(sharp.points, [&](const EdgePoint& p) { return p.at == kept; }));
    EXPECT_EQ(sharp.points.front().at, chain.points.front().at);
    EXPECT_EQ(sharp.points.back().at, chain.points.back().at);
}

}  // namespace
}  // namespace touchline
