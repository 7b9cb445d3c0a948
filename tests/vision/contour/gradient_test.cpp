#include "vision/contour/gradient.h"

#include "vision/contour/edge_lines.h"

#include <cmath>

#include <gtest/gtest.h>

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
    const LabPicture lab = to_lab(two_colours({0, 0, 255}, {0, 255, 0}), kFullColour);
    const double distance = cv::norm(lab(20, 10) - lab(20, 50));
    EXPECT_NEAR(distance, 2.55 * std::hypot(87.7 - 53.2, -86.2 - 80.1, 83.2 - 67.2), 1.0);
}

TEST(Gradient, TheNormalPointsToTheLighterSide) {
    for (const bool is_left_lighter : {false, true}) {
        const cv::Vec3b dark(90, 20, 20);
        const cv::Vec3b light(200, 210, 220);
        const cv::Mat3b picture =
            is_left_lighter ? two_colours(light, dark) : two_colours(dark, light);
        const GradientField field = colour_gradient(to_lab(picture, kFullColour), 1.5);
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
            const LabPicture lab = to_lab(ramp, kFullColour);
            const double noise = noise_of(lab);
            const double sigma_px = smoothing_for(lab, noise);
            const GradientField field = colour_gradient(lab, sigma_px);
            EXPECT_TRUE(edge_lines(field, thresholds_for(field, noise, sigma_px)).empty())
                << colour << " " << pixels_a_level;
        }
    }
}

}  // namespace
}  // namespace touchline
