// Tests what becomes of a stroke: corners, ends, crossings, and strokes that nobody would draw.
#include "app/documents/drawing/touch_lines.h"

#include "config/types/angle.h"
#include "config/types/extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Points = std::vector<Position>;

/// The way over these corners in steps of 0.2 mm, as a pen that trembles by `tremble_m` leaves it.
Points pen_over(const Points& corners, double tremble_m = 0.0) {
    constexpr double step_m = 2e-4;
    Points way;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Position side = corners[i] - corners[i - 1];
        const int steps = static_cast<int>(std::ceil(norm(side) / step_m));
        for (int k = 0; k < steps; ++k) {
            const Position across = along<Position>(left_of(direction_of(side)), 1.0);
            const double off_m = tremble_m * std::sin(2.1 * static_cast<double>(way.size()));
            way.push_back(corners[i - 1] + (static_cast<double>(k) / steps) * side +
                          off_m * across);
        }
    }
    way.push_back(corners.back());
    return way;
}

/// Of a stroke that is no scribble.
std::vector<Outline> lines_of(const Points& stroke, const std::vector<Outline>& others,
                              const Area& area) {
    return touch_lines(stroke, others, area).value();
}

double distance_to(const Outline& outline, Position place) {
    double least_m = std::numeric_limits<double>::infinity();
    for (const Position& p : outline.points) least_m = std::min(least_m, norm(p - place));
    return least_m;
}

TEST(TouchLines, ATremblingLineBecomesStraightAndKeepsItsEnds) {
    const auto lines = lines_of(pen_over({{-0.03, 0.01}, {0.03, 0.01}}, 3e-4), {}, Area{});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_FALSE(lines[0].is_closed);
    EXPECT_NEAR(lines[0].points.front().x, -0.03, 1e-6);
    EXPECT_NEAR(lines[0].points.back().x, 0.03, 1e-6);
    for (const Position& p : lines[0].points) EXPECT_NEAR(p.y, 0.01, 1.5e-4);
}

TEST(TouchLines, CornersStayWhereTheyWereDrawn) {
    const Position corner{0.01, 0.02};
    const auto lines = lines_of(pen_over({{-0.02, -0.02}, corner, {0.03, -0.02}}), {}, Area{});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_LT(distance_to(lines[0], corner), 4e-4);
}

TEST(TouchLines, EndsThatNearlyMeetClose) {
    const auto square =
        pen_over({{-0.02, -0.02}, {0.02, -0.02}, {0.02, 0.02}, {-0.02, 0.02}, {-0.02, -0.017}});
    const auto lines = lines_of(square, {}, Area{});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].is_closed);
    EXPECT_FALSE(lines[0].points.front() == lines[0].points.back());
    // A short hook is no ring.
    const auto hook = lines_of(pen_over({{0.0, 0.0}, {0.004, 0.0}, {0.004, 0.003}}), {}, Area{});
    ASSERT_EQ(hook.size(), 1U);
    EXPECT_FALSE(hook[0].is_closed);
}

TEST(TouchLines, AnEndNearALineMeetsItBitForBit) {
    const auto ground = lines_of(pen_over({{-0.03, 0.0}, {0.03, 0.0}}), {}, Area{});
    const auto post = lines_of(pen_over({{0.01, 0.0015}, {0.01, 0.03}}), ground, Area{});
    ASSERT_EQ(post.size(), 1U);
    EXPECT_EQ(distance_to(ground[0], post[0].points.front()), 0.0);
    const auto high = lines_of(pen_over({{0.01, 0.003}, {0.01, 0.03}}), ground, Area{});
    EXPECT_GT(distance_to(ground[0], high[0].points.front()), 0.0025);
}

TEST(TouchLines, AStrokeThatCrossesItselfFallsIntoALoopAndTheRest) {
    const auto lines = lines_of(
        pen_over({{-0.03, 0.0}, {0.02, 0.0}, {0.02, 0.02}, {0.0, 0.02}, {0.0, -0.02}}), {}, Area{});
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(std::ranges::count_if(lines, &Outline::is_closed), 1);
}

TEST(TouchLines, WhatIsTooShortOrNowhereGivesNothing) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double far = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(lines_of({}, {}, Area{}).empty());
    EXPECT_TRUE(lines_of(Points{{0.0, 0.0}}, {}, Area{}).empty());
    EXPECT_TRUE(lines_of(Points(50, Position{0.01, 0.01}), {}, Area{}).empty());
    EXPECT_TRUE(lines_of(Points{{0.0, 0.0}, {0.003, 0.0}}, {}, Area{}).empty());
    EXPECT_TRUE(lines_of(Points{{nan, 0.0}, {0.0, nan}, {far, 0.0}}, {}, Area{}).empty());
}

TEST(TouchLines, BeyondTheAreaMeansItsRim) {
    const Area area;
    const auto lines = lines_of(pen_over({{0.0, 0.0}, {0.2, 0.0}}), {}, area);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NEAR(lines[0].points.back().x, area.width_m / 2.0, 1e-9);
}

TEST(TouchLines, ACircleStaysRound) {
    Points circle;
    for (int i = 0; i <= 360; ++i)
        circle.push_back({0.02 * std::cos(radians(i)), 0.02 * std::sin(radians(i))});
    const auto lines = lines_of(circle, {}, Area{});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].is_closed);
    for (const Position& p : lines[0].points) EXPECT_NEAR(norm(p), 0.02, 1e-4);
}

}  // namespace
}  // namespace touchline
