#include "vision/contour/linking.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

const cv::Size wide_picture(400, 300);
constexpr double widest_stroke_px = 12.0;

/// A wave and its parallels: `offset_px` to the right of its way.
struct Wave {
    double height_px = 0.0;
    double length_px = 100.0;

    cv::Point2d at(double x, double offset_px) const {
        const double k = 2.0 * std::numbers::pi / length_px;
        const cv::Point2d along(1.0, height_px * k * std::cos(k * x));
        const cv::Point2d right = cv::Point2d(-along.y, along.x) / cv::norm(along);
        return cv::Point2d(x, 150.0 + height_px * std::sin(k * x)) + offset_px * right;
    }
};

/// One edge of a stripe along the wave; `is_light_right`: its right side is the lighter one.
Chain edge(const Wave& wave, double from, double to, double offset_px, bool is_light_right) {
    Chain chain;
    for (double x = from; x <= to; x += 0.7) {
        const cv::Point2d right = wave.at(x, 1.0) - wave.at(x, 0.0);
        const cv::Vec2f to_light(static_cast<float>(right.x), static_cast<float>(right.y));
        chain.points.push_back(
            {wave.at(x, offset_px), 10.0, false, is_light_right ? to_light : -to_light});
    }
    return chain;
}

Chain ring(cv::Point2d centre, cv::Size2d radii, double light_out) {
    Chain chain;
    chain.is_closed = true;
    for (int i = 0; i < 400; ++i) {
        const double a = 2.0 * std::numbers::pi * i / 400;
        cv::Point2d out(std::cos(a) / radii.width, std::sin(a) / radii.height);
        out *= light_out / cv::norm(out);
        chain.points.push_back(
            {centre + cv::Point2d(radii.width * std::cos(a), radii.height * std::sin(a)), 10.0,
             false, cv::Vec2f(static_cast<float>(out.x), static_cast<float>(out.y))});
    }
    return chain;
}

double distance_to_wave(const Wave& wave, const cv::Point2d& p) {
    double best = 1e9;
    for (double x = p.x - 15.0; x <= p.x + 15.0; x += 0.05) {
        best = std::min(best, distance(wave.at(x, 0.0), p));
    }
    return best;
}

bool are_same(const Chain& a, const Chain& b) {
    return a.is_closed == b.is_closed && a.width_px == b.width_px &&
           std::ranges::equal(a.points, b.points, [](const EdgePoint& p, const EdgePoint& q) {
               return p.at == q.at && p.strength == q.strength && p.is_fixed == q.is_fixed;
           });
}

RC_GTEST_PROP(DoubleEdges, BothEdgesOfAStripeBecomeItsMiddle, ()) {
    const Wave wave{*rc::gen::inRange(0, 12) * 1.0, 150.0};
    const double width = 2.0 + 0.1 * *rc::gen::inRange(0, 90);
    const bool is_dark = *rc::gen::arbitrary<bool>();
    const double shorter_from = *rc::gen::inRange(50, 110);
    Chain left = edge(wave, 50.0, 350.0, -0.5 * width, !is_dark);
    Chain right = edge(wave, shorter_from, 350.0, 0.5 * width, is_dark);
    if (*rc::gen::arbitrary<bool>()) std::ranges::reverse(left.points);
    if (*rc::gen::arbitrary<bool>()) std::ranges::reverse(right.points);
    const std::vector<Chain> merged =
        with_double_edges_merged({left, right}, wide_picture, widest_stroke_px);
    RC_ASSERT(merged.size() == 1U);
    RC_ASSERT(std::abs(merged[0].width_px - width) < 0.3);
    RC_ASSERT(length_of(merged[0]) > 0.9 * length_of(left));
    for (const EdgePoint& p : merged[0].points) {
        // Beyond the stripe the longer edge goes on alone.
        const double limit = p.at.x < shorter_from + 8.0 ? 0.5 * width + 0.6 : 0.6;
        RC_ASSERT(distance_to_wave(wave, p.at) < limit);
    }
}

