#include "vision/figure/figure_colours.h"

#include "tests/vision/figure/with_noise.h"
#include "vision/figure/figures.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr float limit = 0.45F;

/// A brown square on green, with noise.
cv::Mat3b square_on_ground() {
    cv::Mat3b picture(300, 400, cv::Vec3b(60, 140, 80));
    cv::rectangle(picture, cv::Rect(120, 90, 160, 120), cv::Scalar(30, 60, 120), cv::FILLED);
    return with_noise(picture, 6.0, 5);
}

/// A blot over the whole picture, stretched to a square of 64, as a network gives it.
cv::Mat1f blot(const cv::Rect& box, float inside = 0.8F, float outside = 0.1F) {
    cv::Mat1f likelihood(64, 64, outside);
    cv::rectangle(likelihood, box, cv::Scalar(static_cast<double>(inside)), cv::FILLED);
    cv::GaussianBlur(likelihood, likelihood, cv::Size(), 3.0);
    return likelihood;
}

double overlap(const cv::Mat1f& likelihood, const cv::Rect2d& truth) {
    const cv::Mat found = likelihood >= 0.3F;
    cv::Mat1b wanted(found.size(), uchar{0});
    cv::rectangle(wanted,
                  cv::Rect(cvRound(truth.x * found.cols), cvRound(truth.y * found.rows),
                           cvRound(truth.width * found.cols), cvRound(truth.height * found.rows)),
                  cv::Scalar(255), cv::FILLED);
    return static_cast<double>(cv::countNonZero(found & wanted)) / cv::countNonZero(found | wanted);
}

const cv::Rect2d square(0.3, 0.3, 0.4, 0.4);  // of the picture

TEST(FigureColours, ABlotBesideAThingIsDrawnOntoIt) {
    const cv::Mat1f drawn =
        drawn_by_colours(blot(cv::Rect(22, 16, 20, 22)), limit, square_on_ground());
    EXPECT_EQ(drawn.size(), cv::Size(400, 300));
    EXPECT_GT(overlap(drawn, square), 0.93);
    EXPECT_TRUE(cv::checkRange(drawn, true, nullptr, 0.0, 1.0 + 1e-6));
}

/// Teeth of two pixels, as fine as hair, are lost in the coarse cut.
TEST(FigureColours, ARingIsDrawnAgainFiner) {
    cv::Mat3b picture(300, 400, cv::Vec3b(60, 140, 80));
    cv::rectangle(picture, cv::Rect(120, 90, 160, 120), cv::Scalar(30, 60, 120), cv::FILLED);
    for (int x = 120; x < 280; x += 4)
        cv::rectangle(picture, cv::Rect(x, 84, 2, 6), cv::Scalar(30, 60, 120), cv::FILLED);
    const cv::Mat1f drawn =
        drawn_by_colours(blot(cv::Rect(22, 16, 20, 22)), limit, with_noise(picture, 6.0, 5));
    int teeth = 0;
    int gaps = 0;
    for (int x = 120; x < 280; x += 4) {
        teeth += drawn(87, x) >= 0.3F || drawn(87, x + 1) >= 0.3F ? 1 : 0;
        gaps += drawn(87, x + 2) < 0.3F || drawn(87, x + 3) < 0.3F ? 1 : 0;
    }
    EXPECT_GT(teeth, 30);
    EXPECT_GT(gaps, 30);
}

/// The likelihood is far above the limit on one side of the square and far below it on the other: a
/// ring between such places would lie nearer to one of them.
TEST(FigureColours, TheRingLiesHalfWayBetweenItsTwoSides) {
    const cv::Mat1f drawn =
        drawn_by_colours(blot(cv::Rect(22, 16, 20, 22)), limit, square_on_ground());
    int crossings = 0;
    for (int x = 1; x < drawn.cols; ++x) {
        const float before = drawn(150, x - 1);
        const float after = drawn(150, x);
        if ((before >= 0.3F) == (after >= 0.3F)) continue;
        ++crossings;
        EXPECT_NEAR(0.5F * (before + after), 0.3F, 1e-5F) << x;
        EXPECT_GT(std::abs(after - before), 0.1F) << x;
    }
    EXPECT_EQ(crossings, 2);
}

TEST(FigureColours, TheLimitBecomesThatOfFigures) {
    const cv::Mat3b grey(64, 64, cv::Vec3b(90, 90, 90));
    const cv::Mat1f even = drawn_by_colours(cv::Mat1f(8, 8, limit), limit, grey);
    EXPECT_NEAR(even(20, 20), 0.3F, 1e-5F);
    EXPECT_NEAR(drawn_by_colours(cv::Mat1f(8, 8, 1.0F), limit, grey)(20, 20), 1.0F, 1e-5F);
    EXPECT_NEAR(drawn_by_colours(cv::Mat1f(8, 8, 0.0F), limit, grey)(20, 20), 0.0F, 1e-5F);
}

/// The colours know of two squares; the likelihood knows that one of them is not meant, and a
/// hidden animal has no colours of its own.
TEST(FigureColours, WhereColoursDisagreeWithTheLikelihoodItStays) {
    cv::Mat3b hidden(300, 400);
    cv::RNG(9).fill(hidden, cv::RNG::UNIFORM, 60, 180);
    const cv::Mat1f seen = blot(cv::Rect(20, 20, 24, 24));
    const cv::Mat1f drawn = drawn_by_colours(seen, limit, hidden);
    EXPECT_GT(overlap(drawn, cv::Rect2d(20 / 64.0, 20 / 64.0, 25 / 64.0, 25 / 64.0)), 0.7);
}

TEST(FigureColours, ThingsAndGroundsThatAreSureAreNeverGivenUp) {
    const cv::Mat1f drawn =
        drawn_by_colours(blot(cv::Rect(0, 0, 32, 64), 1.0F, 0.0F), limit, square_on_ground());
    EXPECT_GT(drawn(150, 36), 0.9F);
    EXPECT_LT(drawn(150, 357), 0.05F);
}

TEST(FigureColours, AreTheSameBitsAgain) {
    const cv::Mat1f seen = blot(cv::Rect(18, 24, 24, 20));
    const cv::Mat1f first = drawn_by_colours(seen, limit, square_on_ground());
    cv::theRNG().state = 77;
    const cv::Mat1f second = drawn_by_colours(seen, limit, square_on_ground());
    EXPECT_EQ(cv::theRNG().state, 77U);
    EXPECT_TRUE(std::ranges::equal(first, second));
}

TEST(FigureColours, APictureOfOneRowHasALikelihoodToo) {
    const cv::Mat1f drawn =
        drawn_by_colours(blot(cv::Rect(18, 24, 24, 20)), limit, cv::Mat3b(1, 900));
    EXPECT_EQ(drawn.size(), cv::Size(500, 1));
}

}  // namespace
}  // namespace touchline::testing
