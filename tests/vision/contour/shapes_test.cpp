// Shapes with known outlines, traced and measured against them.
#include "tests/vision/contour/shapes.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace touchline::testing {
namespace {

struct Placement {
    cv::Size picture;
    double size_px;
    double angle_deg;
};

constexpr double smooth_limit_px = 0.5;
constexpr double corner_limit_px = 1.0;
constexpr double tip_limit_px = 3.0;

const std::vector<Placement> placements{
    {{300, 300}, 220.0, 0.0}, {{400, 300}, 200.0, 17.0}, {{420, 360}, 270.0, 31.0}};

/// Expects every ring once and closed, nothing else, and all of it within the limits.
void expect_traced(const Look& look, double allowance) {
    for (const Placement& place : placements) {
        const cv::Point2d centre(place.picture.width / 2.0 + 0.3, place.picture.height / 2.0 - 0.2);
        for (const Shape& shape : test_shapes(centre, place.size_px, place.angle_deg)) {
            SCOPED_TRACE(shape.name + " at " + std::to_string(place.angle_deg) + " degrees, blur " +
                         std::to_string(look.blur_px));
            const PhotoLines lines = photo_lines(drawn(shape, place.picture, look), 116.0);
            EXPECT_EQ(lines.chains.size(), shape.rings.size());
            EXPECT_TRUE(std::ranges::all_of(lines.chains, &Chain::is_closed));
            const Distances found = distances(shape, lines_in_pixels(lines, place.picture));
            EXPECT_LE(found.smooth_px, allowance * smooth_limit_px);
            EXPECT_LE(found.corner_px, allowance * corner_limit_px);
            EXPECT_LE(found.tip_px, allowance * tip_limit_px);
        }
    }
}

class BlurredShapes : public ::testing::TestWithParam<double> {};

TEST_P(BlurredShapes, BlackOnWhiteLieOnTheTruth) {
    expect_traced({.blur_px = GetParam()}, 1.0);
}

TEST_P(BlurredShapes, OneColourOnAnotherLieOnTheTruth) {
    expect_traced({.ink = {60, 160, 40}, .paper = {220, 200, 250}, .blur_px = GetParam()}, 1.0);
}

TEST_P(BlurredShapes, FaintOnesLieOnTheTruth) {
    expect_traced({.ink = {170, 170, 170}, .paper = {190, 190, 190}, .blur_px = GetParam()}, 1.0);
}

TEST_P(BlurredShapes, BlackOnWhiteInNoiseLieWithinTwice) {
    expect_traced({.blur_px = GetParam(), .noise_levels = 10.0}, 2.0);
}

TEST_P(BlurredShapes, LightOnDarkInNoiseLieWithinTwice) {
    expect_traced({.ink = {240, 240, 240},
                   .paper = {30, 30, 30},
                   .blur_px = GetParam(),
                   .noise_levels = 10.0,
                   .seed = 5},
                  2.0);
}

INSTANTIATE_TEST_SUITE_P(Sigma, BlurredShapes, ::testing::Values(0.0, 1.0));

}  // namespace
}  // namespace touchline::testing