RC_GTEST_PROP(DoubleEdges, WhatIsNoStripeStaysAsItIs, ()) {
    const Wave wave{*rc::gen::inRange(0, 12) * 1.0, 150.0};
    const int kind = *rc::gen::inRange(0, 4);
    const double width = kind == 0 ? 13.0 : 6.0;  // 0: too wide
    const bool is_step = kind == 1;               // 1: two steps in the same direction
    const double until = kind == 2 ? 50.0 + 0.6 * 150.0 : 350.0;  // 2: beside 60 % of the shorter
    Chain left = edge(wave, 50.0, until, -0.5 * width, true);
    Chain right = edge(wave, kind == 2 ? 50.0 + 0.4 * 90.0 : 50.0, 350.0, 0.5 * width, is_step);
    if (kind == 3) {  // unknown light side, as from a model
        for (EdgePoint& p : left.points) p.to_light = {0.0F, 0.0F};
    }
    const std::vector<Chain> lines{left, right};
    const std::vector<Chain> after =
        with_double_edges_merged(lines, wide_picture, widest_stroke_px);
    RC_ASSERT(after.size() == 2U);
    RC_ASSERT(are_same(after[0], left));
    RC_ASSERT(are_same(after[1], right));
}

TEST(DoubleEdges, AThinRingBecomesAnOpenLineAlongItsMiddle) {
    for (const double light : {1.0, -1.0}) {
        const std::vector<Chain> lines = with_double_edges_merged(
            {ring({200, 150}, {60, 4}, light)}, wide_picture, widest_stroke_px);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_FALSE(lines[0].is_closed);
        EXPECT_GT(lines[0].width_px, 5.0);
        EXPECT_GT(length_of(lines[0]), 100.0);
        for (const EdgePoint& p : lines[0].points) {
            EXPECT_NEAR(p.at.y, 150.0, 1.0);
        }
    }
}

TEST(DoubleEdges, ABlobStaysARing) {
    const Chain blob = ring({200, 150}, {5, 4}, 1.0);
    const std::vector<Chain> lines =
        with_double_edges_merged({blob}, wide_picture, widest_stroke_px);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(are_same(lines[0], blob));
}

TEST(DoubleEdges, AnAnnulusBecomesARing) {
    const std::vector<Chain> lines = with_double_edges_merged(
        {ring({200, 150}, {50, 50}, 1.0), ring({200, 150}, {44, 44}, -1.0)}, wide_picture,
        widest_stroke_px);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].is_closed);
    EXPECT_NEAR(lines[0].width_px, 6.0, 0.2);
    for (const EdgePoint& p : lines[0].points) {
        EXPECT_NEAR(distance(p.at, {200, 150}), 47.0, 0.3);
    }
}

TEST(DoubleEdges, ALineThatMetAnEdgeMeetsTheMiddle) {
    const Wave straight;
    Chain left = edge(straight, 50.0, 350.0, -3.0, false);
    const Chain right = edge(straight, 50.0, 350.0, 3.0, true);
    EdgePoint& junction = left.points[200];
    junction.is_fixed = true;
    Chain arm;
    for (int y = 40; y < 147; ++y) {
        arm.points.push_back({{junction.at.x, static_cast<double>(y)}, 10.0});
    }
    arm.points.push_back(junction);
    const std::vector<Chain> lines =
        with_double_edges_merged({left, arm, right}, wide_picture, widest_stroke_px);
    ASSERT_EQ(lines.size(), 2U);
    const Chain& middle = lines[0].width_px > 0.0 ? lines[0] : lines[1];
    const Chain& other = lines[0].width_px > 0.0 ? lines[1] : lines[0];
    EXPECT_NEAR(other.points.back().at.y, 150.0, 0.1);
    EXPECT_TRUE(std::ranges::any_of(middle.points, [&](const EdgePoint& p) {
        return p.is_fixed && p.at == other.points.back().at;
    }));
}

TEST(DoubleEdges, OfThreeLinesTheNarrowestPairIsMerged) {
    const Wave straight;
    const std::vector<Chain> lines = with_double_edges_merged(
        {edge(straight, 50.0, 350.0, 0.0, true), edge(straight, 50.0, 350.0, 10.0, false),
         edge(straight, 50.0, 350.0, 14.0, true)},
        wide_picture, widest_stroke_px);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_NEAR(std::max(lines[0].width_px, lines[1].width_px), 4.0, 0.1);
}

}  // namespace
}  // namespace touchline
