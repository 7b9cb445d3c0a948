#include "vision/figure/figures.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

/// A likelihood of 0.97 inside the drawn parts and 0.02 outside.
class Likelihood {
  public:
    Likelihood() : map_(256, 256, 0.02F) {}

    Likelihood& disc(cv::Point centre, int radius, float value = 0.97F) {
        cv::circle(map_, centre, radius, cv::Scalar(static_cast<double>(value)), cv::FILLED);
        return *this;
    }

    [[nodiscard]] Figures in(cv::Size picture) const { return figures_of(map_, picture); }

    [[nodiscard]] Figures at(cv::Point place, const cv::Rect& part, cv::Size picture) const {
        return figure_at(map_, part, picture, place);
    }

  private:
    cv::Mat1f map_;
};

TEST(Figures, AThingIsFoundInThePicturesProportions) {
    const Figures found = Likelihood().disc({128, 128}, 60).in({900, 600});
    EXPECT_TRUE(found.is_sure);
    ASSERT_EQ(found.boxes.size(), 1U);
    EXPECT_EQ(found.mask.size(), cv::Size(900, 600));
    const double across = 900.0 * 121 / 256;
    EXPECT_NEAR(found.boxes[0].width, across, 8.0);
    EXPECT_NEAR(found.boxes[0].height, across * 600 / 900, 6.0);
    EXPECT_GE(found.mask(300, 450), 128);
    EXPECT_LT(found.mask(20, 20), 128);
    EXPECT_NEAR(found.signs.area, 3.1416 * 60 * 60 / 65536, 0.01);
}

TEST(Figures, SeveralThingsComeTheLargestFirstAndSpecksAreNone) {
    const Figures found = Likelihood()
                              .disc({60, 60}, 30)
                              .disc({180, 150}, 50)
                              .disc({240, 20}, 4)         // too small to be a thing
                              .disc({180, 150}, 3, 0.1F)  // too small for a hole
                              .in({512, 512});
    ASSERT_EQ(found.boxes.size(), 2U);
    EXPECT_GT(found.boxes[0].area(), found.boxes[1].area());
    EXPECT_LT(found.mask(40, 480), 128);
    EXPECT_GE(found.mask(300, 360), 128);
}

TEST(Figures, AHoleThatAFingerFindsStays) {
    const Figures found =
        Likelihood().disc({128, 128}, 80).disc({128, 128}, 20, 0.02F).in({512, 512});
    EXPECT_TRUE(found.is_sure);
    EXPECT_LT(found.mask(256, 256), 128);
}

TEST(Figures, NothingASpeckOrAWideHaloIsNoClearThing) {
    EXPECT_FALSE(Likelihood().in({640, 480}).is_sure);
    EXPECT_TRUE(Likelihood().in({640, 480}).boxes.empty());
    EXPECT_FALSE(Likelihood().disc({128, 128}, 7).in({640, 480}).is_sure);
    EXPECT_FALSE(Likelihood().disc({128, 128}, 60, 0.6F).in({640, 480}).is_sure);
    EXPECT_FALSE(Likelihood().disc({128, 128}, 90, 0.5F).disc({128, 128}, 60).in({64, 48}).is_sure);
}

TEST(Figures, OfALargePictureTheMaskHasAMegapixel) {
    const Figures found = Likelihood().disc({128, 128}, 60).in({8000, 6000});
    EXPECT_LE(found.mask.total(), 1'010'000U);
    EXPECT_NEAR(static_cast<double>(found.mask.cols) / found.mask.rows, 8.0 / 6.0, 0.01);
    EXPECT_EQ(Likelihood().disc({128, 128}, 60).in({5000, 1}).mask.rows, 1);
}

TEST(Figures, ThePartAroundAPlaceLiesInThePicture) {
    const cv::Size size(800, 600);
    EXPECT_EQ(part_around(size, {400, 300}, 0.5), cv::Rect(200, 100, 400, 400));
    EXPECT_EQ(part_around(size, {0, 599}, 0.5), cv::Rect(0, 200, 400, 400));
    EXPECT_EQ(part_around(size, {799, 0}, 0.9), cv::Rect(80, 0, 720, 600));
    EXPECT_EQ(part_around({1, 1}, {0, 0}, 0.25), cv::Rect(0, 0, 1, 1));
}

TEST(Figures, TheThingAtAPlaceIsFoundWhereItLiesInThePicture) {
    const cv::Rect part(400, 100, 400, 400);
    const Likelihood two = Likelihood().disc({64, 128}, 40).disc({200, 128}, 30);
    // The discs' middles: 400 + 400 * 64 / 256 = 500 and 400 + 400 * 200 / 256 = 712.
    const Figures left = two.at({505, 300}, part, {800, 600});
    ASSERT_EQ(left.boxes.size(), 1U);
    EXPECT_TRUE(left.is_sure);
    EXPECT_EQ(left.mask.size(), cv::Size(800, 600));
    EXPECT_NEAR(left.boxes[0].x, 500 - 63, 4);
    EXPECT_NEAR(left.boxes[0].width, 126, 6);
    EXPECT_GE(left.mask(300, 500), 128);
    EXPECT_LT(left.mask(300, 712), 128) << "the other thing is another one";
    EXPECT_GE(two.at({755, 300}, part, {800, 600}).mask(300, 712), 128) << "close beside it";
    EXPECT_FALSE(two.at({590, 120}, part, {800, 600}).is_sure) << "nothing lies there";
    EXPECT_TRUE(two.at({590, 120}, part, {800, 600}).boxes.empty());
}

TEST(Figures, AThingThatThePartCutsIsNotFoundInIt) {
    const Likelihood wide = Likelihood().disc({128, 60}, 100);
    EXPECT_FALSE(wide.at({300, 200}, {100, 100, 400, 400}, {800, 600}).is_sure) << "at its top";
    EXPECT_TRUE(wide.at({300, 100}, {100, 0, 400, 400}, {800, 600}).is_sure)
        << "the picture's frame may cut it";
}

TEST(Figures, AllOfAPictureIsNoThing) {
    EXPECT_FALSE(Likelihood().disc({128, 128}, 400).in({640, 480}).is_sure);
}

TEST(Figures, WhatFillsThePartIsAGround) {
    const Figures found =
        Likelihood().disc({128, 128}, 200).at({300, 300}, {100, 100, 400, 400}, {800, 600});
    EXPECT_FALSE(found.is_sure);
}

}  // namespace
}  // namespace touchline::testing
