#include "vision/figure/figures.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

/// A likelihood of 0.97 within what is drawn and 0.02 without.
class Likelihood {
  public:
    Likelihood() : map_(256, 256, 0.02F) {}

    Likelihood& disc(cv::Point centre, int radius, float value = 0.97F) {
        cv::circle(map_, centre, radius, cv::Scalar(static_cast<double>(value)), cv::FILLED);
        return *this;
    }

    [[nodiscard]] Figures in(cv::Size picture) const { return figures_of(map_, picture); }

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
                              .disc({180, 150}, 3, 0.1F)  // a hole that is none
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

}  // namespace
}  // namespace touchline::testing
