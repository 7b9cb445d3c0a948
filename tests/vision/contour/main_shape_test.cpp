#include "vision/contour/main_shape.h"

#include "tests/vision/pictures/canvas.h"
#include "tests/vision/pictures/scenes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

double overlap(const Chain& ring, const cv::Mat1b& truth) {
    std::vector<cv::Point> corners;
    for (const EdgePoint& point : ring.points) {
        corners.emplace_back(cvRound(point.at.x), cvRound(point.at.y));
    }
    cv::Mat1b inside(truth.size(), uchar{0});
    cv::fillPoly(inside, std::vector<std::vector<cv::Point>>{corners}, 255);
    return static_cast<double>(cv::countNonZero(inside & truth)) /
           std::max(1, cv::countNonZero(inside | truth));
}

TEST(MainShape, FindsTheObjectOfMostScenes) {
    constexpr int scenes = 40;
    int found = 0;
    int right = 0;
    for (int seed = 0; seed < scenes; ++seed) {
        const testing::PhotoScene scene = testing::photo_scene(seed, {480, 360});
        const std::optional<Chain> shape = main_shape(scene.picture, std::nullopt);
        if (shape) {
            ++found;
            EXPECT_TRUE(shape->is_closed);
            right += overlap(*shape, scene.truth) >= 0.8 ? 1 : 0;
        }
    }
    EXPECT_GE(right, scenes * 9 / 10);
    EXPECT_GE(right, found * 9 / 10);  // no shape is better than a wrong one
}

TEST(MainShape, ASpotChoosesTheObject) {
    int right = 0;
    constexpr int scenes = 20;
    for (int seed = 100; seed < 100 + scenes; ++seed) {
        const testing::PhotoScene scene = testing::photo_scene(seed, {480, 360});
        const cv::Moments m = cv::moments(scene.truth, true);
        const std::optional<Chain> shape =
            main_shape(scene.picture, cv::Point2d(m.m10 / m.m00, m.m01 / m.m00));
        right += shape && overlap(*shape, scene.truth) >= 0.8 ? 1 : 0;
    }
    EXPECT_GE(right, scenes * 7 / 10);
}

TEST(MainShape, NothingWhereNothingStandsOut) {
    EXPECT_FALSE(main_shape(cv::Mat(200, 300, CV_8UC3, cv::Scalar(90, 90, 90)), std::nullopt));
    cv::Mat3b noise(200, 300);
    cv::RNG random(5);
    random.fill(noise, cv::RNG::UNIFORM, 0, 256);
    EXPECT_FALSE(main_shape(noise, std::nullopt));
    EXPECT_FALSE(main_shape(cv::Mat(4, 4, CV_8UC3, cv::Scalar(90, 90, 90)), std::nullopt));
}

/// Goes from red over green to blue, from top to bottom, as a file with its own gamma holds it.
cv::Mat3b hue_ramp(cv::Size size) {
    const auto level = [](double share) {
        return cv::saturate_cast<uchar>(255.0 * std::pow(std::clamp(share, 0.0, 1.0), 0.45));
    };
    cv::Mat3b picture(size);
    for (int y = 0; y < size.height; ++y) {
        const double sixth = 4.0 * y / size.height;  // of the circle of hues
        picture.row(y).setTo(
            cv::Scalar(level(sixth - 2.0), level(2.0 - std::abs(sixth - 2.0)), level(2.0 - sixth)));
    }
    return picture;
}

TEST(MainShape, AThingOnePixelWideHasNoOutline) {
    // The uppermost row differs from all others: it is the object, and smoothing leaves nothing of
    // it.
    EXPECT_FALSE(main_shape(hue_ramp({32, 32}), std::nullopt));
}

TEST(MainShape, AStripIsAllBorder) {
    cv::Mat3b strip(16, 4000, cv::Vec3b(200, 90, 30));
    strip.colRange(1000, 3000) = cv::Vec3b(10, 200, 90);
    EXPECT_FALSE(main_shape(strip, std::nullopt));
    EXPECT_FALSE(main_shape(strip.t(), std::nullopt));
    EXPECT_FALSE(main_shape(strip, cv::Point2d(2000.0, 8.0)));
}

TEST(MainShape, TheSameTwiceWhateverTheRandomState) {
    const testing::PhotoScene scene = testing::photo_scene(1, {480, 360});
    const std::optional<Chain> first = main_shape(scene.picture, std::nullopt);
    cv::theRNG().state = 4711;
    const std::optional<Chain> second = main_shape(scene.picture, std::nullopt);
    ASSERT_TRUE(first && second);
    ASSERT_EQ(first->points.size(), second->points.size());
    for (std::size_t i = 0; i < first->points.size(); ++i) {
        EXPECT_EQ(first->points[i].at, second->points[i].at);
    }
    EXPECT_EQ(cv::theRNG().state, 4711U);
}

}  // namespace
}  // namespace touchline
