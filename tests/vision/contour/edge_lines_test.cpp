#include "vision/contour/edge_lines.h"

#include "vision/contour/gradient.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

/// Left half one colour (BGR), right half another.
cv::Mat3b two_colours(const cv::Vec3b& left, const cv::Vec3b& right) {
    cv::Mat3b picture(40, 60, left);
    picture.colRange(30, 60) = right;
    return picture;
}

TEST(Gradient, ADifferenceOfColourCountsAsMuchAsOneOfLightness) {
    // CIE L*a*b* of the sRGB primaries: red (53.2, 80.1, 67.2), green (87.7, -86.2, 83.2).
    const LabPicture lab = to_lab(two_colours({0, 0, 255}, {0, 255, 0}), full_colour);
    const double distance = cv::norm(lab(20, 10) - lab(20, 50));
    EXPECT_NEAR(distance, 2.55 * std::hypot(87.7 - 53.2, -86.2 - 80.1, 83.2 - 67.2), 1.0);
}

TEST(Gradient, TheNormalPointsToTheLighterSide) {
    for (const bool is_left_lighter : {false, true}) {
        const cv::Vec3b dark(90, 20, 20);
        const cv::Vec3b light(200, 210, 220);
        const cv::Mat3b picture =
            is_left_lighter ? two_colours(light, dark) : two_colours(dark, light);
        const GradientField field = colour_gradient(to_lab(picture, full_colour), 1.5);
        EXPECT_NEAR(field.normal(20, 29)[0], is_left_lighter ? -1.0F : 1.0F, 1e-4F);
        for (const Chain& line : edge_lines(field, {5.0, 10.0})) {
            for (const EdgePoint& p : line.points) {
                EXPECT_NEAR(p.to_light[0], is_left_lighter ? -1.0F : 1.0F, 1e-3F);
            }
        }
    }
}

TEST(Gradient, SmoothRampsOfAnyColourHaveNoLines) {
    for (const cv::Vec3b& colour :
         {cv::Vec3b(1, 0, 0), cv::Vec3b(0, 1, 0), cv::Vec3b(0, 0, 1), cv::Vec3b(1, 1, 1)}) {
        for (const int pixels_a_level : {3, 5, 11}) {
            cv::Mat3b ramp(60, 255 * pixels_a_level);
            for (int x = 0; x < ramp.cols; ++x) {
                ramp.col(x) = colour * static_cast<double>(x / pixels_a_level);
            }
            const LabPicture lab = to_lab(ramp, full_colour);
            const double noise = noise_of(lab);
            const double sigma_px = smoothing_for(lab, noise);
            const GradientField field = colour_gradient(lab, sigma_px);
            EXPECT_TRUE(edge_lines(field, thresholds_for(field, noise, sigma_px)).empty())
                << colour << " " << pixels_a_level;
        }
    }
}

/// A step of 100 grey levels, blurred to `sigma_px`, along a line through `through` at `angle`: the
/// gradient of the Gaussian, in closed form.
GradientField step_field(cv::Size size, cv::Point2d through, double angle, double sigma_px) {
    GradientField field{cv::Mat1f(size), cv::Mat2f(size)};
    const cv::Point2d normal(std::cos(angle), std::sin(angle));
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double d = (cv::Point2d(x, y) - through).dot(normal) / sigma_px;
            field.strength(y, x) = static_cast<float>(
                100.0 / (sigma_px * std::sqrt(2.0 * std::numbers::pi)) * std::exp(-0.5 * d * d));
            // Either sign of the normal means the same edge.
            const double sign = (x + y) % 2 == 0 ? 1.0 : -1.0;
            field.normal(y, x) = {static_cast<float>(sign * normal.x),
                                  static_cast<float>(sign * normal.y)};
        }
    }
    return field;
}

RC_GTEST_PROP(EdgeLines, AStraightEdgeIsOneLineWithinATwentiethOfAPixel, ()) {
    const double angle = *rc::gen::inRange(0, 3600) / 1800.0 * std::numbers::pi;
    const cv::Point2d through(30.0 + *rc::gen::inRange(0, 100) / 100.0,
                              25.0 + *rc::gen::inRange(0, 100) / 100.0);
    const double sigma = 1.2 + *rc::gen::inRange(0, 20) / 10.0;
    const auto lines = edge_lines(step_field({61, 51}, through, angle, sigma), {2.0, 5.0});
    RC_ASSERT(lines.size() == 1U);
    RC_ASSERT(!lines[0].is_closed);
    RC_ASSERT(length_of(lines[0]) > 40.0);
    for (const EdgePoint& p : lines[0].points) {
        const double d = (p.at - through).dot({std::cos(angle), std::sin(angle)});
        const cv::Rect2d inside(2.0, 2.0, 56.0, 46.0);  // slopes are one-sided at the frame
        RC_ASSERT(std::abs(d) < (inside.contains(p.at) ? 0.05 : 0.3));
    }
}

TEST(EdgeLines, ARingOfSlopesIsOneClosedLine) {
    const cv::Size size(80, 60);
    const cv::Point2d centre(40.3, 29.6);
    GradientField field{cv::Mat1f(size), cv::Mat2f(size)};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const cv::Point2d out = cv::Point2d(x, y) - centre;
            const double r = std::max(1e-9, cv::norm(out));
            field.strength(y, x) = static_cast<float>(40.0 * std::exp(-0.25 * (r - 20) * (r - 20)));
            field.normal(y, x) = {static_cast<float>(out.x / r), static_cast<float>(out.y / r)};
        }
    }
    const auto lines = edge_lines(field, {2.0, 5.0});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].is_closed);
    EXPECT_NEAR(length_of(lines[0]), 2.0 * std::numbers::pi * 20.0, 0.5);
    for (const EdgePoint& p : lines[0].points) {
        EXPECT_NEAR(distance(p.at, centre), 20.0, 0.05);
    }
}

TEST(EdgeLines, AWeakStretchIsFollowedOnlyFromAStrongOne) {
    GradientField field = step_field({60, 40}, {30.0, 20.2}, std::numbers::pi / 2.0, 1.5);
    for (int x = 0; x < 60; ++x) {  // strength falls along the edge from 26.6 to a tenth
        field.strength.col(x) *= x < 30 ? 1.0 : 0.1;
    }
    const auto both = edge_lines(field, {1.0, 10.0});
    ASSERT_EQ(both.size(), 1U);
    EXPECT_GT(length_of(both[0]), 55.0);
    const auto strong = edge_lines(field, {5.0, 10.0});
    ASSERT_EQ(strong.size(), 1U);
    EXPECT_LT(length_of(strong[0]), 35.0);
    EXPECT_TRUE(edge_lines(field, {1.0, 100.0}).empty());
}

TEST(EdgeLines, AFlatFieldHasNone) {
    EXPECT_TRUE(
        edge_lines({cv::Mat1f(20, 20, 3.0F), cv::Mat2f(20, 20, cv::Vec2f(1, 0))}, {1, 2}).empty());
    EXPECT_TRUE(
        edge_lines({cv::Mat1f(1, 1, 3.0F), cv::Mat2f(1, 1, cv::Vec2f(1, 0))}, {1, 2}).empty());
}

}  // namespace
}  // namespace touchline
