#include "tests/lab/bench/curve/coarse_curve.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace touchline::bench {
namespace {

std::vector<Position> circle(std::size_t count) {
    std::vector<Position> points;
    for (std::size_t i = 0; i <= count; ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i % count) / static_cast<double>(count);
        points.push_back({std::cos(angle), std::sin(angle)});
    }
    return points;
}

TEST(CoarseCurve, HasAsManyPointsAsAskedByEveryMethod) {
    const auto points = circle(64);
    for (const Method method : all_methods) {
        for (int level = 0; level <= 3; ++level) {
            const CoarseCurve coarse = coarse_curve(method, points, level);
            EXPECT_EQ(coarse.points.size(), (64U >> static_cast<unsigned>(level)) + 1);
            EXPECT_EQ(coarse.parameters.size(), coarse.points.size());
        }
    }
}

TEST(CurveError, OfTheCurveItselfIsNothing) {
    const auto points = circle(64);
    for (const Method method : all_methods) {
        const CurveError error = curve_error(points, coarse_curve(method, points, 0));
        EXPECT_LE(error.rms, 1e-15);
        EXPECT_LE(error.hausdorff, 1e-15);
        EXPECT_LE(error.slope_rad, 1e-7);
        EXPECT_LE(error.box, 1e-15);
    }
}

TEST(CoarseCurve, OfAnOpenLineKeepsItsEnds) {
    auto line = circle(64);
    line.resize(33);
    for (const Method method : all_methods) {
        if (method == Method::haar) continue;
        const CoarseCurve coarse = coarse_curve(method, line, 2);
        ASSERT_EQ(coarse.points.size(), 9U) << name_of(method);
        EXPECT_LE(norm(coarse.points.front() - line.front()), 1e-12) << name_of(method);
        EXPECT_LE(norm(coarse.points.back() - line.back()), 1e-12) << name_of(method);
        EXPECT_LE(curve_error(line, coarse).hausdorff, 0.02) << name_of(method);
    }
}

/// Takes every 16th point of a circle, where the chords' sagitta is known.
TEST(CurveError, OfASubsampledCircleIsItsSagitta) {
    const auto points = circle(512);
    const CurveError error = curve_error(points, coarse_curve(Method::subsample, points, 4));
    const double half_angle = std::numbers::pi / 32.0;
    const double sagitta = 1.0 - std::cos(half_angle);
    const double size = std::sqrt(8.0);
    EXPECT_NEAR(error.hausdorff, sagitta / size, 1e-3 * sagitta);
    EXPECT_NEAR(error.box, 0.5 * sagitta / size, 1e-3 * sagitta);
    EXPECT_NEAR(error.slope_rad, half_angle / std::sqrt(3.0), 1e-2 * half_angle);
    EXPECT_LT(error.rms, error.hausdorff);
}

/// A Haar point lies inside the circle, between those that it averages: parameters must say so.
TEST(CurveError, OfAHaarCurveIsMeasuredWhereItsPointsStand) {
    const auto points = circle(64);
    const CoarseCurve coarse = coarse_curve(Method::haar, points, 2);
    EXPECT_DOUBLE_EQ(coarse.parameters[1], 5.5);
    const double angle = std::atan2(coarse.points[1].y, coarse.points[1].x);
    EXPECT_NEAR(angle, 2.0 * std::numbers::pi * 5.5 / 64.0, 1e-12);
}

}  // namespace
}  // namespace touchline::bench
